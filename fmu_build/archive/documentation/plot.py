"""A figure of a run, as SVG."""

from html import escape

import numpy as np
from numpy.typing import NDArray

WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 900, 300, 70, 40, 20

COLOURS = ("#265494", "#de781f", "#4c9a6a")


def draw_lines(time: NDArray[np.float64], lines: dict[str, NDArray[np.float64]], unit: str) -> str:
    """Lines over time (n,) in s: values (n,) in `unit` by the label at the line's end."""
    every = np.concatenate([*lines.values(), [0.0]])
    low, high = float(every.min()), float(every.max())
    span = (high - low) or 1.0
    right = WIDTH - 170

    def at(t: float, value: float) -> str:
        x = LEFT + (t - time[0]) / (time[-1] - time[0]) * (right - LEFT)
        y = HEIGHT - BOTTOM - (value - low) / span * (HEIGHT - BOTTOM - TOP)
        return f"{x:.1f},{y:.1f}"

    parts = [
        f'<svg class="plot" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        f'role="img" aria-label="{escape(", ".join(lines))} over time">',
        f'<path class="axis" d="M{at(time[0], 0)} L{at(time[-1], 0)}"/>',
    ]
    for t in np.linspace(time[0], time[-1], 6):
        x = at(t, low).split(",")[0]
        parts.append(f'<text class="tick" x="{x}" y="{HEIGHT - 12}">{t:g} s</text>')
    for value in sorted({low, 0.0, high}):
        y = at(time[0], value).split(",")[1]
        parts.append(f'<text class="level" x="{LEFT - 8}" y="{y}">{value:.3g} {unit}</text>')
    for (label, values), colour in zip(lines.items(), COLOURS, strict=False):
        points = " ".join(at(t, v) for t, v in zip(time, values, strict=True))
        end = at(time[-1], values[-1]).split(",")
        parts.append(f'<polyline points="{points}" stroke="{colour}"/>')
        parts.append(
            f'<text class="label" x="{float(end[0]) + 6:.1f}" y="{end[1]}" style="fill: {colour}">'
            f"{escape(label)}</text>"
        )
    return "\n".join([*parts, "</svg>"])
