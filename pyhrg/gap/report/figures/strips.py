"""Drawings of one or two strips over one axis, each with the 95 % band of noise."""

import html
from collections.abc import Sequence
from dataclasses import dataclass

from pyhrg.common.arrays import Array
from pyhrg.common.pages.svg import Scale, draw_horizontal_ticks, draw_vertical_ticks

LEFT, MARGIN, TOP, GAP, FOOT = 88, 12, 22, 26, 48
"""Space in a drawing, px: left and right of the strips, above the first, between two, below the
last."""
COMMON_SCALE_RATIO = 3.0
"""Strips share one scale where the largest range is below this times the smallest (chosen)."""


@dataclass(frozen=True)
class Strip:
    """Vertical strokes from low to high; a dot where the two are equal.

    label: text above the strip.
    colour: CSS class.
    x, low, high: (m,) in the units of the axes.
    is_joined: whether a line joins the strokes.
    """

    label: str
    colour: str
    x: Array
    low: Array
    high: Array
    is_joined: bool = False


@dataclass(frozen=True)
class Band:
    """Interval around zero that holds noise with 95 % probability.

    x: (m,) centres of the bins.
    half: (m,) half width of the interval.
    width: of a bin.
    """

    x: Array
    half: Array
    width: float


@dataclass(frozen=True)
class Size:
    """Width of a drawing, height of a strip and width of a stroke, px."""

    width: int
    strip: int
    stroke: float


@dataclass(frozen=True)
class Labels:
    """Titles of the axes, and the description that screen readers read."""

    x: str
    y: str
    description: str


def draw_strips(strips: Sequence[Strip], band: Band, size: Size, labels: Labels) -> str:
    """Strips one below the other as SVG. Every strip has at least one point."""
    right = size.width - MARGIN
    ends = [*(s.x for s in strips), band.x - band.width / 2, band.x + band.width / 2]
    low, high = float(min(e.min() for e in ends)), float(max(e.max() for e in ends))
    room = (high - low) / 100 or 1.0
    across = Scale(low - room, high + room, LEFT, right, log=False)
    ranges = _compute_ranges(strips, band)
    bottom = TOP + len(strips) * (size.strip + GAP) - GAP
    parts = [draw_horizontal_ticks(across, TOP, bottom)]
    for i, (strip, span) in enumerate(zip(strips, ranges, strict=True)):
        top = TOP + i * (size.strip + GAP)
        up = Scale(*span, top + size.strip, top, log=False)
        parts.append(_draw_strip(strip, band, across, up, size.stroke))
    middle = (TOP + bottom) / 2
    return (
        f'<svg viewBox="0 0 {size.width} {bottom + FOOT}" role="img" '
        f'aria-label="{html.escape(labels.description)}">{"".join(parts)}'
        f'<text x="{(LEFT + right) / 2:g}" y="{bottom + FOOT - 6}" text-anchor="middle">'
        f'{html.escape(labels.x)}</text><text transform="translate(15 {middle:g})rotate(-90)" '
        f'text-anchor="middle">{html.escape(labels.y)}</text></svg>'
    )


def _compute_ranges(strips: Sequence[Strip], band: Band) -> list[tuple[float, float]]:
    half = float(band.half.max())
    ranges = [(min(-half, float(s.low.min())), max(half, float(s.high.max()))) for s in strips]
    widths = [high - low for low, high in ranges]
    if max(widths) < COMMON_SCALE_RATIO * min(widths):
        ranges = [(min(r[0] for r in ranges), max(r[1] for r in ranges))] * len(ranges)
    return [
        (low - room, high + room) for low, high in ranges for room in [(high - low) / 20 or 1.0]
    ]


def _draw_strip(strip: Strip, band: Band, across: Scale, up: Scale, stroke: float) -> str:
    x, low, high = across(strip.x), up(strip.low), up(strip.high)
    points = zip(x, low, high, strict=True)
    steps = (f"{a:.1f} {b:.1f}V{c:.1f}" for a, b, c in points)
    strokes = "M" + ("L" if strip.is_joined else "M").join(steps)
    start, end, top, bottom = across.start, across.end, up.end, up.start
    return (
        f"{draw_vertical_ticks(up, start, end)}"
        f'<path class="axis" d="M{start:g} {top:g}V{bottom:g}H{end:g}"/>'
        f'<path class="noise" d="{_draw_band(band, across, up)}"/>'
        f'<path class="strokes {strip.colour}" stroke-width="{stroke:g}" d="{strokes}"/>'
        f'<text class="strip {strip.colour}" x="{start:g}" y="{top - 6:g}">'
        f"{html.escape(strip.label)}</text>"
    )


def _draw_band(band: Band, across: Scale, up: Scale) -> str:
    sides = across(band.x - band.width / 2), across(band.x + band.width / 2)
    corners = zip(*sides, up(-band.half), up(band.half), strict=True)
    return "".join(f"M{a:.1f} {c:.1f}H{b:.1f}V{d:.1f}H{a:.1f}z" for a, b, c, d in corners)
