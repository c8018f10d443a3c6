"""The sections of the report, in order."""

from typing import Any

from ins_eval.study.report.claim_table import render_conditions
from ins_eval.study.report.figures.budget import render_budget
from ins_eval.study.report.figures.matrix import IntervalAxis, render_matrices
from ins_eval.study.report.figures.parts import make_fold
from ins_eval.study.report.figures.phase import render_phase_diagram
from ins_eval.study.report.figures.ranking import render_ranking
from ins_eval.study.report.figures.scatter import render_scatter
from ins_eval.study.report.own_gyro import render_own_gyro
from ins_eval.study.study_data import (
    CONDITIONS_KEY,
    LEAD_KEY,
    PHASE_KEY,
    WITNESS_KEY,
    StudyData,
)
from ins_eval.study.tables import score
from ins_eval.study.tables.columns import COLUMNS
from ins_eval.study.witness.judge import WitnessScore, list_figures
from pyhrg.common.pages.markup import Table, make_paragraph, make_wide_table
from pyhrg.common.pages.shell import PageSection

R2 = IntervalAxis(-0.2, 1.0, 1.0)
RATIO = IntervalAxis(0.1, 100.0, 1.0, log=True)
CORRELATION = IntervalAxis(-0.5, 1.0, 0.0)
DIFFERENCE = IntervalAxis(0.0, 0.05, 0.01)


def make_sections(data: StudyData) -> list[PageSection]:
    """The sections, by anchor, title and content."""
    return [
        PageSection("own", "Predict the error of your own gyro", render_own_gyro(data)),
        PageSection("predicted", "Predicted against flown", _render_predictions(data)),
        PageSection("size", "Size of the error: flown over predicted", _render_ratios(data)),
        PageSection("ranking", "Ranking of gyros", _render_ranking(data)),
        PageSection("coverage", "Intervals and their coverage", _render_coverage(data)),
        PageSection("breaks", "Conditions in which claims fail", render_conditions(data)),
        *_make_witness_section(data),
        PageSection("phase", "Where each test tells the truth", render_phase_diagram(data)),
        PageSection("budget", "Error budget", _render_budget(data)),
        PageSection("control", "Negative control", _render_control(data)),
        PageSection("method", "What was studied, and how", _render_method(data)),
    ]


def _render_predictions(data: StudyData) -> str:
    lead = (
        "Each dot is a triad's flight. On the dashed line the flown error is the predicted one; "
        "above it the flown error is larger. R2 is 1 for exact predictions; below 0 the mean of "
        "the flown errors is nearer to them than the predictions are."
    )
    components = render_matrices(data, score.R2_COMPONENTS, R2)
    return (
        make_paragraph(lead)
        + render_scatter(data)
        + render_matrices(data, score.R2_RADIAL, R2)
        + make_fold(
            "R2 by components, and without the mounting",
            components + render_matrices(data, score.R2_MOUNTED, R2),
        )
    )


def _render_ratios(data: StudyData) -> str:
    lead = (
        "1 is an accurate prediction; at 10 the flown error is ten times the predicted one. The "
        "usual rule takes 0.01 deg/h for 1 nmi/h; the class constant is that of a mission class, "
        "from linear flights of the training triads."
    )
    constants = render_matrices(data, score.CLASS_CONSTANT, RATIO)
    return make_paragraph(lead) + render_matrices(data, score.MEDIAN_RATIO, RATIO) + constants


def _render_ranking(data: StudyData) -> str:
    lead = (
        "Does a gyro that the bench finds better also fly better? The rms over power-on angles "
        "removes the luck of a single flight; these flights are too many and linear. On the bench "
        "and in flight the electronics start the pattern at the same angle; one figure tells what "
        "turn-ons would show if patterns started anywhere."
    )
    ranks = render_matrices(data, score.SPEARMAN, CORRELATION)
    flights = render_matrices(data, score.FLIGHT_SPEARMAN, CORRELATION)
    return make_paragraph(lead) + render_ranking(data) + ranks + flights


def _render_coverage(data: StudyData) -> str:
    level = data.interval_percent / 100
    axis = IntervalAxis(min(0.5, level / 2), 1.0, level)
    lead = f"Intervals that should contain {data.interval_percent:g} % of the flown errors."
    return make_paragraph(lead) + render_matrices(data, score.COVERAGE, axis)


def _render_budget(data: StudyData) -> str:
    lead = "The parts of the error by the linear model, and the error that was flown."
    return make_paragraph(lead) + render_budget(data)


def _render_control(data: StudyData) -> str:
    lead = "Each triad gets the predictions of another one; these must not predict its error."
    return make_paragraph(lead) + "".join(
        render_matrices(data, key, axis, shuffled=True)
        for key, axis in ((score.SPEARMAN, CORRELATION), (score.R2_COMPONENTS, R2))
    )


def _make_witness_section(data: StudyData) -> list[PageSection]:
    """What the gyros' own channels tell, where a study has read them."""
    scores = [WitnessScore(**each) for each in data.about.get(WITNESS_KEY, [])]
    if not scores:
        return []
    lead = (
        "Forces, frequency and pattern angle of each gyro were recorded in flight. They tell how "
        "far its map has drifted since the bench. R2 is that of the horizontal error; a corrected "
        "flight is the same record, navigated after the told maps were taken out. The control has "
        "the channels of another triad."
    )
    header = ("calibration", "class", "self-test", "score", "value (95 %)", "triads")
    table = make_wide_table(Table("Self-witness", header, list_figures(scores)))
    return [
        PageSection("witness", "What the gyros tell of themselves", make_paragraph(lead) + table)
    ]


def _render_method(data: StudyData) -> str:
    left_out = (CONDITIONS_KEY, LEAD_KEY, PHASE_KEY, WITNESS_KEY)
    facts = tuple((k, _format_fact(v)) for k, v in data.about.items() if k not in left_out)
    rows = tuple((column.name, column.unit or "–", column.what) for column in COLUMNS)
    columns = make_wide_table(Table("Columns", ("name", "unit", ""), rows))
    return (
        make_wide_table(Table("What was studied", ("", ""), facts))
        + "".join(
            render_matrices(data, key, DIFFERENCE)
            for key in (score.AGREEMENT, score.STEADY_AGREEMENT)
        )
        + make_fold("Columns of study.parquet", columns)
    )


def _format_fact(value: Any) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {_format_fact(inner)}" for key, inner in value.items())
    return ", ".join(map(_format_fact, value)) if isinstance(value, list) else str(value)
