"""The figure of the identification tests: output rate against pattern angle, with the fit."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.figures import COLOURS, finish_axes
from pyhrg.bench.readings.output_rows import Rows, Terms
from pyhrg.common.units import DEG, DEG_PER_H

POINTS = 60
"""Points a curve; rows are averaged to that number."""


def draw_terms(
    figure: Figure, title: str, stretches: Sequence[Rows], terms: Terms, labels: Sequence[str]
) -> None:
    """Means of rows as dots, the fit as lines; stretches as they were given to the fit."""
    axes = figure.add_subplot(title=title, xlim=(0, 90))
    shown: dict[str, str] = {}
    for rows, part, label in zip(stretches, terms.parts, labels, strict=True):
        fresh = label not in shown
        colour = shown.setdefault(label, COLOURS[len(shown) % len(COLOURS)])
        model = np.sum([terms.fit.value(n) * part.columns[n] for n in terms.fit.names], axis=0)
        size = max(1, len(part) // POINTS)
        bins = np.arange(0, len(part) - size + 1, size)
        span = size * part.interval * DEG_PER_H
        measured, expected = (
            np.array([np.sum(values[b : b + size]) for b in bins]) / span
            for values in (part.values, model)
        )
        angle = np.array([np.mean(rows.ends("wave_angle")[1 + b : 1 + b + size]) for b in bins])
        angle %= np.pi / 2
        order = np.argsort(angle)
        axes.plot(angle / DEG, measured, ".", color=colour, ms=4, label=label if fresh else None)
        axes.plot(angle[order] / DEG, expected[order], "-", color=colour, lw=0.8, alpha=0.7)
    finish_axes(axes, "pattern angle modulo 90 deg, deg", "output rate error, deg/h")
