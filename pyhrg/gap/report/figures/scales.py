"""The gap in deviations of the noise: test by channel, a table a time scale."""

import html
from collections.abc import Sequence

from pyhrg.common.pages.svg import number
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.findings.quantity import Size
from pyhrg.gap.report.words import CHANNELS, markup_table

LEAD = (
    "Root of the power that residuals, averaged over a time, have beyond the believed noise's, in "
    "its deviations: before → after; 0 where they have none."
)


def scales(found: Diagnosed) -> str:
    """Folded, the scale with most of the gap open."""
    sizes = found.diagnosis.sizes
    if not sizes:
        return ""
    every = sorted({s.scale_s for s in sizes})
    by_scale = {scale: [s for s in sizes if s.scale_s == scale] for scale in every}
    largest = max(every, key=lambda scale: sum(s.before**2 for s in by_scale[scale]))
    folds = [_fold(scale, own, scale == largest) for scale, own in by_scale.items()]
    return f"<h3>In deviations of the noise</h3><p>{LEAD}</p>{''.join(folds)}"


def _fold(scale: float, sizes: Sequence[Size], is_open: bool) -> str:
    summary = f"<summary>Averages over {scale:g} s</summary>"
    return f"<details{' open' if is_open else ''}>{summary}{_table(sizes)}</details>"


def _table(sizes: Sequence[Size]) -> str:
    cells = {(s.test, s.channel): f"{number(s.before)} → {number(s.after)}" for s in sizes}
    rows = [
        (html.escape(test), *(cells.get((test, channel), "–") for channel in CHANNELS))
        for test in dict.fromkeys(s.test for s in sizes)
    ]
    header = ("Test", *(words.capitalize() for words in CHANNELS.values()))
    return markup_table("Tests that were fitted to", header, rows)
