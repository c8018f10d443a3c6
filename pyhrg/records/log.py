"""A log: what bench and gyro recorded during one test of one power-on."""

import gzip
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pyhrg.common.files import write_whole
from pyhrg.records import mixups, saturation, timing
from pyhrg.records.columns import BY_FIELD, COLUMNS, LogError
from pyhrg.records.table import Array, Table, read_table


@dataclass(frozen=True)
class Log:
    """One row an interval. SI, each (n,); NaN where a value is missing, all through where its
    column is.

    Forces and frequency are means over the interval, angles are taken at its end.
    """

    source: str
    """File name, for messages."""
    interval: float
    """Sampling interval, s."""
    time: Array
    """End of the interval, s."""
    table_angle: Array
    """Turntable encoder about the input axis, rad."""
    axis_up: Array
    """Projection of the input axis on local up; 0: level and pointing east."""
    acceleration_x: Array
    """Specific force in the gyro's frame, m/s2; z is the input axis."""
    acceleration_y: Array
    acceleration_z: Array
    temperature: Array
    """Of the case, K."""
    virtual_rotation: Array
    """Commanded rotation as an input rate, rad/s: the pattern turns by + Bryan factor times it."""
    amplitude_setpoint: Array
    """Nominal 1."""
    phase_offset: Array
    """Added to the detected phase, rad."""
    drive_on: Array
    """1, or 0 while amplitude, quadrature and rotation forces are off."""
    gyro_angle: Array
    """The gyro's output, rad; positive with the case's rotation."""
    wave_angle: Array
    """Detected pattern angle, physical, continuous, rad."""
    amplitude: Array
    """Detected antinode amplitude; nominal 1."""
    amplitude_force: Array
    """Over detected amplitude, 1/s."""
    quadrature_force: Array
    """Amplitude units per second, 1/s."""
    frequency_offset: Array
    """Loop frequency less the nominal one, rad/s."""
    valid: Array
    """Share of the interval in which the output was valid."""
    exclusions: tuple[str, ...] = ()
    """What was left out on reading, a sentence each; rows are the file's, its header is row 1."""

    def require(self, *fields: str) -> None:
        """Ask for columns by field.

        Raises:
            LogError: one has no value at all.
        """
        there = [c.name for c in COLUMNS if np.isfinite(getattr(self, c.field)).any()]
        missing = [BY_FIELD[f].name for f in fields if BY_FIELD[f].name not in there]
        if missing:
            raise LogError(
                f"{self.source}: column {', '.join(missing)} is missing or has no values; "
                f"found {', '.join(there)}"
            )

    def stretches(self, *fields: str) -> list[slice]:
        """Rows without a gap whose values in all these fields are there.

        Raises:
            LogError: a field has no value at all.
        """
        self.require(*fields)
        known = np.isfinite(np.stack([getattr(self, f) for f in ("time", *fields)])).all(axis=0)
        joined = timing.even_steps(self.time, self.interval) & known[1:] & known[:-1]
        starts = np.flatnonzero(known & ~np.append(False, joined))
        ends = np.flatnonzero(known & ~np.append(joined, False)) + 1
        return [slice(int(a), int(b)) for a, b in zip(starts, ends, strict=True)]


def read(path: Path, interval: float | None = None, latitude: float | None = None) -> Log:
    """Read a log from CSV, gzipped or not.

    Rows without time, rows that repeat an earlier one, missing values and saturated stretches are
    left out, gaps and unknown columns are noted: `Log.exclusions`.

    Args:
        path: of the file.
        interval: sampling interval, s; the median time step where it isn't given.
        latitude: of the site, rad; with it Earth's rate is looked for in the gyro's angle.

    Raises:
        LogError: an unreadable file, a column twice or under another unit, no times, too few rows,
            a field that is no number or out of range, one time with different values, time that
            runs back, steps that contradict the interval, values in another unit than the
            header says.
    """
    return checked(read_table(path), interval, latitude)


def checked(table: Table, interval: float | None = None, latitude: float | None = None) -> Log:
    """The log that a table holds; see `read`.

    Raises:
        LogError: what is wrong with rows or values, as `read`.
    """
    table = timing.ordered(table)
    interval = timing.interval_of(table, interval)
    table = timing.with_gaps_noted(_with_missing_noted(table), interval)
    table = saturation.without_saturation(table, interval)
    mixups.check_units(table, interval)
    if latitude is not None:
        mixups.check_earth_rate(table, interval, latitude)
    return Log(table.source, interval, exclusions=table.notes, **table.columns)


def write(log: Log, path: Path) -> None:
    """Write a log as CSV, gzipped where the name ends in .gz; the same log gives the same bytes.

    Columns without any value are not written.

    Raises:
        OSError: the folder can't be written.
    """
    columns = [c for c in COLUMNS if np.isfinite(getattr(log, c.field)).any()]
    values = [(getattr(log, c.field) - c.offset) / c.factor for c in columns]
    form = ",".join(f"%.{c.digits}g" for c in columns)
    rows = zip(*(v.tolist() for v in values), strict=True)
    lines = [",".join(c.name for c in columns), *(form % row for row in rows)]
    data = "".join(f"{line}\n" for line in lines).encode()
    write_whole(
        path, gzip.compress(data, compresslevel=6, mtime=0) if path.suffix == ".gz" else data
    )


def _with_missing_noted(table: Table) -> Table:
    for column in COLUMNS:
        missing = np.isnan(table.columns[column.field])
        if missing.all():
            if not column.optional and f"no column {column.name}" not in table.notes:
                table = table.noted(missing, f"{column.name} missing")
        else:
            table = table.noted(missing, f"{column.name} missing")
    return table
