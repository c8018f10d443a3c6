"""Drawings of two strips over one axis: before and after, each with the band of noise alone."""

import html
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.pages.svg import Scale, ticks_across, ticks_up

Array = NDArray[np.float64]

LEFT, MARGIN, TOP, GAP, FOOT = 88, 12, 22, 26, 48
"""Of a drawing: left and right margin, above the first strip, between strips, below the last."""
ALIKE = 3.0
"""Strips whose ranges differ by less have the same."""


@dataclass(frozen=True)
class Strip:
    """Strokes from low to high; a dot where they are the same.

    label: above it.
    joined: whether strokes follow each other in a line.
    colour: CSS class.
    x, low, high: (m,).
    """

    label: str
    colour: str
    x: Array
    low: Array
    high: Array
    joined: bool = False


@dataclass(frozen=True)
class Band:
    """What noise alone stays within, (m,) either way around zero.

    width: of a bin that x is the middle of.
    """

    x: Array
    half: Array
    width: float


@dataclass(frozen=True)
class Size:
    """Of a drawing, user units; stroke: width of its strokes."""

    width: int
    strip: int
    stroke: float


@dataclass(frozen=True)
class Labels:
    """Of a drawing; told: what it shows, to those who don't see it."""

    x: str
    y: str
    told: str


def drawing(strips: Sequence[Strip], band: Band, size: Size, labels: Labels) -> str:
    """The whole SVG; strips without a point are left out by the caller."""
    right = size.width - MARGIN
    ends = [*(s.x for s in strips), band.x - band.width / 2, band.x + band.width / 2]
    low, high = float(min(e.min() for e in ends)), float(max(e.max() for e in ends))
    room = (high - low) / 100 or 1.0
    across = Scale(low - room, high + room, LEFT, right, log=False)
    ranges = _ranges(strips, band)
    bottom = TOP + len(strips) * (size.strip + GAP) - GAP
    parts = [ticks_across(across, TOP, bottom)]
    for i, (strip, span) in enumerate(zip(strips, ranges, strict=True)):
        top = TOP + i * (size.strip + GAP)
        up = Scale(*span, top + size.strip, top, log=False)
        parts.append(_strip(strip, band, across, up, size.stroke))
    middle = (TOP + bottom) / 2
    return (
        f'<svg viewBox="0 0 {size.width} {bottom + FOOT}" role="img" '
        f'aria-label="{html.escape(labels.told)}">{"".join(parts)}'
        f'<text x="{(LEFT + right) / 2:g}" y="{bottom + FOOT - 6}" text-anchor="middle">'
        f'{html.escape(labels.x)}</text><text transform="translate(15 {middle:g})rotate(-90)" '
        f'text-anchor="middle">{html.escape(labels.y)}</text></svg>'
    )


def _ranges(strips: Sequence[Strip], band: Band) -> list[tuple[float, float]]:
    half = float(band.half.max())
    found = [(min(-half, float(s.low.min())), max(half, float(s.high.max()))) for s in strips]
    widths = [high - low for low, high in found]
    if max(widths) < ALIKE * min(widths):
        found = [(min(f[0] for f in found), max(f[1] for f in found))] * len(found)
    return [(low - room, high + room) for low, high in found for room in [(high - low) / 20 or 1.0]]


def _strip(strip: Strip, band: Band, across: Scale, up: Scale, stroke: float) -> str:
    x, low, high = across(strip.x), up(strip.low), up(strip.high)
    points = zip(x, low, high, strict=True)
    steps = (f"{a:.1f} {b:.1f}V{c:.1f}" for a, b, c in points)
    strokes = "M" + ("L" if strip.joined else "M").join(steps)
    start, end, top, bottom = across.start, across.end, up.end, up.start
    return (
        f'{ticks_up(up, start, end)}<path class="axis" d="M{start:g} {top:g}V{bottom:g}H{end:g}"/>'
        f'<path class="noise" d="{_outline(band, across, up)}"/>'
        f'<path class="strokes {strip.colour}" stroke-width="{stroke:g}" d="{strokes}"/>'
        f'<text class="strip {strip.colour}" x="{start:g}" y="{top - 6:g}">'
        f"{html.escape(strip.label)}</text>"
    )


def _outline(band: Band, across: Scale, up: Scale) -> str:
    """A rectangle a bin."""
    sides = across(band.x - band.width / 2), across(band.x + band.width / 2)
    corners = zip(*sides, up(-band.half), up(band.half), strict=True)
    return "".join(f"M{a:.1f} {c:.1f}H{b:.1f}V{d:.1f}H{a:.1f}z" for a, b, c, d in corners)
