"""Predictions of a challenge as a CSV (one row for each judged triad and mission), and scores of
predictors: R2, rank correlation, coverage, weighted interval score.
"""

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.study.scores import measures
from ins_eval.study.scores.coverage import estimate_coverage
from ins_eval.study.scores.groups import FlightGroup, group_flights
from ins_eval.study.scores.resampling import bootstrap
from ins_eval.study.specification import TEST, TRAIN
from ins_eval.study.tables import columns
from ins_eval.study.tables.columns import Predictor
from pyhrg.common.errors import HrgError, describe_briefly, quote
from pyhrg.common.pages.svg import format_interval
from pyhrg.common.reading.documents import parse_csv
from pyhrg.common.units import NAUTICAL_MILE
from pyhrg.records.table import read_text

Flight = tuple[int, str]
"""Number of a triad, and name of a mission."""
LOW, MEDIAN, HIGH = "low_m", "median_m", "high_m"
"""Columns of the predicted horizontal error: its median and the ends of its interval, m."""
FIELDS = (columns.TRIAD, columns.MISSION, LOW, MEDIAN, HIGH)


def read_predictions(path: Path, flights: Collection[Flight]) -> pd.DataFrame:
    """Predictions with the columns `FIELDS`.

    Args:
        path: the file; other columns are ignored.

    Raises:
        HrgError: a column or a flight is missing, twice there or unknown; a number is not
            finite, negative, or not in the order low, median, high.
    """
    lines = parse_csv(path, read_text(path))
    _, header = next(lines, (0, []))
    for name in FIELDS:
        if name not in header:
            raise HrgError(f"{path}: found no column {name}, expected {', '.join(FIELDS)}")
    rows: dict[Flight, tuple[float, ...]] = {}
    for line, fields in lines:
        place = f"{path}: line {line}"
        row = dict(zip_longest(header, fields[: len(header)], fillvalue=""))
        flight = _read_flight(row, flights, place)
        if flight in rows:
            raise HrgError(f"{place}: triad: found {flight} again, expected it once")
        rows[flight] = _read_numbers(row, place)
    if missing := sorted(set(flights) - rows.keys()):
        raise HrgError(
            f"{path}: found no row for triad {missing[0][0]}, mission {missing[0][1]}, expected "
            f"all {len(flights)} judged flights; {len(missing)} are missing"
        )
    return pd.DataFrame([(*flight, *rows[flight]) for flight in sorted(rows)], columns=FIELDS)


def _read_flight(row: dict[str, str], flights: Collection[Flight], place: str) -> Flight:
    text, mission = row[columns.TRIAD], row[columns.MISSION]
    missions = sorted({name for _, name in flights})
    if mission not in missions:
        expected = " or ".join(missions)
        raise HrgError(f"{place}: mission: found {quote(mission)}, expected {expected}")
    judged = {str(triad): triad for triad, name in sorted(flights) if name == mission}
    if text not in judged:
        numbers = list(judged)
        raise HrgError(
            f"{place}: triad: found {quote(text)}, expected one that is judged, {numbers[0]} to "
            f"{numbers[-1]}"
        )
    return judged[text], mission


def _read_numbers(row: dict[str, str], place: str) -> tuple[float, ...]:
    """Low end, median and high end, m."""
    numbers, least, below = [], 0.0, "0"
    for name in (LOW, MEDIAN, HIGH):
        try:
            number = float(row[name])
        except ValueError:
            number = math.nan
        if not least <= number < math.inf:
            found = f"found {quote(row[name])}, expected a number from {below}"
            raise HrgError(f"{place}: {name}: {found}")
        numbers.append(number)
        least, below = number, f"{name}, {number:g}"
    return tuple(numbers)


NAIVE = Predictor("naive", "Training triads' median", "the errors of the training triads alone")
"""The predictor that looks at no gyro: quantiles of the training triads' errors."""
SCORES = {
    "r2": "R2",
    "spearman": "Spearman",
    "coverage": "coverage",
    "interval_score_nmi": "interval score, nmi",
}
"""Titles of the scores by column; `_low` and `_high` are the ends of their 95 % intervals."""


