"""Logs of IMUs as tables: CSV, gzipped or not, and Parquet."""

import gzip
import io
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow
import pyarrow.csv

from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.records.columns import LogError
from pyhrg.records.imu.columns import (
    ACCELEROMETERS,
    GYROS,
    ROTATION,
    TIME,
    VELOCITY,
    choose_quantity,
    compute_increments,
    compute_means,
)
from pyhrg.records.imu.increments import Increments
from pyhrg.records.imu.log import (
    MIN_ROWS,
    Array,
    RecordedImu,
    check_finite,
    check_lengths,
    parse_numbers,
)
from pyhrg.records.imu.plausibility import Readings, check_plausibility
from pyhrg.records.imu.timing import find_interval

PARQUET = b"PAR1"
"""First bytes of a Parquet file."""


def read_csv(source: str, lines: list[str], trusted: bool) -> RecordedImu:
    """The log of a CSV file's lines: a header, then values. Unknown columns are ignored.

    Raises:
        LogError: see `read_imu_log`.
    """
    header = [name.strip() for name in lines[0].split(",")] if lines else []
    columns = _choose_columns(source, header)
    check_lengths(source, lines[1:], 2, header)
    places = [header.index(name) for name in columns]
    values = parse_numbers(source, lines[1:], 2, columns, ",", places)
    return _build_log(source, columns, values, 2, trusted)


def read_parquet(source: str, data: bytes, trusted: bool) -> RecordedImu:
    """The log of a Parquet file, whose first row of values is row 1.

    Raises:
        LogError: see `read_imu_log`.
    """
    try:
        frame = pd.read_parquet(io.BytesIO(data))
    except (pyarrow.ArrowException, OSError, ValueError) as error:
        raise LogError(f"{source}: found damaged Parquet: {error}") from error
    columns = _choose_columns(source, [str(name) for name in frame.columns])
    for name in columns:
        if frame[name].dtype.kind not in "fiu":
            raise LogError(f"{source}: column {name}: found {frame[name].dtype}, expected numbers")
    if len(frame) < MIN_ROWS:
        raise LogError(f"{source}: found {len(frame)} rows, expected at least {MIN_ROWS}")
    values = frame[columns].to_numpy(dtype=np.float64)
    check_finite(source, values, 1, columns)
    return _build_log(source, columns, values, 1, trusted)


def write_imu_log(increments: Increments, path: Path) -> None:
    """Write increments as CSV (`.csv`, `.csv.gz`) or Parquet (`.parquet`), whole or not at all.

    The increments read back to the same bits, interval and start to 1e-12.

    Raises:
        HrgError: the name has another ending.
        OSError: the folder can't be written.
    """
    columns = [TIME, *ROTATION.columns, *VELOCITY.columns]
    values = (increments.bounds[1:], increments.rotation, increments.velocity)
    frame = pd.DataFrame(np.column_stack(values), columns=columns)
    if path.name.endswith(".parquet"):
        write_whole(path, frame.to_parquet(index=False))
    elif path.name.endswith((".csv", ".csv.gz")):
        data = _format_csv(frame)
        write_whole(path, gzip.compress(data, mtime=0) if path.suffix == ".gz" else data)
    else:
        raise HrgError(f"{path}: found {path.suffix!r}, expected .csv, .csv.gz or .parquet")


def _format_csv(frame: pd.DataFrame) -> bytes:
    """Format each number as the shortest text that reads back to the same bits."""
    buffer = io.BytesIO(f"{','.join(frame.columns)}\n".encode())
    buffer.seek(0, io.SEEK_END)
    options = pyarrow.csv.WriteOptions(include_header=False)
    pyarrow.csv.write_csv(pyarrow.Table.from_pandas(frame), buffer, options)
    return buffer.getvalue()


def _choose_columns(source: str, header: list[str]) -> list[str]:
    """Names of the columns that are used: time, gyros, accelerometers."""
    if not header:
        raise LogError(f"{source}: found an empty file, expected a header and values")
    if TIME not in header:
        raise LogError(f"{source}: found no column {TIME} among {', '.join(header)}, expected it")
    kinds = (choose_quantity(source, header, among) for among in (GYROS, ACCELEROMETERS))
    return [TIME, *(column for kind in kinds for column in kind.columns)]


def _build_log(
    source: str, columns: list[str], values: Array, first_row: int, trusted: bool
) -> RecordedImu:
    gyros, accelerometers = (
        choose_quantity(source, columns, among) for among in (GYROS, ACCELEROMETERS)
    )
    time, angle, force = values[:, 0], values[:, 1:4], values[:, 4:]
    interval = find_interval(source, time, first_row)
    if not trusted:
        rate = compute_means(gyros, angle, interval)
        force_unit = compute_means(accelerometers, force, interval)
        check_plausibility(Readings(source, interval, gyros, accelerometers, rate, force_unit))
    return RecordedImu(
        Increments(
            interval,
            np.ascontiguousarray(compute_increments(gyros, angle, interval)),
            np.ascontiguousarray(compute_increments(accelerometers, force, interval)),
            float(time[0]) - interval,
        ),
        None,
        None,
        source,
    )
