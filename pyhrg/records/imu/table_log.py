"""Logs of IMUs as tables: CSV, gzipped or not, and Parquet."""

import io
from collections.abc import Sequence

import numpy as np
import pandas as pd
import pyarrow
import pyarrow.csv

from pyhrg.common.arrays import Array
from pyhrg.common.reading.parquet import parse_parquet
from pyhrg.records.columns import LogError
from pyhrg.records.imu.log import (
    ACCELEROMETERS,
    GYROS,
    MIN_ROWS,
    PATTERN,
    ROTATION,
    TIME,
    VELOCITY,
    Increments,
    Quantity,
    RecordedImu,
    check_finite,
    check_lengths,
    choose_quantity,
    make_field_error,
    parse_numbers,
)
from pyhrg.records.imu.plausibility import Readings, check_plausibility

PARQUET = b"PAR1"
"""First bytes of a Parquet file."""
MAX_JITTER = 0.01
"""Largest departure of a time step from the interval, relative. Chosen."""
MIN_INTERVAL, MAX_INTERVAL = 1e-4, 1.0
"""Shortest and longest interval, s. Chosen."""


def read_csv(source: str, lines: list[str], trusted: bool) -> RecordedImu:
    """The log of a CSV file's lines: a header, then values. Unknown columns are ignored."""
    header = [name.strip() for name in lines[0].split(",")] if lines else []
    kinds = _choose_quantities(source, header)
    columns = _list_columns(kinds)
    check_lengths(source, lines[1:], 2, header)
    places = [header.index(name) for name in columns]
    values = parse_numbers(source, lines[1:], 2, columns, ",", places)
    return build_log(source, kinds, values, range(2, len(values) + 2), trusted)


def read_parquet(source: str, data: bytes, trusted: bool) -> RecordedImu:
    """The log of a Parquet file, whose first row of values is row 1."""
    frame = parse_parquet(source, data)
    kinds = _choose_quantities(source, [str(name) for name in frame.columns])
    columns = _list_columns(kinds)
    for name in columns:
        if frame[name].dtype.kind not in "fiu":
            raise LogError(f"{source}: column {name}: found {frame[name].dtype}, expected numbers")
    if len(frame) < MIN_ROWS:
        raise LogError(f"{source}: found {len(frame)} rows, expected at least {MIN_ROWS}")
    values = frame[columns].to_numpy(dtype=np.float64)
    check_finite(source, values, 1, columns)
    return build_log(source, kinds, values, range(1, len(values) + 1), trusted)


def format_table(increments: Increments, ending: str) -> bytes | None:
    """Increments as CSV (`.csv`) or Parquet (`.parquet`), which read back to the same bits; None
    for another ending."""
    columns = _list_columns((ROTATION, VELOCITY))
    values = (increments.bounds[1:], increments.rotation, increments.velocity)
    frame = pd.DataFrame(np.column_stack(values), columns=columns)
    if ending == ".parquet":
        return frame.to_parquet(index=False)
    if ending != ".csv":
        return None
    data = io.BytesIO(f"{','.join(columns)}\n".encode())
    data.seek(0, io.SEEK_END)
    options = pyarrow.csv.WriteOptions(include_header=False)
    pyarrow.csv.write_csv(pyarrow.Table.from_pandas(frame), data, options)
    return data.getvalue()


def _list_columns(kinds: tuple[Quantity, ...]) -> list[str]:
    return [TIME, *(column for kind in kinds for column in kind.columns)]


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _choose_quantities(source: str, header: list[str]) -> tuple[Quantity, ...]:
    """The quantities of gyros and accelerometers that a header has beside the time, and the pattern
    angle if it has any of its columns."""
    if not header:
        raise LogError(f"{source}: found an empty file, expected a header and values")
    if all(_is_number(name) for name in header[0].split()):
        raise LogError(
            f"{source}: row 1: found numbers, expected a header that names the columns (a table) "
            "or lines of % comments (PSINS); docs/imus.md shows both"
        )
    if TIME not in header:
        found = f"found no column {TIME} among {', '.join(header)}, expected it"
        raise LogError(
            f"{source}: {found}; docs/imus.md lists the columns of an IMU log, "
            "`hrg campaign init` reads a bench log of other columns"
        )
    kinds = [choose_quantity(source, header, among) for among in (GYROS, ACCELEROMETERS)]
    if any(column in header for column in PATTERN.columns):
        kinds.append(choose_quantity(source, header, [PATTERN]))
    return tuple(kinds)


def build_log(
    source: str,
    kinds: tuple[Quantity, ...],
    values: Array,
    rows: Sequence[int],
    trusted: bool,
    z: str = "down",
) -> RecordedImu:
    """The log of a table: time, gyros, accelerometers, and pattern angles if there are any.

    kinds: quantities of the columns after the time; values: (n, 7 or 10), body axes. For messages:
    rows: (n,) their numbers in the file; z: direction of the file's own z axis.
    """
    time, readings = values[:, 0], [values[:, 1:4], values[:, 4:7]]
    gyros, accelerometers, *pattern = kinds
    interval = _find_interval(source, time, rows)
    if not trusted:
        rate, force = (
            x / interval if k.integral else x
            for k, x in zip((gyros, accelerometers), readings, strict=True)
        )
        check_plausibility(Readings(source, interval, gyros, accelerometers, rate, force, z))
    rotation, velocity = (
        np.ascontiguousarray(k.factor * (x if k.integral else x * interval))
        for k, x in zip((gyros, accelerometers), readings, strict=True)
    )
    increments = Increments(interval, rotation, velocity, float(time[0]) - interval)
    angles = np.ascontiguousarray(PATTERN.factor * values[:, 7:]) if pattern else None
    return RecordedImu(increments, None, None, source, angles)


def _find_interval(source: str, time: Array, rows: Sequence[int]) -> float:
    steps = np.diff(time)
    interval = float(np.median(steps))
    wrong = steps <= 0
    if interval > 0:
        wrong |= np.abs(steps - interval) > MAX_JITTER * interval
    if wrong.any():
        i = int(np.argmax(wrong))
        trouble = _describe_step(float(steps[i]), interval)
        found = f"{time[i + 1]:.10g} after {time[i]:.10g}"
        raise make_field_error(source, rows[i + 1], TIME, found, trouble)
    if not MIN_INTERVAL <= interval <= MAX_INTERVAL:
        expected = f"{MIN_INTERVAL:g} s to {MAX_INTERVAL:g} s"
        raise make_field_error(source, rows[1], TIME, f"steps of {interval:g} s", expected)
    return float(time[-1] - time[0]) / len(steps)


def _describe_step(step: float, interval: float) -> str:
    if step == 0:
        return "each time once"
    if step < 0:
        return "time to increase"
    if step > 1.5 * interval:
        return f"steps of {interval:.6g} s: are {round(step / interval) - 1} rows missing?"
    return f"steps of {interval:.6g} s, even to {MAX_JITTER:.0%}"