@dataclass(frozen=True)
class ChallengeScores:
    """Scores of predictors.

    Attributes:
        table: a row for each class of missions and predictor, with n, seed, and `SCORES` with their
            intervals.
    """

    table: pd.DataFrame

    __repr__ = describe_briefly

    def __str__(self) -> str:
        return "\n\n".join(
            "\n".join(_format_class(str(name), rows))
            for name, rows in self.table.groupby(columns.CLASS, sort=False)
        )


def score_predictions(
    table: pd.DataFrame, outside: Mapping[str, pd.DataFrame], seed: int, inside: float
) -> ChallengeScores:
    """Scores of all predictors: the naive one, ours, those from outside.

    Args:
        table: a study's table, with one calibration.
        outside: predictions by name of their predictor (`read_predictions`).
        inside: probability of the predicted intervals.
    """
    judged = _add_naive(table, inside)
    predictors = [NAIVE, *columns.PREDICTORS]
    for number, (title, predictions) in enumerate(outside.items()):
        predictor = Predictor(f"outside_{number}", title, "")
        names = {LOW: predictor.low, MEDIAN: predictor.median, HIGH: predictor.high}
        keys = [columns.TRIAD, columns.MISSION]
        judged = judged.merge(predictions.rename(columns=names), on=keys, validate="1:1")
        predictors.append(predictor)
    rows = [
        _score_predictor(group, predictor, seed, inside)
        for group in group_flights(judged)
        for predictor in predictors
    ]
    return ChallengeScores(pd.DataFrame(rows))


def _add_naive(table: pd.DataFrame, inside: float) -> pd.DataFrame:
    """The judged flights, with the naive predictor's columns."""
    training = table[table[columns.ROLE] == TRAIN].groupby(columns.MISSION)[columns.FLOWN_RADIAL]
    judged = table[table[columns.ROLE] == TEST].copy()
    shares = {
        NAIVE.low: (1 - inside) / 2,
        NAIVE.median: 0.5,
        NAIVE.high: (1 + inside) / 2,
    }
    for name, share in shares.items():
        judged[name] = judged[columns.MISSION].map(training.quantile(share))
    return judged


def _score_predictor(
    group: FlightGroup, predictor: Predictor, seed: int, inside: float
) -> dict[str, Any]:
    flown = group.select(columns.FLOWN_RADIAL)
    low, median, high = map(group.select, (predictor.low, predictor.median, predictor.high))
    interval_score = partial(measures.compute_interval_score, inside=inside)
    samples = [each / NAUTICAL_MILE for each in (flown, low, median, high)]
    estimates = {
        "r2": bootstrap(measures.compute_r2, [flown, median], seed),
        "spearman": bootstrap(measures.compute_flight_spearman, [flown, median], seed),
        "coverage": estimate_coverage(flown, low, high, seed),
        "interval_score_nmi": bootstrap(interval_score, samples, seed),
    }
    row: dict[str, Any] = {columns.CLASS: group.mission_class, "predictor": predictor.title}
    row |= {"n": group.triads, "seed": seed}
    for name, estimate in estimates.items():
        row |= {name: estimate.value, f"{name}_low": estimate.low, f"{name}_high": estimate.high}
    return row


def _format_class(name: str, rows: pd.DataFrame) -> Iterator[str]:
    width = max(map(len, rows["predictor"]))
    yield f"{name}: n = {rows['n'].iloc[0]} triads; in brackets 95 % intervals"
    yield " ".join(["".ljust(width), *(title.ljust(28) for title in SCORES.values())]).rstrip()
    for _, row in rows.iterrows():
        cells = (_format_score(*row[[key, f"{key}_low", f"{key}_high"]]) for key in SCORES)
        yield " ".join([row["predictor"].ljust(width), *(c.ljust(28) for c in cells)]).rstrip()


def _format_score(value: float, low: float, high: float) -> str:
    if not np.isfinite(value):
        return "not defined"
    return format_interval(value, low, high)
