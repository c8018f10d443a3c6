"""A log: what bench and gyro recorded during one test of one power-on."""

import gzip
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.errors import describe_briefly
from pyhrg.common.files import write_whole
from pyhrg.common.units import DEG
from pyhrg.records import mixups, saturation, timing
from pyhrg.records.columns import BY_FIELD, COLUMNS, LogError
from pyhrg.records.table import Table, read_table


@dataclass(frozen=True)
class Log:
    """Columns of n rows, one row an interval; SI.

    A missing value is NaN; a missing column is all NaN. Forces, frequency, specific force and
    commanded rotation are means over the interval; angles are those at its end.
    """

    source: str
    """Name of the file, for messages."""
    interval: float
    """Sampling interval, s."""
    time: Array
    """End of the interval, s."""
    table_angle: Array
    """Turntable encoder about the input axis, rad."""
    axis_up: Array
    """Projection of the input axis on local up; 0: the axis is level and points east."""
    acceleration_x: Array
    """Specific force in the gyro's frame, m/s2; z is the input axis."""
    acceleration_y: Array
    acceleration_z: Array
    temperature: Array
    """Temperature of the case, K."""
    virtual_rotation: Array
    """Commanded rotation as an input rate, rad/s; it turns the pattern by angular gain times it."""
    amplitude_setpoint: Array
    """Commanded amplitude; nominal 1."""
    phase_offset: Array
    """Commanded offset that is added to the detected phase, rad."""
    drive_on: Array
    """1, or 0 while amplitude, quadrature and rotation forces are off."""
    gyro_angle: Array
    """The gyro's output, rad; positive with the case's rotation."""
    wave_angle: Array
    """Detected pattern angle, physical, continuous, rad."""
    amplitude: Array
    """Detected antinode amplitude; nominal 1."""
    amplitude_force: Array
    """Force of the amplitude loop over the detected amplitude, 1/s."""
    quadrature_force: Array
    """Force of the quadrature loop in amplitudes per second, 1/s."""
    frequency_offset: Array
    """Frequency of the phase loop less the nominal one, rad/s."""
    valid: Array
    """Share of the interval in which the output was valid."""
    exclusions: tuple[str, ...] = ()
    """What reading left out, a sentence each; rows are numbered as in the file, from the header."""

    __repr__ = describe_briefly

    @property
    def is_driven(self) -> Mask:
        """(n,) whether the drive is on; False where that is not known."""
        return np.asarray(self.drive_on > 0.5)

    @property
    def is_free(self) -> Mask:
        """(n,) whether the drive is off; False where that is not known."""
        return np.asarray(self.drive_on <= 0.5)

    def require(self, *fields: str) -> None:
        """Check that each of these fields has a value in some row.

        Raises:
            LogError: a field has no value at all.
        """
        missing = [BY_FIELD[field].name for field in fields if not self.has_values(field)]
        if missing:
            raise LogError(
                f"{self.source}: column {', '.join(missing)} is missing or has no values"
            )

    def has_values(self, *fields: str) -> bool:
        """Whether each of these fields has a value in some row."""
        return all(bool(np.isfinite(getattr(self, field)).any()) for field in fields)

    def section(self, rows: slice) -> "Log":
        """These rows of the log, with the times that they have in it."""
        columns: dict[str, Any] = {c.field: getattr(self, c.field)[rows] for c in COLUMNS}
        return replace(self, **columns)

    def to_frame(self) -> pd.DataFrame:
        """The log's columns in SI under their fields' names, one row an interval.

        `attrs["units"]` has the unit of each column, `attrs["source"]` the file.
        """
        frame = pd.DataFrame({c.field: getattr(self, c.field) for c in COLUMNS})
        frame.attrs["units"] = {c.field: c.si_unit or "1" for c in COLUMNS}
        frame.attrs["source"] = self.source
        return frame

    def stretches(self, *fields: str) -> list[slice]:
        """List the stretches of rows without a gap in time and without a missing value in these
        fields.

        Raises:
            LogError: a field has no value at all.
        """
        self.require(*fields)
        known = np.isfinite(np.stack([getattr(self, f) for f in ("time", *fields)])).all(axis=0)
        is_joined = timing.find_even_steps(self.time, self.interval) & known[1:] & known[:-1]
        starts = np.flatnonzero(known & ~np.append(False, is_joined))
        ends = np.flatnonzero(known & ~np.append(is_joined, False)) + 1
        return [slice(int(a), int(b)) for a, b in zip(starts, ends, strict=True)]


