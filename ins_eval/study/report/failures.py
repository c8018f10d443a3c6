"""Where the thesis does not hold: requirements that are not met, failed controls, notes."""

from collections.abc import Sequence

from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.figures.matrix import TITLES
from ins_eval.study.report.requirements import (
    list_classes,
    select_requirements,
    select_unseen,
    tabulate_requirements,
)
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables.score import SCORES, Score
from pyhrg.common.pages.markup import Table, make_paragraph, make_wide_table

CHANCE = (
    "Where a 95 % interval decides, one valid requirement or control in twenty fails by chance."
)


def render_failures(data: StudyData) -> str:
    """A table of requirements, and one of notes."""
    if not select_requirements(data):
        return make_paragraph("The test half has no requirements.") + _render_notes(data)
    requirements = make_wide_table(tabulate_requirements(data), "words")
    return requirements + make_paragraph(CHANCE, "weak") + _render_notes(data)


def render_controls(data: StudyData) -> str:
    """The number of negative controls that fail, and a table of these."""
    controls = [s for s in select_unseen(data) if s.shuffled and s.holds is not None]
    failed = [s for s in controls if not s.holds]
    count = (
        f"{len(failed) or 'None'} of {len(controls)} negative controls on the test half "
        "fail; one in twenty fails by chance."
    )
    rows = tuple(
        (
            TITLES[s.predictor],
            SCORES[s.score],
            name_calibration(s.calibration),
            list_classes([s]),
        )
        for s in failed
    )
    header = ("Predictor", "Score", "Calibration", "Where")
    shown = make_wide_table(Table("Failed controls", header, rows), "words")
    return make_paragraph(count) + (shown if rows else "")


def _render_notes(data: StudyData) -> str:
    noted = [s for s in select_unseen(data) if s.note]
    kinds = dict.fromkeys((s.note, s.calibration) for s in noted)
    rows = tuple(_make_row([s for s in noted if (s.note, s.calibration) == kind]) for kind in kinds)
    notes = Table("Notes", ("", "Calibration", "Where"), rows)
    return make_wide_table(notes, "words") if rows else ""


def _make_row(scores: Sequence[Score]) -> tuple[str, ...]:
    first = scores[0]
    return first.note, name_calibration(first.calibration), list_classes(scores)
