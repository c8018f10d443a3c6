"""Where the thesis does not hold: what was asked of the unseen half and failed, by what margin."""

from collections.abc import Sequence

from ins_eval.study.report.marks import calibration_title
from ins_eval.study.report.matrix import TITLES
from ins_eval.study.report.result import StudyResult
from ins_eval.study.report.svg import number
from ins_eval.study.report.verdict import UNSEEN
from ins_eval.study.score import SCORES, Score
from pyhrg.bench.outcome import Table
from pyhrg.bench.reporting.markup import paragraph, table

HEADER = ("Class", "What", "Predictor", "figure", "interval", "n", "asked", "Calibration, note")


def breaks(result: StudyResult) -> str:
    """Failed requirements and notes, a table each."""
    unseen = [s for s in result.scores if s.half == UNSEEN]
    asked = [s for s in unseen if s.holds is not None]
    failed = [s for s in asked if not s.holds]
    noted = [s for s in unseen if s.note and s.holds is not False]
    tables = {
        "What was asked of the unseen half and is not met": [s for s in failed if not s.shuffled],
        "Negative controls that show something; of a hundred, five do by chance": [
            s for s in failed if s.shuffled
        ],
        "Noted": noted,
    }
    told = "".join(_table(title, scores) for title, scores in tables.items() if scores)
    return paragraph(_count(asked, failed)) + told


def _count(asked: Sequence[Score], failed: Sequence[Score]) -> str:
    if not asked:
        return "Nothing was asked of the unseen half."
    return (
        f"Of {len(asked)} requirements on the unseen half, negative controls among them, "
        f"{len(failed) or 'none'} failed."
    )


def _table(title: str, scores: Sequence[Score]) -> str:
    rows = tuple(map(_row, scores))
    return f'<div class="wide">{table(Table(f"{title} ({len(rows)})", HEADER, rows))}</div>'


def _row(score: Score) -> tuple[str, ...]:
    return (
        score.mission_class,
        SCORES[score.score] + (", devices shuffled" if score.shuffled else ""),
        TITLES[score.predictor],
        number(score.value),
        f"{number(score.low)} to {number(score.high)} ({100 * score.confidence:g} %)",
        f"{score.n:,}",
        score.asked or "–",
        ": ".join(filter(None, (calibration_title(score.calibration), score.note))),
    )
