"""Predicted against flown error; a panel for each predictor."""

import html

import numpy as np
import pandas as pd

from ins_eval.study.report.distances import NMI
from ins_eval.study.report.figures.dots import draw_dots, select_positive
from ins_eval.study.report.figures.filters import make_class_legend
from ins_eval.study.report.figures.parts import Panel, draw_axes, draw_equality, join_panels
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg


def render_scatter(data: StudyData) -> str:
    """Panels with common axes."""
    shown = [c.FLOWN_RADIAL, *(p.median for p in c.PREDICTORS)]
    limits = svg.find_decades(np.concatenate([data.table[column] for column in shown]))
    panels = (_make_panel(data, predictor, limits) for predictor in c.PREDICTORS)
    return make_class_legend(data) + join_panels(panels, ' id="predictions"')


def _make_panel(data: StudyData, predictor: c.Predictor, limits: tuple[float, float]) -> Panel:
    rows = select_positive(data.table, predictor.median, c.FLOWN_RADIAL)
    return Panel(
        title=predictor.title,
        body=_draw(data, rows, predictor, limits) if len(rows) else "<p>No predictions.</p>",
        notes=[
            f'<span class="weak">{html.escape(predictor.what)}</span>',
            f'<span class="live">{len(rows):,} of {len(data.table):,} flights</span>',
        ],
        attributes=f' data-panel="{predictor.key}"',
    )


def _draw(
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
