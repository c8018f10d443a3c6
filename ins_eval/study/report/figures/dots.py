"""Flights as dots on log axes; one path for each calibration and mission class."""

import pandas as pd

from ins_eval.study.report.figures.filters import choose_colour, make_filter_attributes
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
    attributes: str = "",
) -> str:
    """Dots of one colour, in the units of `scale_dots`."""
    (column_x, across), (column_y, up) = x, y
    points = svg.format_points(across(rows[column_x]), up(rows[column_y]))
    return f'<path class="dots {colour}"{attributes} d="{points}"/>'


def scale_dots(paths: str, diameter: float) -> str:
    """Paths of dots with this diameter, user units."""
    size = svg.GRID_DIVISIONS * diameter
    return f'<g transform="scale({1 / svg.GRID_DIVISIONS:g})" stroke-width="{size:g}">{paths}</g>'
