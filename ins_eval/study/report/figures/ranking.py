"""Gyros: what the bench says of each against its rms error over power-on angles."""

import html

from ins_eval.study.report.figures.dots import KEYS, dots, positive
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg

RANKED_BY = {
    "fixed_rule": (c.GYROS_FIXED, "Fixed-position stability", "deg/h"),
    "circumference_rule": (c.GYROS_CIRCUMFERENCE, "Full-circumference stability", "deg/h"),
    "fitted_map": (c.GYROS_FITTED, "Fitted map", "predicted rms, m"),
}
"""By the predictor whose rank correlation it shows: column, title, axis."""


def ranking(result: StudyResult) -> str:
    """A panel a bench figure."""
    drawn = "".join(_figure(result, predictor) for predictor in RANKED_BY)
    return f'<div class="panels">{drawn}</div>'


def _figure(result: StudyResult, predictor: str) -> str:
    column, title, axis = RANKED_BY[predictor]
    gyros = result.table[[*KEYS, column, c.GYROS_FLOWN]].explode([column, c.GYROS_FLOWN])
    gyros = positive(gyros.astype({column: float, c.GYROS_FLOWN: float}), column, c.GYROS_FLOWN)
    x, y = svg.across(*svg.decades(gyros[column])), svg.up(*svg.decades(gyros[c.GYROS_FLOWN]))
    label = html.escape(f"{title} against flown rms error, {len(gyros)} gyros and missions")
    return (
        f'<figure data-panel="rank_{predictor}"><figcaption><b>{html.escape(title)}</b><br>'
        f'<span class="live">{len(gyros):,} gyros in missions</span></figcaption>'
        f'<svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" aria-label="{label}">'
        f"{svg.frame(x, y, axis, 'flown rms over angles, m')}"
        f"{dots(result, gyros, (column, x), (c.GYROS_FLOWN, y))}</svg></figure>"
    )
