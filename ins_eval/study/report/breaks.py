"""Where the thesis does not hold: what was asked and failed, what the study noted."""

from collections.abc import Sequence

from ins_eval.study.report.marks import calibration_title
from ins_eval.study.report.matrix import TITLES
from ins_eval.study.report.result import StudyResult
from ins_eval.study.report.svg import number
from ins_eval.study.score import SCORES, Score
from pyhrg.bench.outcome import Table
from pyhrg.bench.reporting.markup import paragraph, table


def breaks(result: StudyResult) -> str:
    """Failed requirements and notes, a table each."""
    asked = [s for s in result.scores if s.holds is not None]
    failed = [s for s in asked if not s.holds]
    noted = [s for s in result.scores if s.note and s not in failed]
    parts = [paragraph(_count(asked, failed))]
    if failed:
        parts.append(_table("What was asked and is not met", failed))
    if noted:
        parts.append(_table("Noted by the study", noted))
    return "".join(parts)


def _count(asked: Sequence[Score], failed: Sequence[Score]) -> str:
    if not asked:
        return "Nothing was asked."
    return f"Of {len(asked)} requirements {len(failed) or 'none'} failed."


def _table(title: str, scores: Sequence[Score]) -> str:
    header = ("Class", "What", "Predictor", "figure", "interval", "n", "asked", "Calibration, note")
    rows = tuple(
        (
            f"{s.mission_class}, {s.half}",
            SCORES[s.score] + (", devices shuffled" if s.shuffled else ""),
            TITLES[s.predictor],
            number(s.value),
            f"{number(s.low)} to {number(s.high)} ({100 * s.confidence:g} %)",
            f"{s.n:,}",
            s.asked or "–",
            ": ".join(filter(None, (calibration_title(s.calibration), s.note))),
        )
        for s in scores
    )
    return f'<div class="wide">{table(Table(title, header, rows))}</div>'
