"""Predicted against flown, a panel a predictor."""

import html

import numpy as np
import pandas as pd

from ins_eval.study.report.figures.dots import dots, positive
from ins_eval.study.report.figures.marks import legend
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg


def predictions(result: StudyResult) -> str:
    """Panels on the same axes."""
    shown = [c.FLOWN_RADIAL, *(p.median for p in c.PREDICTORS)]
    limits = svg.decades(np.concatenate([result.table[column] for column in shown]))
    drawn = "".join(_figure(result, predictor, limits) for predictor in c.PREDICTORS)
    return f'{legend(result)}<div class="panels" id="predictions">{drawn}</div>'


def _figure(result: StudyResult, predictor: c.Predictor, limits: tuple[float, float]) -> str:
    rows = positive(result.table, predictor.median, c.FLOWN_RADIAL)
    body = _drawing(result, rows, predictor, limits) if len(rows) else "<p>No predictions.</p>"
    return (
        f'<figure data-panel="{predictor.key}"><figcaption><b>{html.escape(predictor.title)}</b>'
        f'<br><span class="weak">{html.escape(predictor.what)}</span><br>'
        f'<span class="live">{len(rows):,} of {len(result.table):,} flights</span></figcaption>'
        f"{body}</figure>"
    )


def _drawing(
    result: StudyResult, rows: pd.DataFrame, predictor: c.Predictor, limits: tuple[float, float]
) -> str:
    x, y = svg.across(*limits), svg.up(*limits)
    ends = np.array(limits)
    drawn = dots(result, rows, (predictor.median, x), (c.FLOWN_RADIAL, y))
    label = html.escape(
        f"{predictor.title}: flown against predicted horizontal error, {len(rows)} flights. "
        "Arrow keys step through them."
    )
    return (
        f'<svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" tabindex="0" '
        f'aria-label="{label}" data-x="{predictor.median}" data-y="{c.FLOWN_RADIAL}" '
        f'data-plot="{svg.LEFT} {svg.RIGHT} {svg.BOTTOM} {svg.TOP}" '
        f'data-range="{limits[0]:g} {limits[1]:g}">{svg.frame(x, y, "predicted, m", "flown, m")}'
        f'<path class="equal" d="{svg.line(x(ends), y(ends))}"/>{drawn}'
        '<circle class="mark" r="7" visibility="hidden"/></svg>'
    )
