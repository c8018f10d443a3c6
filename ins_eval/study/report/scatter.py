"""Panels of dots: predicted against flown for each predictor, bench figure against flown."""

import html
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ins_eval.study import columns as c
from ins_eval.study.report import svg
from ins_eval.study.report.marks import colour, legend, marked
from ins_eval.study.report.result import StudyResult

KEYS = [c.CALIBRATION, c.HALF, c.CLASS]
RANKED = {
    c.FIXED_STABILITY: "Fixed-position stability",
    c.CIRCUMFERENCE_STABILITY: "Full-circumference stability",
}


@dataclass(frozen=True)
class Panel:
    """name: what panels are chosen and captioned by; x, y: columns; equal: draws x = y."""

    name: str
    title: str
    x: str
    y: str
    x_label: str
    y_label: str
    equal: bool


def predictions(result: StudyResult) -> str:
    """Predicted against flown, a panel a predictor."""
    panels = [
        Panel(p.key, p.title, p.median, c.FLOWN_RADIAL, "predicted, m", "flown, m", True)
        for p in c.PREDICTORS
    ]
    both = np.concatenate([result.table[p.x] for p in panels] + [result.table[c.FLOWN_RADIAL]])
    limits = svg.decades(both)
    knows = {p.key: p.what for p in c.PREDICTORS}
    drawn = "".join(_figure(result, p, knows[p.name], limits, limits) for p in panels)
    return f'{legend(result)}<div class="panels" id="predictions">{drawn}</div>'


def ranking(result: StudyResult) -> str:
    """Bench figures against rms error over power-on angles."""
    table = result.table
    x = svg.decades(np.concatenate([table[column] for column in RANKED]))
    y = svg.decades(table[c.RMS_OVER_ANGLES])
    panels = [
        Panel("rank_" + column, title, column, c.RMS_OVER_ANGLES, "deg/h", "flown rms, m", False)
        for column, title in RANKED.items()
    ]
    drawn = "".join(_figure(result, p, "the bench's figure alone", x, y) for p in panels)
    return f'<div class="panels">{drawn}</div>'


Limits = tuple[float, float]


def _figure(result: StudyResult, panel: Panel, knows: str, x: Limits, y: Limits) -> str:
    shown = result.table[(result.table[panel.x] > 0) & (result.table[panel.y] > 0)]
    title = html.escape(panel.title)
    body = _drawing(result, shown, panel, x, y) if len(shown) else "<p>No figures.</p>"
    return (
        f'<figure data-panel="{panel.name}"><figcaption><b>{title}</b>'
        f'<br><span class="weak">{html.escape(knows)}</span><br>'
        f'<span class="live">{len(shown):,} of {len(result.table):,} flights</span></figcaption>'
        f"{body}</figure>"
    )


def _drawing(result: StudyResult, shown: pd.DataFrame, panel: Panel, x: Limits, y: Limits) -> str:
    across, up = svg.across(*x), svg.up(*y)
    label = html.escape(
        f"{panel.title}: {panel.y_label} against {panel.x_label}, {len(shown)} flights. "
        "Arrow keys step through them."
    )
    groups = "".join(
        f'<path class="dots {colour(result, mission_class)}"'
        f"{marked(mission_class, calibration, half)} "
        f'd="{svg.points(across(rows[panel.x]), up(rows[panel.y]))}"/>'
        for (calibration, half, mission_class), rows in shown.groupby(KEYS, sort=True)
    )
    return (
        f'<svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" tabindex="0" '
        f'aria-label="{label}" data-x="{panel.x}" data-y="{panel.y}" '
        f'data-plot="{svg.LEFT} {svg.RIGHT} {svg.BOTTOM} {svg.TOP}" '
        f'data-x-range="{x[0]:g} {x[1]:g}" data-y-range="{y[0]:g} {y[1]:g}">'
        f"{svg.frame(across, up, panel.x_label, panel.y_label)}{_equal(across, up, panel)}"
        f'<g transform="scale({1 / svg.FINENESS:g})">{groups}</g>'
        '<circle class="mark" r="7" visibility="hidden"/></svg>'
    )


def _equal(x: svg.Scale, y: svg.Scale, panel: Panel) -> str:
    if not panel.equal:
        return ""
    ends = np.array([max(x.low, y.low), min(x.high, y.high)])
    return f'<path class="equal" d="{svg.line(x(ends), y(ends))}"/>'
