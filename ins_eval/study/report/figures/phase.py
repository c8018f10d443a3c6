"""The phase diagram: a panel for each bench test, a cell for each turning and ratio."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ins_eval.study.report.figures.parts import (
    Panel,
    choose_colour,
    draw_axes,
    join_panels,
    make_class_legend,
)
from ins_eval.study.study_data import PHASE_KEY, StudyData
from pyhrg.common.pages import svg
from pyhrg.common.pages.markup import make_paragraph

TRUTH = 0.5
"""Share of flights from which on a cell is framed: a test tells the truth more often than not."""


def render_phase_diagram(data: StudyData) -> str:
    """Panels with common axes, and what they show."""
    diagram = data.about.get(PHASE_KEY)
    if not diagram:
        return make_paragraph("This study has no gyros that are calibrated at the mean.")
    rows = diagram["rows"]
    tests = list(dict.fromkeys(row["test"] for row in rows))
    lead = (
        "Linear model, no mounting, no accelerometers: percent of flights whose error each test "
        f"predicts within a factor of {diagram['factor']:g}, in {diagram['hours']:g} h of steady "
        f"turning in heading ({rows[0]['triads']} triads, their maps scaled, from "
        f"{diagram['start_angles']} start angles each; seed {data.about['seed']}). Fixed position "
        "and circumference have the constant of the manoeuvre. Cells from "
        f"{TRUTH:.0%} on are framed. Dots: the missions of this study, by the pattern that turns "
        "most, with the median of its judged gyros."
    )
    panels = (
        Panel(title=test, body=_draw(data, test, [r for r in rows if r["test"] == test]))
        for test in tests
    )
    return make_paragraph(lead) + make_class_legend(data) + join_panels(panels)


def _draw(data: StudyData, test: str, rows: Sequence[Mapping[str, Any]]) -> str:
    turning, ratios = (
        np.unique([row[key] for row in rows]) for key in ("turning_rev_per_h", "map_over_noise")
    )
    (x, wide), (y, high) = (
        (scale(*_widen(values)), np.sqrt(values[1] / values[0]))
        for scale, values in (
            (svg.make_horizontal_scale, turning),
            (svg.make_vertical_scale, ratios),
        )
    )
    cells = "".join(_draw_cell(x, y, row, float(wide), float(high)) for row in rows)
    places = data.about[PHASE_KEY]["missions"]
    marks = "".join(
        f'<g class="{choose_colour(data, name)}"><circle cx="{x(at):.1f}" cy="{y(ratio):.1f}" '
        'r="6" fill="currentColor" stroke="var(--back)" stroke-width="2"/></g>'
        for name, (at, ratio) in places.items()
        if x.low <= at <= x.high and y.low <= ratio <= y.high
    )
    return draw_axes(
        x,
        y,
        ("turning, pattern revolutions per hour", "bias map / in-run stability"),
        cells + marks,
        f"{test}: percent of flights predicted, by turning and by map over noise",
    )


def _widen(values: np.ndarray) -> tuple[float, float]:
    """Range of cells around values in geometric progression."""
    half = np.sqrt(values[1] / values[0])
    return float(values[0] / half), float(values[-1] * half)


def _draw_cell(x: svg.Scale, y: svg.Scale, row: Mapping[str, Any], wide: float, high: float) -> str:
    """A cell: the darker, the more flights; its number is their percentage."""
    at, ratio, share = row["turning_rev_per_h"], row["map_over_noise"], row["share"]
    left, right = float(x(at / wide)), float(x(at * wide))
    top, bottom = float(y(ratio * high)), float(y(ratio / high))
    frame = ' stroke="var(--text)"' if share >= TRUTH else ""
    return (
        f'<g class="c0"><rect x="{left + 1:.1f}" y="{top + 1:.1f}" width="{right - left - 2:.1f}" '
        f'height="{bottom - top - 2:.1f}" fill="currentColor" fill-opacity="{0.6 * share:.2f}"'
        f'{frame}/></g><text class="cell" x="{(left + right) / 2:.1f}" '
        f'y="{(top + bottom) / 2 + 4:.1f}" text-anchor="middle">{100 * share:.0f}</text>'
    )