def read_log(
    path: Path | str,
    *,
    interval_s: float | None = None,
    latitude_deg: float | None = None,
    any_sign: bool = False,
) -> Log:
    """Read a log from a CSV file (docs/records.md), gzipped or not.

    These rows are dropped: rows without a time, rows that repeat an earlier one, and a few rows
    that are out of order or contradict another of the same time. Missing and saturated values
    become NaN; their rows stay. `Log.exclusions` has a sentence on each, on gaps and on unknown
    columns.

    Args:
        path: the file.
        interval_s: sampling interval, s; the median time step if None.
        latitude_deg: geodetic latitude of the site; with it, the gyro's angle must show Earth's
            rate.
        any_sign: whether the table's angle may have the opposite sign of the gyro's. A diagnosis
            finds and reverses such a sign; all else refuses it.

    Raises:
        HrgError: the file can't be read; a column is there twice or under another unit; there are
            no times or too few rows; a field is no number or out of range; more than a few times
            have different values or run back; time steps contradict the interval; values are in
            another unit than the header says.
    """
    table = read_table(Path(path))
    latitude = None if latitude_deg is None else latitude_deg * DEG
    return build_log(table, interval_s, latitude, any_sign)


def build_log(
    table: Table, interval: float | None, latitude: float | None, any_sign: bool = False
) -> Log:
    """A log of a table's rows, checked and with notes on what was left out. The interval is in s,
    by default the median time step; without the site's latitude, rad, Earth's rate is not looked
    for; `any_sign` as in `read_log`."""
    table = timing.drop_wrong_rows(table)
    interval = timing.find_interval(table, interval)
    table = timing.note_gaps(_note_missing_values(table), interval)
    table = saturation.remove_saturation(table, interval)
    mixups.check_units(table, interval, any_sign)
    if latitude is not None:
        mixups.check_earth_rate(table, interval, latitude)
    return Log(table.source, interval, exclusions=table.notes, **table.columns)


def write_log(log: Log, path: Path) -> None:
    """Write a log as CSV, gzipped if the name ends in .gz; the same log gives the same bytes.

    Columns without any value are not written.

    Raises:
        OSError: the folder can't be written.
    """
    columns = [c for c in COLUMNS if np.isfinite(getattr(log, c.field)).any()]
    values = [(getattr(log, c.field) - c.offset) / c.factor for c in columns]
    formats, varying = [], []
    for column, series in zip(columns, values, strict=True):
        text = f"%.{column.digits}g"
        is_constant = series.tobytes() == series[:1].tobytes() * len(series)
        formats.append(text % series[0] if is_constant else text)
        varying += [] if is_constant else [series.tolist()]
    line = ",".join(formats) + "\n"
    rows = zip(*varying, strict=True) if varying else [()] * len(log.time)
    names = ",".join(c.name for c in columns) + "\n"
    data = (names + "".join(map(line.__mod__, rows))).encode()
    write_whole(
        path, gzip.compress(data, compresslevel=4, mtime=0) if path.suffix == ".gz" else data
    )


def _note_missing_values(table: Table) -> Table:
    values = [table.columns[column.field] for column in COLUMNS if column.field != "time"]
    is_empty = np.all(np.isnan(values), axis=0)
    table = table.add_note(is_empty, "no values but a time")
    for column in COLUMNS:
        missing = np.isnan(table.columns[column.field])
        is_known = column.optional or f"no column {column.name}" in table.notes
        if not (missing.all() and is_known):
            table = table.add_note(missing & ~is_empty, f"{column.name} missing")
    return table
