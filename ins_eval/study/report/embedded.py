"""What the page's script reads: the points, and each panel's scores in words."""

import json
import math
from collections.abc import Iterable
from typing import Any

import pandas as pd

from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import MEDIAN_RATIO, R2_RADIAL, SPEARMAN, Score
from pyhrg.common.pages.svg import number

DIGITS = 4
NAMES = (c.CALIBRATION, c.HALF, c.CLASS, c.MISSION)
NUMBERS = (c.FLOWN_RADIAL, *(p.median for p in c.PREDICTORS))
SHORT = {R2_RADIAL: "R²", MEDIAN_RATIO: "flown/predicted", SPEARMAN: "Spearman"}


def embedded(result: StudyResult) -> str:
    """JSON that may stand inside a script element."""
    table = result.table
    content: dict[str, Any] = {
        "triad": table[c.TRIAD].tolist(),
        "names": {name: _coded(table[name]) for name in NAMES},
        "numbers": {name: [_rounded(v) for v in table[name]] for name in NUMBERS},
        "captions": captions(result.scores),
    }
    text = json.dumps(content, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")


def captions(scores: Iterable[Score]) -> dict[str, str]:
    """By panel, calibration, half and class, joined by "|": its scores with intervals."""
    told: dict[str, list[str]] = {}
    for s in scores:
        if s.score in SHORT and not s.shuffled and s.predictor:
            key = "|".join((_panel(s), s.calibration, s.half, s.mission_class))
            told.setdefault(key, []).append(
                f"{SHORT[s.score]} {number(s.value)} ({number(s.low)} to {number(s.high)}, "
                f"n {s.n:,})"
            )
    return {key: "; ".join(parts) for key, parts in sorted(told.items())}


def _panel(score: Score) -> str:
    return f"rank_{score.predictor}" if score.score == SPEARMAN else score.predictor


def _coded(column: pd.Series) -> dict[str, Any]:
    codes, levels = pd.factorize(column, sort=True)
    return {"levels": list(map(str, levels)), "codes": codes.tolist()}


def _rounded(value: float) -> float | int | None:
    if not math.isfinite(value):
        return None
    short = float(f"{value:.{DIGITS}g}")
    return int(short) if short.is_integer() else short
