"""Bench figures of single gyros against their rms error over power-on angles."""

from ins_eval.study.report.distances import NMI
from ins_eval.study.report.figures.dots import KEYS, draw_dots, select_positive
from ins_eval.study.report.figures.parts import Panel, draw_axes, join_panels
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg

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
    return join_panels(_make_panel(data, predictor) for predictor in RANKED_BY)


def _make_panel(data: StudyData, predictor: str) -> Panel:
    column, title, axis = RANKED_BY[predictor]
    gyros = data.table[[*KEYS, column, c.GYROS_FLOWN]].explode([column, c.GYROS_FLOWN])
    gyros = gyros.astype({column: float, c.GYROS_FLOWN: float})
    gyros = select_positive(gyros, column, c.GYROS_FLOWN)
    x, y = (
        svg.make_horizontal_scale(*svg.find_decades(gyros[column])),
        svg.make_vertical_scale(*svg.find_decades(gyros[c.GYROS_FLOWN])),
    )
    return Panel(
        title=title,
        body=draw_axes(
            x,
            y,
            (axis, f"rms error, {NMI}"),
            draw_dots(data, gyros, (column, x), (c.GYROS_FLOWN, y)),
            f"{title} against rms error, {len(gyros)} gyros and missions",
        ),
        notes=[f'<span class="live">{len(gyros):,} gyros in missions</span>'],
        attributes=f' data-panel="rank_{predictor}"',
    )
