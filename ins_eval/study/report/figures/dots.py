"""Flights as dots on log axes, one path for each calibration and mission class: predicted against
flown error, and bench figures of single gyros against their rms error over power-on angles, which
is linear.
"""

import html

import numpy as np
import pandas as pd

from ins_eval.study.report.distances import NMI
from ins_eval.study.report.figures.parts import (
    Panel,
    choose_colour,
    draw_axes,
    draw_equality,
    join_panels,
    make_class_legend,
    make_filter_attributes,
)
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg

KEYS = [c.CALIBRATION, c.CLASS]
SMALL, LARGE = 2.5, 5.0
"""Diameters of dots, user units: for more flights than `MANY`, and for fewer. Chosen."""
MANY = 3000


def select_positive(rows: pd.DataFrame, x: str, y: str) -> pd.DataFrame:
    """Rows that log axes can show."""
    return rows[(rows[x] > 0) & (rows[y] > 0)]


def draw_dots(
    data: StudyData, rows: pd.DataFrame, x: tuple[str, svg.Scale], y: tuple[str, svg.Scale]
) -> str:
    """Dots of rows with positive values.

    Args:
        data: the study, for the colours.
        rows: rows with the columns `KEYS` and both columns that are drawn.
        x, y: column and scale.
    """
    paths = "".join(
        draw_path(
            flights,
            x,
            y,
            choose_colour(data, mission_class),
            make_filter_attributes(mission_class, calibration),
        )
        for (calibration, mission_class), flights in rows.groupby(KEYS, sort=True)
    )
    return scale_dots(paths, SMALL if len(rows) > MANY else LARGE)


def draw_path(
    rows: pd.DataFrame,
    x: tuple[str, svg.Scale],
    y: tuple[str, svg.Scale],
    colour: str,
    attributes: str,
) -> str:
    """Dots of one colour, in the units of `scale_dots`."""
    (column_x, across), (column_y, up) = x, y
    points = svg.format_points(across(rows[column_x]), up(rows[column_y]))
    return f'<path class="dots {colour}"{attributes} d="{points}"/>'


def scale_dots(paths: str, diameter: float) -> str:
    """Paths of dots with this diameter, user units."""
    size = svg.GRID_DIVISIONS * diameter
    return f'<g transform="scale({1 / svg.GRID_DIVISIONS:g})" stroke-width="{size:g}">{paths}</g>'


STABILITY = "bias stability, deg/h"
RANKED_BY = {
    c.FIXED_RULE: (c.GYROS_FIXED, "Fixed-position stability", STABILITY),
    c.TURN_ON_ANYWHERE: (
        c.GYROS_TURN_ON_ANYWHERE,
        c.FIGURE_TITLES[c.TURN_ON_ANYWHERE],
        "repeatability, deg/h",
    ),
    c.CIRCUMFERENCE_RULE: (c.GYROS_CIRCUMFERENCE, "Full-circumference stability", STABILITY),
    c.FITTED_MAP: (c.GYROS_FITTED, "Fitted map", f"predicted rms, {NMI}"),
}
"""Column, title and axis of each bench figure, by the predictor whose rank correlation it shows."""


def render_ranking(data: StudyData) -> str:
    """A panel for each bench figure."""
    return join_panels(_make_ranking_panel(data, predictor) for predictor in RANKED_BY)


def _make_ranking_panel(data: StudyData, predictor: str) -> Panel:
    column, title, axis = RANKED_BY[predictor]
    gyros = data.table[[*KEYS, column, c.GYROS_LINEAR]].explode([column, c.GYROS_LINEAR])
    gyros = gyros.astype({column: float, c.GYROS_LINEAR: float})
    gyros = select_positive(gyros, column, c.GYROS_LINEAR)
    x, y = (
        svg.make_horizontal_scale(*svg.find_decades(gyros[column])),
        svg.make_vertical_scale(*svg.find_decades(gyros[c.GYROS_LINEAR])),
    )
    return Panel(
        title=title,
        body=draw_axes(
            x,
            y,
            (axis, f"linear rms error, {NMI}"),
            draw_dots(data, gyros, (column, x), (c.GYROS_LINEAR, y)),
            f"{title} against rms error, linear model, {len(gyros)} gyros and missions",
        ),
        notes=[f'<span class="live">{len(gyros):,} gyros in missions</span>'],
        attributes=f' data-panel="rank_{predictor}"',
    )


def render_scatter(data: StudyData) -> str:
    """Panels with common axes."""
    shown = [c.FLOWN_RADIAL, *(p.median for p in c.PREDICTORS)]
    limits = svg.find_decades(np.concatenate([data.table[column] for column in shown]))
    panels = (_make_scatter_panel(data, predictor, limits) for predictor in c.PREDICTORS)
    return make_class_legend(data) + join_panels(panels, ' id="predictions"')


def _make_scatter_panel(
    data: StudyData, predictor: c.Predictor, limits: tuple[float, float]
) -> Panel:
    rows = select_positive(data.table, predictor.median, c.FLOWN_RADIAL)
    return Panel(
        title=predictor.title,
        body=_draw_scatter(data, rows, predictor, limits)
        if len(rows)
        else "<p>No predictions.</p>",
        notes=[
            f'<span class="weak">{html.escape(predictor.what)}</span>',
            f'<span class="live">{len(rows):,} of {len(data.table):,} flights</span>',
        ],
        attributes=f' data-panel="{predictor.key}"',
    )


def _draw_scatter(
    data: StudyData, rows: pd.DataFrame, predictor: c.Predictor, limits: tuple[float, float]
) -> str:
    x, y = svg.make_horizontal_scale(*limits), svg.make_vertical_scale(*limits)
    dots = draw_dots(data, rows, (predictor.median, x), (c.FLOWN_RADIAL, y))
    return draw_axes(
        x,
        y,
        (f"predicted, {NMI}", f"flown, {NMI}"),
        f'{draw_equality(x, y)}{dots}<circle class="mark" r="7" visibility="hidden"/>',
        f"{predictor.title}: flown against predicted horizontal error, {len(rows)} flights. "
        "Arrow keys step through them.",
        f' tabindex="0" data-x="{predictor.median}" data-y="{c.FLOWN_RADIAL}" '
        f'data-plot="{svg.LEFT} {svg.RIGHT} {svg.BOTTOM} {svg.TOP}" '
        f'data-range="{limits[0]:g} {limits[1]:g}"',
    )
