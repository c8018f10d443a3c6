"""Scores as tables: a row for each mission class, a column for each predictor."""

import html
import math
from collections.abc import Sequence
from dataclasses import dataclass

from ins_eval.study.report.figures.parts import (
    Row,
    format_interval,
    make_filter_attributes,
    make_table,
    name_calibration,
)
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import (
    ALL,
    COVERAGE,
    R2_COMPONENTS,
    R2_MOUNTED,
    R2_RADIAL,
    RANGE,
    SCORES,
    Score,
)
from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.svg import Scale

BAR = 96
"""Width of a drawn interval, px."""
TITLES = {p.key: p.title for p in c.PREDICTORS} | c.FIGURE_TITLES | {"": "Figure"}
"""Headings of the columns by predictor; "" for scores without one."""

NEGATIVE_R2 = {
    R2_RADIAL: "worse than the mean",
    R2_COMPONENTS: "worse than zero",
    R2_MOUNTED: "worse than zero",
}
"""Words for a prediction whose R2 is below 0: the mean of the flown errors is nearer to them, or
for errors north and east, whose R2 is about zero, no prediction at all."""


@dataclass(frozen=True)
class IntervalAxis:
    """Axis of the drawn intervals, with a stroke at `reference`."""

    low: float
    high: float
    reference: float
    log: bool = False

    @property
    def scale(self) -> Scale:
        """Scale onto the bar's width."""
        return Scale(self.low, self.high, 3, BAR - 3, self.log)


def render_matrices(data: StudyData, score: str, axis: IntervalAxis, shuffled: bool = False) -> str:
    """Tables of a score, one for each calibration."""
    scores = data.select(score, shuffled=shuffled)
    if not scores:
        what = SCORES[score] + (", devices shuffled" if shuffled else "")
        return make_paragraph(f"Not scored in this study: {what}.")
    groups = ([s for s in scores if s.calibration == kind] for kind in data.calibrations)
    return "".join(_render(data, group, axis) for group in groups if group)


def _render(data: StudyData, scores: Sequence[Score], axis: IntervalAxis) -> str:
    first = scores[0]
    order = [key for key in TITLES if any(s.predictor == key for s in scores)]
    scored = {s.mission_class for s in scores}
    classes = [name for name in (ALL, *data.classes) if name in scored]
    return make_table(
        _make_caption(scores, data.interval_percent),
        ("Class", *(TITLES[key] for key in order), "triads"),
        (_make_row(scores, name, order, axis) for name in classes),
        make_filter_attributes(ALL, first.calibration),
    )


def _make_caption(scores: Sequence[Score], interval_percent: float) -> str:
    first = scores[0]
    parts = [SCORES[first.score]]
    if first.score == COVERAGE:
        parts.append(f"{interval_percent:g} % required")
    if first.shuffled:
        parts.append("devices shuffled")
    if first.confidence == RANGE:
        intervals = ["smallest and largest of single triads, no interval"]
    else:
        intervals = [f"{100 * first.confidence:g} % intervals", _name_method(first)]
    seeds = sorted({s.seed for s in scores if s.seed is not None})
    if seeds:
        intervals.append(f"seed {', '.join(map(str, seeds))}")
    group = name_calibration(first.calibration)
    return "; ".join([", ".join(parts), group, ", ".join(intervals)])


def _name_method(score: Score) -> str:
    if score.shuffled:
        return "over permutations"
    return "exact binomial" if score.score == COVERAGE else "bootstrap over triads"


def _make_row(scores: Sequence[Score], name: str, order: Sequence[str], axis: IntervalAxis) -> Row:
    here = {s.predictor: s for s in scores if s.mission_class == name}
    counts = " to ".join(f"{n:,}" for n in sorted({s.n for s in here.values()}))
    cells = [*(_render_cell(here.get(key), axis) for key in order), counts]
    return Row(name, cells, make_filter_attributes(name))


def _render_cell(score: Score | None, axis: IntervalAxis) -> str:
    if score is None or math.isnan(score.value):
        return "–"
    cell = f"{render_estimate(score)}<br>{_draw_bar(score, axis)}"
    if score.verdict:
        asked = f"{html.escape(score.asked)}: {score.verdict}"
        cell += f'<br><span class="{score.verdict}">{asked}</span>'
    return cell


def render_estimate(score: Score) -> str:
    """Markup of a score with its interval below; an R2 below zero in words."""
    text = format_interval(score.value, score.low, score.high)
    words = name_negative_r2(score)
    return f"<b>{words}</b><br><small>R2</small> {text}" if words else text


def name_negative_r2(score: Score) -> str:
    """What an R2 below zero says in words; nothing for other scores."""
    return NEGATIVE_R2.get(score.score, "") if score.value < 0 else ""


def _draw_bar(score: Score, axis: IntervalAxis) -> str:
    ends = [score.low, score.value, score.high]
    if any(math.isnan(v) for v in ends):
        return ""
    low, value, high = axis.scale([min(max(v, axis.low), axis.high) for v in ends])
    at = float(axis.scale(axis.reference))
    return (
        f'<svg class="bar" viewBox="0 0 {BAR} 14" width="{BAR}" aria-hidden="true">'
        f'<path class="grid" d="M{at:.1f} 0V14"/><path class="span" d="M{low:.1f} 7H{high:.1f}"/>'
        f"{_draw_point(value, score.value < axis.low, score.value > axis.high)}</svg>"
    )


def _draw_point(at: float, below: bool, above: bool) -> str:
    """A dot, or an arrow where the value lies outside the axis."""
    if below or above:
        way = -5 if below else 5
        return f'<path d="M{at:.1f} 7l{-way} -4v8z"/>'
    return f'<circle cx="{at:.1f}" cy="7" r="3.5"/>'
