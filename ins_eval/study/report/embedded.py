"""Data for the page's script: the points, and each panel's scores in words."""

import math
from collections.abc import Iterable
from typing import Any

import pandas as pd

from ins_eval.study.report.claims import format_score
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import MEDIAN_RATIO, R2_RADIAL, SPEARMAN, Score
from pyhrg.common.pages.markup import embed_json

DIGITS = 4
"""Significant digits of a point's numbers. Chosen: more are not visible."""
NAMES = (c.CALIBRATION, c.CLASS, c.MISSION, c.FLOWN_BY)
NUMBERS = (c.FLOWN_RADIAL, *(p.median for p in c.PREDICTORS))
SHORT_NAMES = {R2_RADIAL: "R²", MEDIAN_RATIO: "flown/predicted", SPEARMAN: "Spearman"}


def embed_study(data: StudyData) -> str:
    """JSON that can stand inside a script element."""
    table = data.table
    content: dict[str, Any] = {
        "triad": table[c.TRIAD].tolist(),
        "names": {name: _encode(table[name]) for name in NAMES},
        "numbers": {name: [_round(v) for v in table[name]] for name in NUMBERS},
        "captions": list_captions(data.scores),
    }
    return embed_json(content)


def list_captions(scores: Iterable[Score]) -> dict[str, str]:
    """Scores with intervals, by panel, calibration and class, which are joined by "|"."""
    captions: dict[str, list[str]] = {}
    for s in scores:
        if s.score in SHORT_NAMES and not s.shuffled and s.predictor:
            panel = f"rank_{s.predictor}" if s.score == SPEARMAN else s.predictor
            key = "|".join((panel, s.calibration, s.mission_class))
            text = f"{SHORT_NAMES[s.score]} {format_score(s)}, n {s.n:,}"
            captions.setdefault(key, []).append(text)
    return {key: "; ".join(parts) for key, parts in sorted(captions.items())}


def _encode(column: pd.Series) -> dict[str, Any]:
    codes, levels = pd.factorize(column, sort=True)
    return {"levels": list(map(str, levels)), "codes": codes.tolist()}


def _round(value: float) -> float | int | None:
    if not math.isfinite(value):
        return None
    short = float(f"{value:.{DIGITS}g}")
    return int(short) if short.is_integer() else short
