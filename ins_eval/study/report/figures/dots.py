"""Flights as dots on log axes: a path a calibration, half and mission class."""

import pandas as pd

from ins_eval.study.report.figures.marks import colour, marked
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg

KEYS = [c.CALIBRATION, c.HALF, c.CLASS]
SMALL, LARGE, MANY = 2.5, 5.0, 3000
"""Diameters of dots, user units: of more than MANY, and of fewer."""


def positive(rows: pd.DataFrame, x: str, y: str) -> pd.DataFrame:
    """Those that log axes can show."""
    return rows[(rows[x] > 0) & (rows[y] > 0)]


def dots(
    result: StudyResult, rows: pd.DataFrame, x: tuple[str, svg.Scale], y: tuple[str, svg.Scale]
) -> str:
    """Of rows that are `positive`.

    Args:
        rows: of `KEYS` and both columns.
        x, y: column and scale.
    """
    (column_x, across), (column_y, up) = x, y
    groups = "".join(
        f'<path class="dots {colour(result, mission_class)}"'
        f"{marked(mission_class, calibration, half)} "
        f'd="{svg.points(across(flights[column_x]), up(flights[column_y]))}"/>'
        for (calibration, half, mission_class), flights in rows.groupby(KEYS, sort=True)
    )
    size = svg.FINENESS * (SMALL if len(rows) > MANY else LARGE)
    return f'<g transform="scale({1 / svg.FINENESS:g})" stroke-width="{size:g}">{groups}</g>'
