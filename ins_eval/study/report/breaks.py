"""Where the thesis does not hold: requirements that fail, controls that show something, notes."""

from collections.abc import Sequence

from ins_eval.study.report.figures.marks import calibration_title
from ins_eval.study.report.figures.matrix import TITLES
from ins_eval.study.report.requirements import asked, requirements, unseen, where
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables.score import SCORES, Score
from pyhrg.common.pages.markup import Table, paragraph, table


def breaks(result: StudyResult) -> str:
    """A table of requirements, one of notes."""
    if not asked(result):
        return paragraph("Nothing was asked of the unseen half.") + _noted(result)
    chance = (
        "Where a 95 % interval decides, one requirement or control in twenty that is right fails "
        "by chance."
    )
    return _wide(requirements(result)) + paragraph(chance, "weak") + _noted(result)


def controls(result: StudyResult) -> str:
    """How many negative controls show nothing, and those that show something."""
    held_to = [s for s in unseen(result) if s.shuffled and s.holds is not None]
    failed = [s for s in held_to if not s.holds]
    count = (
        f"Of {len(held_to)} negative controls on the unseen half {len(failed) or 'none'} show "
        "something; one in twenty does by chance."
    )
    rows = tuple(
        (TITLES[s.predictor], SCORES[s.score], calibration_title(s.calibration), where([s]))
        for s in failed
    )
    shown = _wide(Table("These", ("Predictor", "What", "Calibration", "Where"), rows))
    return paragraph(count) + (shown if rows else "")


def _noted(result: StudyResult) -> str:
    noted = [s for s in unseen(result) if s.note]
    kinds = dict.fromkeys((s.note, s.calibration) for s in noted)
    rows = tuple(_note([s for s in noted if (s.note, s.calibration) == kind]) for kind in kinds)
    return _wide(Table("What the study notes", ("", "Calibration", "Where"), rows)) if rows else ""


def _note(scores: Sequence[Score]) -> tuple[str, ...]:
    first = scores[0]
    return f"{first.note}", calibration_title(first.calibration), where(scores)


def _wide(content: Table) -> str:
    return f'<div class="wide words">{table(content)}</div>'
