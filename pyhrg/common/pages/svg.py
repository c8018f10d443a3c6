"""Small SVG figures: scales, frames with ticks, points as one path."""

import html
import math
from dataclasses import dataclass

import numpy as np
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from pyhrg.common.arrays import Array

WIDTH, HEIGHT = 420, 380
LEFT, RIGHT, TOP, BOTTOM = 74, 400, 10, 328
"""Size of a panel and the edges of the plot in it, user units."""
GRID_DIVISIONS = 2
"""Points lie on a grid of this many divisions of a user unit."""
MIN_WIDTH = 1e-12
"""Width of an interval over its largest end below which it is rounding: that of sums of thousands
of doubles."""


@dataclass(frozen=True)
class Scale:
    """A map of values, `low` to `high`, onto user units, `start` to `end`; logarithmic if `log`."""

    low: float
    high: float
    start: float
    end: float
    log: bool = True

    def __call__(self, values: ArrayLike) -> Array:
        """Places of values, user units."""
        v, low, high = (self._transform(x) for x in (values, self.low, self.high))
        return np.asarray(self.start + (v - low) / (high - low) * (self.end - self.start))

    def _transform(self, values: ArrayLike) -> Array:
        v = np.asarray(values, dtype=float)
        return np.log10(v) if self.log else v

    @property
    def ticks(self) -> list[float]:
        """Values of the ticks: powers of ten, or round numbers."""
        if not self.log:
            at = MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]).tick_values(self.low, self.high)
            return [float(t) for t in at if self.low <= t <= self.high]
        first, last = round(math.log10(self.low)), round(math.log10(self.high))
        return [10.0**p for p in range(first, last + 1, max(1, (last - first) // 6))]


def find_decades(values: ArrayLike) -> tuple[float, float]:
    """The powers of ten around the positive values; 1 and 10 if there are none."""
    v = np.asarray(values, dtype=float)
    v = v[np.isfinite(v) & (v > 0)]
    if not len(v):
        return 1.0, 10.0
    low, high = math.floor(math.log10(v.min())), math.ceil(math.log10(v.max()))
    return 10.0**low, 10.0 ** max(high, low + 1)


def make_horizontal_scale(low: float, high: float, log: bool = True) -> Scale:
    """A scale along the plot's width."""
    return Scale(low, high, LEFT, RIGHT, log)


def make_vertical_scale(low: float, high: float, log: bool = True) -> Scale:
    """A scale along the plot's height."""
    return Scale(low, high, BOTTOM, TOP, log)


def draw_frame(x: Scale, y: Scale, x_label: str, y_label: str) -> str:
    """Grid, ticks and labels; the label of a logarithmic axis says so."""
    x_label, y_label = (
        f"{text}, log axis" if scale.log else text for scale, text in ((x, x_label), (y, y_label))
    )
    middle = (TOP + BOTTOM) / 2
    return (
        f"{draw_horizontal_ticks(x, TOP, BOTTOM)}{draw_vertical_ticks(y, LEFT, RIGHT)}"
        f'<path class="axis" d="M{LEFT} {TOP}V{BOTTOM}H{RIGHT}"/>'
        f'<text x="{(LEFT + RIGHT) / 2:g}" y="{HEIGHT - 8}" text-anchor="middle">'
        f'{html.escape(x_label)}</text><text transform="translate(15 {middle:g})rotate(-90)" '
        f'text-anchor="middle">{html.escape(y_label)}</text>'
    )


def draw_horizontal_ticks(x: Scale, top: float, bottom: float) -> str:
    """Grid and labels of a scale that runs along the width, from a plot's top to its bottom."""
    return "".join(
        f'<path class="grid" d="M{x(t):.4g} {top:g}V{bottom:g}"/><text class="tick" '
        f'x="{x(t):.4g}" y="{bottom + 20:g}" text-anchor="middle">{_format_short(t)}</text>'
        for t in x.ticks
    )


def draw_vertical_ticks(y: Scale, left: float, right: float) -> str:
    """Grid and labels of a scale that runs along the height, from a plot's left to its right."""
    return "".join(
        f'<path class="grid" d="M{left:g} {y(t):.4g}H{right:g}"/><text class="tick" '
        f'x="{left - 6:g}" y="{y(t) + 5:.4g}" text-anchor="end">{_format_short(t)}</text>'
        for t in y.ticks
    )


def _format_short(value: float) -> str:
    """Format a tick's value: 0.1, 10, −100k, 1M."""
    if abs(value) >= 1e6:
        return f"{format_number(value / 1e6)}M"
    return f"{format_number(value / 1000)}k" if abs(value) >= 1000 else format_number(value)


def format_points(x: Array, y: Array) -> str:
    """Data of a path of dots (the round caps of its stroke) on a grid, each drawn once, at x and y
    (n,), user units."""
    grid = np.unique(np.rint(GRID_DIVISIONS * np.stack([x, y], axis=1)).astype(int), axis=0)
    steps = np.diff(grid, axis=0, prepend=np.zeros((1, 2), dtype=int))
    return "".join(f"m{dx}{dy:{'' if dy < 0 else ' '}}h0" for dx, dy in steps.tolist())


def draw_line(x: Array, y: Array) -> str:
    """Data of a path through points, user units."""
    return "M" + "L".join(f"{a:.1f} {b:.1f}" for a, b in zip(x, y, strict=True))


def format_number(value: float, digits: int = 3) -> str:
    """Format a number with a few significant digits: 0.012, 3.4, 12,300, 2.5e+06."""
    if not math.isfinite(value):
        return "–" if math.isnan(value) else ("∞" if value > 0 else "−∞")
    if value == 0 or 1e-3 <= abs(value) < 1e6:
        decimals = digits - 1 - math.floor(math.log10(abs(value))) if value else 0
        text = f"{round(value, decimals):,.{max(decimals, 0)}f}"
        text = text.rstrip("0").rstrip(".") if "." in text else text
    else:
        text = f"{value:.{digits}g}"
    return text.replace("-", "−")


def format_estimate(value: float, low: float, high: float) -> tuple[str, str, str]:
    """Format a number and the ends of its interval to two digits of the interval's width, such as
    0.965, 0.918 and 0.983; with three digits each where there is no interval, or one so narrow that
    it is the arithmetic's rounding."""
    width = high - low
    largest = max(abs(value), abs(low), abs(high))
    if not (math.isfinite(width) and math.isfinite(value) and width > MIN_WIDTH * largest):
        return format_number(value), format_number(low), format_number(high)
    if 1e-4 <= largest < 1e6:
        decimals = max(1 - math.floor(math.log10(width)), 0)
        rounded = (round(number, decimals) + 0.0 for number in (value, low, high))
        texts = [f"{number:,.{decimals}f}" for number in rounded]
    else:
        digits = max(math.ceil(math.log10(largest / width)), 0) + 2
        texts = [f"{number:.{digits}g}" for number in (value, low, high)]
    middle, *ends = (text.replace("-", "−") for text in texts)
    return middle, ends[0], ends[1]


def format_interval(value: float, low: float, high: float) -> str:
    """A number with its interval, such as 0.965 (0.918 to 0.983), as `format_estimate`; an exact
    number alone."""
    if low == high:
        return format_number(value)
    middle, *ends = format_estimate(value, low, high)
    return f"{middle} ({' to '.join(ends)})"
