"""A finished study as the report reads it: the table, the scores, and what was studied."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.study.specification import CONDITION
from ins_eval.study.tables import columns
from ins_eval.study.tables import score as scored
from ins_eval.study.tables.score import Score
from pyhrg.common.errors import HrgError

TABLE, DOCUMENT = "study.parquet", "study.json"
INTERVAL_PERCENT = "interval_percent"
"""Key of the document: of predicted intervals."""
CONDITIONS = "conditions"
"""Key of the document: what is special in each, by its title."""
KINDS = {"int": "iu", "number": "f", "text": "OUT", "numbers": "O"}
"""numpy's kinds that a column's kind may be stored as."""


class ResultError(HrgError):
    """A results folder that is none: names file, column or key, what was found and expected."""


@dataclass(frozen=True)
class StudyResult:
    """table: columns of `columns.COLUMNS`; scores; about: plain facts (seed, triads, ...); apart:
    flights and scores in conditions that are judged by themselves."""

    table: pd.DataFrame
    scores: Sequence[Score]
    about: Mapping[str, Any]
    apart: "StudyResult | None" = None

    @property
    def level(self) -> float:
        """Of predicted intervals, percent."""
        return float(self.about[INTERVAL_PERCENT])

    def values(self, column: str) -> list[str]:
        """Those of a text column, sorted."""
        return sorted(map(str, self.table[column].unique()))

    def picked(self, score: str, **wanted: Any) -> list[Score]:
        """Scores of this key whose fields are as wanted; unshuffled unless asked for."""
        wanted = {"shuffled": False, "score": score, **wanted}
        return [s for s in self.scores if all(getattr(s, k) == v for k, v in wanted.items())]


def result(table: pd.DataFrame, document: Mapping[str, Any], source: str = "") -> StudyResult:
    """Checked.

    Args:
        table: of study.parquet.
        document: of study.json: `scores` and plain facts.
        source: put before what errors say.

    Raises:
        ResultError: a column or key is missing or of another kind; there are no rows.
    """
    if not isinstance(document, dict):
        raise ResultError(f"{source}{DOCUMENT}: found {document!r}, expected an object")
    if not len(table):
        raise ResultError(f"{source}{TABLE}: found no rows, expected one a triad and mission")
    for column in columns.COLUMNS:
        _check(table, column, source)
    about = {k: v for k, v in document.items() if k != "scores"}
    scores = _scores(document, source)
    _check_level(about.get(INTERVAL_PERCENT), source)
    within = table[columns.HALF] == CONDITION
    apart = StudyResult(table[within], [s for s in scores if s.half == CONDITION], about)
    return StudyResult(
        table[~within],
        [s for s in scores if s.half != CONDITION],
        about,
        apart if within.any() else None,
    )


def _check_level(found: Any, source: str) -> None:
    if not isinstance(found, int | float) or not 0 < found < 100:
        raise ResultError(
            f"{source}{DOCUMENT}: {INTERVAL_PERCENT}: found {found!r}, expected a number between "
            "0 and 100"
        )


def read(folder: Path) -> StudyResult:
    """The result in a folder.

    Raises:
        ResultError: as `result` does; a file is missing or can't be read.
    """
    try:
        table = pd.read_parquet(folder / TABLE)
        document = json.loads((folder / DOCUMENT).read_text())
    except (OSError, ValueError) as error:
        raise ResultError(
            f"{folder}: expected {TABLE} and {DOCUMENT} of a study: {error}"
        ) from error
    return result(table, document, f"{folder}/")


def _check(table: pd.DataFrame, column: columns.Column, source: str) -> None:
    if column.name not in table:
        raise ResultError(
            f"{source}{TABLE}: found no column {column.name}, expected it ({column.what})"
        )
    kind = table[column.name].dtype.kind
    if kind not in KINDS[column.kind]:
        raise ResultError(
            f"{source}{TABLE}: column {column.name}: found {table[column.name].dtype}, "
            f"expected {column.kind}"
        )


def _scores(document: Mapping[str, Any], source: str) -> list[Score]:
    entries = document.get("scores")
    if not isinstance(entries, list):
        found = type(entries).__name__ if "scores" in document else "nothing"
        raise ResultError(f"{source}{DOCUMENT}: scores: found {found}, expected a list")
    return [_score(entry, f"{source}{DOCUMENT}: scores[{i}]") for i, entry in enumerate(entries)]


def _score(entry: Any, place: str) -> Score:
    if not isinstance(entry, dict):
        raise ResultError(f"{place}: found {entry!r}, expected an object")
    known = {field.name for field in fields(Score)}
    if unknown := sorted(set(entry) - known):
        raise ResultError(f"{place}: found {unknown[0]}, expected only {', '.join(sorted(known))}")
    numbers = {k: np.nan if entry.get(k) is None else entry[k] for k in ("value", "low", "high")}
    try:
        score = Score(**{**entry, **numbers})
    except TypeError as error:
        raise ResultError(f"{place}: {error}") from error
    predictors = ["", *(p.key for p in columns.PREDICTORS)]
    _known("score", score.score, list(scored.SCORES), place)
    _known("predictor", score.predictor, predictors, place)
    return score


def _known(key: str, found: str, expected: Sequence[str], place: str) -> None:
    if found not in expected:
        names = ", ".join(filter(None, expected))
        raise ResultError(f"{place}: found {key} {found}, expected one of {names}")
