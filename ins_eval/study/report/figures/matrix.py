"""Scores as tables: a row a mission class, a column a predictor, each cell with its interval."""

import html
import math
from collections.abc import Sequence
from dataclasses import dataclass

from ins_eval.study.report.figures.marks import calibration_title, marked
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL, COVERAGE, SCORES, WIDTH, Score
from pyhrg.common.pages.svg import Scale, number

BAR = 96
"""Width of a drawn interval, px."""
TITLES = {p.key: p.title for p in c.PREDICTORS} | {"": "Figure"}


@dataclass(frozen=True)
class Axis:
    """Of the drawn intervals; a stroke at `reference`."""

    low: float
    high: float
    reference: float
    log: bool = False

    @property
    def scale(self) -> Scale:
        """Onto the bar."""
        return Scale(self.low, self.high, 3, BAR - 3, self.log)


def matrices(result: StudyResult, score: str, axis: Axis, shuffled: bool = False) -> str:
    """Tables of a score, one a calibration and half."""
    scores = result.picked(score, shuffled=shuffled)
    kinds = sorted({(s.calibration, s.half) for s in scores})
    if not kinds:
        what = SCORES[score] + (", devices shuffled" if shuffled else "")
        return f"<p>Not scored in this study: {html.escape(what)}.</p>"
    tables = ([s for s in scores if (s.calibration, s.half) == kind] for kind in kinds)
    return "".join(_table(group, axis, _caption(group, result.level)) for group in tables)


def _table(scores: Sequence[Score], axis: Axis, caption: str) -> str:
    first = scores[0]
    order = [key for key in TITLES if any(s.predictor == key for s in scores)]
    classes = sorted({s.mission_class for s in scores}, key=lambda name: (name != ALL, name))
    head = "".join(f'<th scope="col">{html.escape(TITLES[key])}</th>' for key in order)
    rows = "".join(_row(scores, name, order, axis) for name in classes)
    return (
        f'<div class="wide"{marked(ALL, first.calibration, first.half)}><table class="matrix">'
        f"<caption>{html.escape(caption)}</caption>"
        f'<thead><tr><th scope="col">Class</th>{head}<th scope="col">triads</th></tr></thead>'
        f"<tbody>{rows}</tbody></table></div>"
    )


def _caption(scores: Sequence[Score], level: float) -> str:
    first = scores[0]
    asked = f", {level:g} % asked" if first.score in (COVERAGE, WIDTH) else ""
    seeds = sorted({s.seed for s in scores if s.seed is not None})
    seeded = f", seed {', '.join(map(str, seeds))}" if seeds else ""
    shuffled = ", devices shuffled" if first.shuffled else ""
    of = f"{calibration_title(first.calibration)}, {first.half} half"
    intervals = f"{100 * first.confidence:g} % intervals, {_method(first)}{seeded}"
    return f"{SCORES[first.score]}{asked}{shuffled}; {of}; {intervals}"


def _method(score: Score) -> str:
    if score.shuffled:
        return "over shuffles"
    return "exact binomial" if score.score == COVERAGE else "bootstrap over triads"


def _row(scores: Sequence[Score], name: str, order: Sequence[str], axis: Axis) -> str:
    here = {s.predictor: s for s in scores if s.mission_class == name}
    cells = "".join(_cell(here.get(key), axis) for key in order)
    counts = " to ".join(f"{n:,}" for n in sorted({s.n for s in here.values()}))
    return (
        f'<tr{marked(name)}><th scope="row">{html.escape(name)}</th>{cells}<td>{counts}</td></tr>'
    )


def _cell(score: Score | None, axis: Axis) -> str:
    if score is None or math.isnan(score.value):
        return "<td>–</td>"
    note = f' title="{html.escape(score.note)}"' if score.note else ""
    return (
        f"<td{note}><b>{number(score.value)}</b>{_held(score)}<br>"
        f"<small>{number(score.low)} to {number(score.high)}</small><br>{_bar(score, axis)}</td>"
    )


def _held(score: Score) -> str:
    if score.holds is None:
        return ""
    word = "holds" if score.holds else "fails"
    return f'<br><span class="{word}">{html.escape(score.asked)}: {word}</span>'


def _bar(score: Score, axis: Axis) -> str:
    ends = [score.low, score.value, score.high]
    if any(math.isnan(v) for v in ends):
        return ""
    low, value, high = axis.scale([min(max(v, axis.low), axis.high) for v in ends])
    at = float(axis.scale(axis.reference))
    return (
        f'<svg class="bar" viewBox="0 0 {BAR} 14" width="{BAR}" aria-hidden="true">'
        f'<path class="grid" d="M{at:.1f} 0V14"/><path class="span" d="M{low:.1f} 7H{high:.1f}"/>'
        f"{_point(value, score.value < axis.low, score.value > axis.high)}</svg>"
    )


def _point(at: float, below: bool, above: bool) -> str:
    """A dot, or an arrow where the value lies outside."""
    if below or above:
        way = -5 if below else 5
        return f'<path d="M{at:.1f} 7l{-way} -4v8z"/>'
    return f'<circle cx="{at:.1f}" cy="7" r="3.5"/>'
