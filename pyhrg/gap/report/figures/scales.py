"""The gap in standard deviations of the noise: a table of tests by channels for each time scale."""

import html
from collections.abc import Sequence

from pyhrg.common.pages.svg import format_number
from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.findings.quantity import Size
from pyhrg.gap.report.words import CHANNELS, build_table

LEAD = (
    "Root of the power that the averaged residual has beyond the nominal noise, in standard "
    "deviations of that noise: nominal gyro → identified gyro; 0 where there is no excess."
)


def build_scales(result: CampaignDiagnosis) -> str:
    """A folded table for each time scale; that with the largest gap is open."""
    sizes = result.diagnosis.sizes
    if not sizes:
        return ""
    scales = sorted({s.scale_s for s in sizes})
    by_scale = {scale: [s for s in sizes if s.scale_s == scale] for scale in scales}
    largest = max(scales, key=lambda scale: sum(s.before**2 for s in by_scale[scale]))
    folds = [_build_fold(scale, own, scale == largest) for scale, own in by_scale.items()]
    return f"<h3>In standard deviations of the noise</h3><p>{LEAD}</p>{''.join(folds)}"


def _build_fold(scale: float, sizes: Sequence[Size], is_open: bool) -> str:
    summary = f"<summary>Averages over {scale:g} s</summary>"
    return f"<details{' open' if is_open else ''}>{summary}{_build_table(sizes)}</details>"


def _build_table(sizes: Sequence[Size]) -> str:
    cells = {
        (s.test, s.channel): f"{format_number(s.before)} → {format_number(s.after)}" for s in sizes
    }
    rows = [
        (html.escape(test), *(cells.get((test, channel), "–") for channel in CHANNELS))
        for test in dict.fromkeys(s.test for s in sizes)
    ]
    header = ("Test", *(words.capitalize() for words in CHANNELS.values()))
    return build_table("Fitted tests", header, rows)
