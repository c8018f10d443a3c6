"""Predictions of a challenge as a CSV: one row for each judged triad and mission."""

import math
from collections.abc import Collection
from itertools import zip_longest
from pathlib import Path

import pandas as pd

from ins_eval.study.tables import columns
from pyhrg.common.errors import HrgError, quote
from pyhrg.common.reading.csv_rows import parse_csv
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
