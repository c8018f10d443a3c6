"""Where the gap is: a heat map of tests by channels, bars by coordinate, and tables of its size in
standard deviations of the noise."""

import html
from collections.abc import Sequence

from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.svg import format_number
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.findings.localisation import Place, sum_shares
from pyhrg.gap.findings.quantity import Size
from pyhrg.gap.replay.observations import CHANNEL_WORDS
from pyhrg.gap.report.words import (
    COORDINATES,
    NOTHING_BEYOND,
    build_table,
    format_percent,
    show_share,
)

LISTED_BARS = 14
"""Bars that are shown; the others are summed up in one row."""
SCALES_LEAD = (
    "Root of the power that the averaged residual has beyond the nominal noise, in standard "
    "deviations of that noise: nominal gyro → identified gyro; 0 where there is no excess."
)


def build_places(result: CampaignDiagnosis) -> str:
    """A heat map and bars of the shares of the residual's power beyond tolerances and noise."""
    where = result.diagnosis.where
    if not where:
        return make_paragraph(NOTHING_BEYOND)
    tests = [t.test.id for t in result.tests if not t.test.is_holdout]
    return _build_map(where, tests) + _build_bars(where)


def _build_map(where: Sequence[Place], tests: Sequence[str]) -> str:
    def share(test: str | None, channel: str | None) -> float:
        return sum(
            w.share for w in where if test in (None, w.test) and channel in (None, w.channel)
        )

    header = ("Test", *(words.capitalize() for words in CHANNEL_WORDS.values()), "All channels")
    rows = [
        (
            html.escape(test),
            *(_format_cell(share(test, c)) for c in CHANNEL_WORDS),
            _format_total(share(test, None)),
        )
        for test in tests
    ]
    totals = (
        *(_format_total(share(None, c)) for c in CHANNEL_WORDS),
        _format_total(share(None, None)),
    )
    rows.append(("All tests", *totals))
    title = "Share of the residual's power beyond tolerances and noise, on the fitted tests"
    return f'<div class="heat">{build_table(title, header, rows)}</div>'


def _format_cell(share: float) -> str:
    if not share:
        return '<span class="none">–</span>'
    # square root, because the perceived size of an area grows more slowly than the area
    return f'<span class="cell" style="--part:{share**0.5:.3f}">{format_percent(share)}</span>'


def _format_total(share: float) -> str:
    text = format_percent(share) if share < 0.9995 else "100\u00a0%"
    return f"<b>{text}</b>" if share else "–"


def _build_bars(where: Sequence[Place]) -> str:
    shares = sum_shares(where, lambda place: (place.channel, place.coordinate, place.harmonic))
    order = sorted(shares.items(), key=lambda pair: -pair[1])
    rows = [(_format_place(*key), *show_share(share)) for key, share in order[:LISTED_BARS]]
    others = sum(share for _, share in order[LISTED_BARS:])
    if others:
        count = f"{len(order) - LISTED_BARS} others"
        rows.append((count, *show_share(others)))
    title = "The same power by coordinate, with harmonics of angles that move by a period of them"
    return build_table(title, ("Channel and coordinate", "Share", ""), rows)


def _format_place(channel: str, coordinate: str, harmonic: int | None) -> str:
    suffix = "" if harmonic is None else f", harmonic {harmonic}"
    return f"{CHANNEL_WORDS[channel]}: {COORDINATES[coordinate]}{suffix}"


def build_scales(result: CampaignDiagnosis) -> str:
    """A folded table for each time scale; that with the largest gap is open."""
    sizes = result.diagnosis.sizes
    if not sizes:
        return ""
    scales = sorted({s.scale_s for s in sizes})
    by_scale = {scale: [s for s in sizes if s.scale_s == scale] for scale in scales}
    largest = max(scales, key=lambda scale: sum(s.before**2 for s in by_scale[scale]))
    folds = [
        f"<details{' open' if scale == largest else ''}>"
        f"<summary>Averages over {scale:g} s</summary>{_build_size_table(own)}</details>"
        for scale, own in by_scale.items()
    ]
    return f"<h3>In standard deviations of the noise</h3><p>{SCALES_LEAD}</p>{''.join(folds)}"


def _build_size_table(sizes: Sequence[Size]) -> str:
    cells = {
        (s.test, s.channel): f"{format_number(s.before)} → {format_number(s.after)}" for s in sizes
    }
    rows = [
        (html.escape(test), *(cells.get((test, channel), "–") for channel in CHANNEL_WORDS))
        for test in dict.fromkeys(s.test for s in sizes)
    ]
    header = ("Test", *(words.capitalize() for words in CHANNEL_WORDS.values()))
    return build_table("Fitted tests", header, rows)
