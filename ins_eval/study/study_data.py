"""A finished study as its files hold it: flights, scores, facts; read and checked."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.study.specification import CONDITION, MEAN
from ins_eval.study.tables import columns
from ins_eval.study.tables import score as scored
from ins_eval.study.tables.columns import TABLE
from ins_eval.study.tables.score import Score
from pyhrg.common.errors import HrgError, quote
from pyhrg.common.reading.documents import read_json
from pyhrg.common.reading.limits import refuse_unreadable
from pyhrg.common.reading.parquet import read_parquet

DOCUMENT = "study.json"
INTERVAL_PERCENT = "interval_percent"
"""Key of study.json: probability of the predicted intervals, percent."""
CONDITIONS_KEY = "conditions"
"""Key of study.json: what differs in each condition, by its title."""
LEAD_KEY = "lead"
"""Key of study.json: the lead case, empty without one."""
PHASE_KEY = "phase_diagram"
"""Key of study.json: the phase diagram, empty without gyros that are calibrated at the mean."""
WITNESS_KEY = "witness"
"""Key of study.json: scores of the flights whose gyros' channels were read, empty without any."""
KINDS = {"int": "iu", "number": "f", "text": "OUT", "numbers": "O"}
"""Kinds of numpy arrays in which each kind of column may be stored."""


@dataclass(frozen=True)
class StudyData:
    """Flights and scores of a study.

    Attributes:
        table: rows of study.parquet.
        scores: scores of the flights.
        about: facts of study.json, such as seed and triads.
        conditions: flights and scores of the conditions, which are in neither of the others.
    """

    table: pd.DataFrame
    scores: Sequence[Score]
    about: Mapping[str, Any]
    conditions: "StudyData | None" = None

    @property
    def interval_percent(self) -> float:
        """Probability of the predicted intervals, percent."""
        return float(self.about[INTERVAL_PERCENT])

    @cached_property
    def calibrations(self) -> list[str]:
        """Calibrations of the study, the mean first, as every report shows them."""
        names = map(str, self.table[columns.CALIBRATION].unique())
        return sorted(names, key=lambda name: (name != MEAN, name))

    @cached_property
    def classes(self) -> list[str]:
        """Mission classes in the order of the study."""
        return list(map(str, dict.fromkeys(self.table[columns.CLASS])))

    @cached_property
    def missions(self) -> list[str]:
        """Missions in the order of the study."""
        return list(map(str, dict.fromkeys(self.table[columns.MISSION])))

    def select(self, score: str, **wanted: Any) -> list[Score]:
        """Scores of this key with these values of their fields; without negative controls, unless
        `shuffled` is given."""
        wanted = {"shuffled": False, "score": score, **wanted}
        return [s for s in self.scores if all(getattr(s, k) == v for k, v in wanted.items())]


def check_study_data(
    table: pd.DataFrame, document: Mapping[str, Any], source: str = ""
) -> StudyData:
    """A study from its table and document.

    Args:
        table: content of study.parquet.
        document: content of study.json: `scores` and facts.
        source: folder in messages.

    Raises:
        HrgError: a column or key is missing or of another kind; there are no rows.
    """
    if not len(table):
        raise HrgError(f"{source}{TABLE}: found no rows, expected one for each triad and mission")
    for column in columns.COLUMNS:
        _check_column(table, column, source)
    about = {k: v for k, v in document.items() if k != "scores"}
    scores = _read_scores(document, source)
    _check_level(about.get(INTERVAL_PERCENT), source)
    within = table[columns.ROLE] == CONDITION
    conditions = StudyData(table[within], [s for s in scores if s.role == CONDITION], about)
    return StudyData(
        table[~within],
        [s for s in scores if s.role != CONDITION],
        about,
        conditions if within.any() else None,
    )


def _check_level(found: Any, source: str) -> None:
    if not isinstance(found, int | float) or not 0 < found < 100:
        raise HrgError(
            f"{source}{DOCUMENT}: {INTERVAL_PERCENT}: found {found!r}, expected a number between "
            "0 and 100"
        )


def read_study_data(folder: Path) -> StudyData:
    """The study in a folder.

    Raises:
        HrgError: a file is missing or can't be read; or as `check_study_data`.
    """
    if not (folder / TABLE).exists():
        raise HrgError(
            f"{folder}: found no {TABLE}, expected the folder of a finished study: `hrg validate` "
            "or `hrg study` writes one"
        )
    table = read_parquet(folder / TABLE)
    document = read_json(folder / DOCUMENT)
    return check_study_data(table, document, f"{folder}/")


def _check_column(table: pd.DataFrame, column: columns.Column, source: str) -> None:
    if column.name not in table:
        raise HrgError(
            f"{source}{TABLE}: found no column {column.name}, expected it ({column.what})"
        )
    kind = table[column.name].dtype.kind
    if kind not in KINDS[column.kind]:
        raise HrgError(
            f"{source}{TABLE}: column {column.name}: found {table[column.name].dtype}, "
            f"expected {column.kind}"
        )


def _read_scores(document: Mapping[str, Any], source: str) -> list[Score]:
    entries = document.get("scores")
    if not isinstance(entries, list):
        found = type(entries).__name__ if "scores" in document else "nothing"
        raise HrgError(f"{source}{DOCUMENT}: scores: found {found}, expected a list")
    return [
        _read_score(entry, f"{source}{DOCUMENT}: scores[{i}]") for i, entry in enumerate(entries)
    ]


def _read_score(entry: Any, place: str) -> Score:
    if not isinstance(entry, dict):
        raise HrgError(f"{place}: found {entry!r}, expected an object")
    known = {field.name for field in fields(Score)}
    if unknown := sorted(set(entry) - known):
        raise HrgError(f"{place}: found {unknown[0]}, expected only {', '.join(sorted(known))}")
    numbers = {k: np.nan if entry.get(k) is None else entry[k] for k in ("value", "low", "high")}
    with refuse_unreadable(place, "score"):
        score = Score(**{**entry, **numbers})
        for field in fields(Score):
            value = getattr(score, field.name)
            kind: Any = int | float if field.type is float else field.type
            if not isinstance(value, kind):
                found = f"{field.name}: found {quote(value)}"
                raise HrgError(f"{place}: {found}, expected it as a study writes it")
            if field.type is float:
                float(value)  # an integer may be too large
    predictors = ["", *(p.key for p in columns.PREDICTORS), *columns.FIGURE_TITLES]
    _check_known("score", score.score, list(scored.SCORES), place)
    _check_known("predictor", score.predictor, predictors, place)
    return score


def _check_known(key: str, found: str, expected: Sequence[str], place: str) -> None:
    if found not in expected:
        names = ", ".join(filter(None, expected))
        raise HrgError(f"{place}: found {key} {found}, expected one of {names}")
