"""What a recorded IMU gives, and the numbers of its text files."""

import gzip
import io
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.errors import HrgError
from pyhrg.records.imu.increments import Increments

Array = NDArray[np.float64]

LEAST_ROWS = 10
"""Fewer tell neither an interval nor a unit."""
LARGEST = 1e12
"""Beyond any reading in any unit, and any time in s."""


class LogError(HrgError):
    """The file is no log of an IMU; the message names file, row, field, what was found and what
    expected."""


@dataclass(frozen=True)
class RecordedImu:
    """A log of an IMU.

    increments: body axes forward, right, down;
    position: (3,) latitude, longitude, rad, height, m, if the log says where it was taken;
    attitude: (3,) roll, pitch, yaw at the start as the log states them, coarse, rad, if it does;
    source: the file.
    """

    increments: Increments
    position: Array | None
    attitude: Array | None
    source: str


def content(path: Path) -> bytes:
    """A file's bytes, gzip undone if it is gzipped, whatever its name.

    Raises:
        LogError: unreadable, or gzipped data that is cut off or damaged.
    """
    try:
        data = path.read_bytes()
        return gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
    except EOFError as error:
        raise LogError(f"{path}: found gzipped data cut off, expected it whole") from error
    except (gzip.BadGzipFile, zlib.error) as error:
        raise LogError(f"{path}: found damaged gzipped data: {error}") from error
    except OSError as error:
        raise LogError(f"{path}: can't be read: {error.strerror or error}") from error


def decoded(source: str, data: bytes) -> list[str]:
    """Lines of a text file; without empty ones at its end.

    Raises:
        LogError: not UTF-8.
    """
    try:
        return data.decode("utf-8-sig").rstrip().splitlines()
    except UnicodeDecodeError as error:
        raise LogError(f"{source}: found what is no text: {error}") from error


def numbers(
    source: str,
    lines: Sequence[str],
    first_row: int,
    names: Sequence[str],
    delimiter: str | None = None,
    places: Sequence[int] | None = None,
    least: int = LEAST_ROWS,
) -> Array:
    """Values (n, m) of m fields in n lines, every one finite.

    Args:
        source: the file, for messages.
        lines: of values.
        first_row: the first one's number in the file; its first line is row 1.
        names: of the m fields, for messages.
        delimiter: between fields; None is white space.
        places: of the m among each line's fields; if None, there are no others.
        least: lines that there must be.

    Raises:
        LogError: too few lines, too few or too many fields, a field that is no finite number.
    """
    if len(lines) < least:
        raise LogError(f"{source}: found {len(lines)} rows of values, expected at least {least}")
    table = _quickly(lines, delimiter, places)
    if table is None or table.shape != (len(lines), len(names)):
        table = _carefully(source, lines, first_row, names, delimiter, places)
    check_finite(source, table, first_row, names)
    return table


def check_finite(source: str, table: Array, first_row: int, names: Sequence[str]) -> None:
    """Refuse values (n, m) that are not, or that are beyond anything measured.

    Raises:
        LogError: at the first one.
    """
    wrong = ~(np.abs(table) <= LARGEST)
    if wrong.any():
        row, column = np.argwhere(wrong)[0]
        value = table[row, column]
        expected = f"at most {LARGEST:g} in size" if np.isfinite(value) else "a finite number"
        raise log_error(source, first_row + row, names[column], f"{value}", expected)


def check_lengths(source: str, lines: Sequence[str], first_row: int, names: Sequence[str]) -> None:
    """Refuse lines that have not as many fields as there are names, by their commas.

    Raises:
        LogError: at the first one.
    """
    for row, line in enumerate(lines, first_row):
        if line.count(",") != len(names) - 1:
            raise _length_error(source, row, line.count(",") + 1 if line.strip() else 0, names)


def log_error(source: str, row: int, field: str, found: str, expected: str) -> LogError:
    """An error at one field of one row."""
    return LogError(f"{source}: row {row}, {field}: found {found}, expected {expected}")


def _length_error(source: str, row: int, found: int, names: Sequence[str]) -> LogError:
    return LogError(
        f"{source}: row {row}: found {found} fields, expected {len(names)}: {', '.join(names)}"
    )


def _quickly(
    lines: Sequence[str], delimiter: str | None, places: Sequence[int] | None
) -> Array | None:
    """None where a field is no number or rows differ in length."""
    text = io.StringIO("\n".join(lines))
    try:
        return np.loadtxt(text, delimiter=delimiter, comments=None, usecols=places, ndmin=2)
    except ValueError:
        return None


def _carefully(
    source: str,
    lines: Sequence[str],
    first_row: int,
    names: Sequence[str],
    delimiter: str | None,
    places: Sequence[int] | None,
) -> Array:
    """The same, or what is wrong."""
    table = np.empty((len(lines), len(names)))
    for i, line in enumerate(lines):
        fields = line.split(delimiter)
        if places is None and len(fields) != len(names):
            raise _length_error(source, first_row + i, len(fields), names)
        wanted = fields if places is None else [fields[place] for place in places]
        for j, (name, field) in enumerate(zip(names, wanted, strict=True)):
            table[i, j] = _number(source, first_row + i, name, field)
    return table


def _number(source: str, row: int, name: str, field: str) -> float:
    try:
        return float(field)
    except ValueError:
        found = repr(field.strip()) if field.strip() else "nothing"
        raise log_error(source, row, name, found, "a number") from None
