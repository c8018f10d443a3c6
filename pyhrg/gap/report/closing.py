"""How far the gap closed: figures with what noise alone leaves."""

import numpy as np

from pyhrg.common.pages.markup import paragraph
from pyhrg.common.pages.svg import Scale, decades, number
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.findings.diagnosis import Gap, GapFigure
from pyhrg.gap.report.words import markup_table

WIDTH = 240
UNITS = {"angle_arcsec": ("output angle", "arcsec"), "rate_deg_h": ("rate over 100 s", "deg/h")}
ROLES = {"holdout": "held out", "fit": "fitted to"}
WHITE = 0.01
"""p-value from which a residual counts as white."""


def closing(found: Diagnosed) -> str:
    """A table with drawn figures, and sentences."""
    gap = found.diagnosis.gap
    rows = [row for unit, (what, name) in UNITS.items() for row in _rows(gap, unit, what, name)]
    header = ("Root mean square", "Tests", "before", "after", "noise alone (95 %)", "")
    title = (
        "Drawn: before orange, after blue, noise alone grey. Nothing was fitted to held-out tests"
    )
    return markup_table(title, header, rows) + "".join(
        paragraph(sentence) for sentence in sentences(gap)
    )


def sentences(gap: Gap) -> list[str]:
    """Shrink and whiteness."""
    return [*_shrink(gap), *_whiteness(gap)]


def shrink_ends(figure: GapFigure) -> tuple[float, float]:
    """Per cent of the excess over the floor that is gone, where noise leaves as little, or as much,
    as it may in 95 % of cases."""
    ends = [100 * (figure.before - figure.after) / (figure.before - f) for f in figure.floor_95]
    return min(ends), max(ends)


def _shrink(gap: Gap) -> list[str]:
    figure = gap.holdout_angle_arcsec
    if figure is None:
        return ["No test was held out, so nothing verifies this."]
    if gap.shrink_percent is None:
        return [
            "On the held-out tests the angle's residual was within what noise alone leaves "
            "already before: there is no excess to shrink."
        ]
    low, high = shrink_ends(figure)
    return [
        f"On the held-out tests {gap.shrink_percent:.1f} % of the angle residual's excess over "
        f"the noise is gone ({low:.1f} to {high:.1f} % as the noise may have fallen; over "
        f"100 where less is left than noise leaves on average)."
    ]


def _whiteness(gap: Gap) -> list[str]:
    if gap.whiteness is None:
        return []
    word = "looks white" if gap.whiteness >= WHITE else "is not white: something is left in it"
    return [f"What is left there {word} (Ljung-Box over 10 rows, p = {number(gap.whiteness)})."]


def _rows(gap: Gap, unit: str, what: str, name: str) -> list[tuple[str, ...]]:
    figures = {role: getattr(gap, f"{role}_{unit}") for role in ROLES}
    known = {role: f for role, f in figures.items() if f is not None}
    limits = decades([v for f in known.values() for v in (f.before, f.after, *f.floor_95)])
    return [
        (
            f"{what}, {name}",
            ROLES[role],
            number(f.before),
            number(f.after),
            f"{number(f.floor)} ({number(f.floor_95[0])} to {number(f.floor_95[1])})",
            _drawn(f, limits),
        )
        for role, f in known.items()
    ]


def _drawn(figure: GapFigure, limits: tuple[float, float]) -> str:
    scale = Scale(limits[0], limits[1], 6, WIDTH - 6)
    ends = np.clip([*figure.floor_95, figure.before, figure.after], limits[0], limits[1])
    low, high, before, after = (float(v) for v in scale(ends))
    return (
        f'<svg class="scale" viewBox="0 0 {WIDTH} 16" width="{WIDTH}" aria-hidden="true">'
        f'<path class="axis" d="M6 8H{WIDTH - 6}"/>'
        f'<rect class="noise" x="{low:.1f}" y="2" width="{max(high - low, 1):.1f}" height="12"/>'
        f'<circle class="c1" cx="{before:.1f}" cy="8" r="4.5"/>'
        f'<circle class="c0" cx="{after:.1f}" cy="8" r="4.5"/></svg>'
    )
