"""The sections of the report, in order."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ins_eval.study.report.apart import apart
from ins_eval.study.report.breaks import breaks, controls
from ins_eval.study.report.figures.budget import budget
from ins_eval.study.report.figures.growth import panels
from ins_eval.study.report.figures.matrix import Axis, matrices
from ins_eval.study.report.figures.ranking import ranking
from ins_eval.study.report.figures.scatter import predictions
from ins_eval.study.report.result import CONDITIONS, StudyResult
from ins_eval.study.tables import columns as c
from ins_eval.study.tables import score as scored
from pyhrg.common.pages.markup import Table, paragraph, table

R2 = Axis(-0.2, 1.0, 1.0)
RATIO = Axis(0.1, 100.0, 1.0, log=True)
CORRELATION = Axis(-0.5, 1.0, 0.0)
ADVANTAGE = Axis(-1.0, 4.0, 0.0)
UNPREDICTABLE = Axis(0.01, 10.0, 0.1, log=True)
DIFFERENCE = Axis(0.0, 0.05, 0.01)


@dataclass(frozen=True)
class Section:
    """name: its anchor; title; lead: what to look for; content: markup."""

    name: str
    title: str
    lead: str
    content: Callable[[StudyResult], str]


def _predicted(result: StudyResult) -> str:
    return (
        predictions(result)
        + matrices(result, scored.R2_RADIAL, R2)
        + _folded("R2 by components", matrices(result, scored.R2_COMPONENTS, R2))
    )


def _optimism(result: StudyResult) -> str:
    return matrices(result, scored.MEDIAN_RATIO, RATIO) + _folded(
        "Optimism of the rms", matrices(result, scored.OPTIMISM, RATIO)
    )


def _beyond(result: StudyResult) -> str:
    return matrices(result, scored.VARIANCE_REMOVED, R2)


def _ranking(result: StudyResult) -> str:
    return ranking(result) + matrices(result, scored.SPEARMAN, CORRELATION)


def _coverage(result: StudyResult) -> str:
    level = result.level / 100
    covered = Axis(min(0.5, level / 2), 1.0, level)
    asked = paragraph(f"Intervals that are to hold {result.level:g} % of the errors flown.")
    return (
        asked + matrices(result, scored.COVERAGE, covered) + matrices(result, scored.WIDTH, RATIO)
    )


def _breaks(result: StudyResult) -> str:
    return (
        breaks(result)
        + "<h3>Conditions in which it may fail, judged apart</h3>"
        + apart(result)
        + "<h3>Class by class</h3>"
        + matrices(result, scored.ADVANTAGE, ADVANTAGE)
        + matrices(result, scored.UNPREDICTABLE_SHARE, UNPREDICTABLE)
    )


def _control(result: StudyResult) -> str:
    return controls(result) + "".join(
        matrices(result, score, axis, shuffled=True)
        for score, axis in ((scored.SPEARMAN, CORRELATION), (scored.R2_COMPONENTS, R2))
    )


def _method(result: StudyResult) -> str:
    facts = tuple((key, _fact(value)) for key, value in result.about.items() if key != CONDITIONS)
    rows = tuple((column.name, column.unit or "–", column.what) for column in c.COLUMNS)
    return (
        _wide(Table("What was studied", ("", ""), facts))
        + matrices(result, scored.AGREEMENT, DIFFERENCE)
        + _folded("Columns of study.parquet", _wide(Table("Columns", ("name", "unit", ""), rows)))
    )


def _fact(value: Any) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {_fact(inner)}" for key, inner in value.items())
    return ", ".join(map(_fact, value)) if isinstance(value, list) else str(value)


def _folded(title: str, content: str) -> str:
    return f"<details><summary>{title}</summary>{content}</details>"


def _wide(content: Table) -> str:
    return f'<div class="wide">{table(content)}</div>'


SECTIONS = (
    Section(
        "predicted",
        "Predicted against flown",
        "Each dot is a triad's flight. On the dashed line the error flown is the one predicted; "
        "above it the predictor was too optimistic.",
        _predicted,
    ),
    Section(
        "optimism",
        "How far promises are off",
        "1 is a kept promise; 10 an error ten times as large as promised.",
        _optimism,
    ),
    Section(
        "beyond",
        "What the map knows beyond the circumference",
        "Within a class, where a wide spread of gyros flatters no predictor.",
        _beyond,
    ),
    Section(
        "growth",
        "Growth of the error",
        "Median and 5 to 95 % of flights over time, by class and calibration.",
        panels,
    ),
    Section(
        "ranking",
        "Ranking of gyros",
        "Does the gyro that the bench finds better fly better? The rms over power-on angles takes "
        "the luck of a single flight away.",
        _ranking,
    ),
    Section(
        "coverage",
        "Intervals and how often they hold",
        "A predicted interval should hold its share of errors, and be no wider than it must.",
        _coverage,
    ),
    Section("breaks", "What breaks the thesis", "", _breaks),
    Section(
        "budget",
        "Budget of effects",
        "What the flown error is made of.",
        budget,
    ),
    Section(
        "control",
        "Negative control",
        "Predictions of other devices, shuffled, must show nothing.",
        _control,
    ),
    Section("method", "What was studied, and how", "", _method),
)


def markup(section: Section, result: StudyResult) -> str:
    """A section's HTML."""
    name = section.name
    lead = paragraph(section.lead) if section.lead else ""
    return (
        f'<section id="{name}" aria-labelledby="{name}-title"><h2 id="{name}-title">'
        f"{section.title}</h2>{lead}{section.content(result)}</section>"
    )
