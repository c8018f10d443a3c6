"""A static record: one channel for each sensor, independent of the file format."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.files import read_unpacked
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.gap.static_record.terms import ACCELEROMETER, GYRO, Kind
from pyhrg.records import Log, read_log
from pyhrg.records.imu import recorded
from pyhrg.records.missing_inputs import (
    TURNING_RATE,
    TURNING_TIME,
    find_turning_times,
    note_missing_inputs,
)
from pyhrg.records.table import ABSENT_COLUMN

MIN_READINGS = 1024
"""Smallest number of readings of a channel; half of them are held out (chosen)."""
MAX_TURN = 0.1 * DEG
"""Turn of the table, rad, up to which a log is one of a gyro at rest. Chosen: above what an encoder
reads at rest."""
MIN_CREEP = 1 * DEG
"""Creep of the pattern, rad, from which its bias map is named. Chosen: it changes a fourth harmonic
of the bias by 7 % of the amplitude."""
MOTION_SIGMAS = 10.0
"""Departure of a mean rate from the median, over its noise, above which a gyro turned. Chosen."""
BENCH_COLUMN = b"gyro_angle_deg"
HEADER_BYTES = 4096
"""Bytes at the start of a file in which the header of a table is expected."""


@dataclass(frozen=True)
class Channel:
    """The readings of one sensor at rest.

    interval: between readings, s.
    angle: (n,) integral of the sensed quantity (angle or velocity), SI, evenly spaced, without
        gaps.
    temperature: (n,) K; None where it was not logged.
    quantization_step: of the readings, SI; None where they lie on no grid.
    may_drift: whether a ramp of the rate is expected, so that it is no gap.
    mean: of the sensed quantity over all readings, SI; `angle` is without it.
    """

    name: str
    kind: Kind
    interval: float
    angle: Array
    temperature: Array | None = None
    quantization_step: float | None = None
    may_drift: bool = False
    mean: float = 0.0

    def part(self, first: int, last: int) -> "Channel":
        """The channel with readings first to last - 1."""
        temperature = None if self.temperature is None else self.temperature[first:last]
        return replace(self, angle=self.angle[first:last], temperature=temperature)

    @property
    def half(self) -> int:
        """Index of the first held-out reading."""
        return len(self.angle) // 2


@dataclass(frozen=True)
class StaticRecord:
    """The channels of one record; notes: a sentence on each thing that was left out of it."""

    source: str
    channels: tuple[Channel, ...]
    notes: tuple[str, ...] = ()


def read_static_record(path: Path, trusted: bool = False) -> StaticRecord:
    """Read the log of an IMU (`pyhrg.records.imu`; body axes forward, right,
    down) or a bench log (`pyhrg.records`).

    Args:
        path: of the file.
        trusted: whether an IMU's units and axes are taken as stated, though gravity or Earth's
            rate in it contradict them.

    Raises:
        HrgError: the file can't be used or is too short, or a channel never changes.
    """
    if path.is_dir():
        raise HrgError(
            f"{path}: found a folder, expected a log, such as one in a campaign's folder"
        )
    if BENCH_COLUMN in read_unpacked(path)[:HEADER_BYTES]:
        return _take_bench_log(read_log(path))
    imu = recorded.read_imu_log(path, trusted).increments
    channels = [
        channel_from_increments(f"{kind.name}_{axis}", kind, imu.interval, values)
        for kind, triad in ((GYRO, imu.rotation), (ACCELEROMETER, imu.velocity))
        for axis, values in zip("xyz", triad.T, strict=True)
    ]
    notes = [_describe_motion(channel) for channel in channels if channel.kind is GYRO]
    return StaticRecord(path.name, tuple(channels), tuple(note for note in notes if note))


def channel_from_increments(
    name: str, kind: Kind, interval: float, increments: Array, temperature: Array | None = None
) -> Channel:
    """A channel from readings (n,) that are increments of angle or velocity, SI.

    Too few readings, one that is not finite, or readings that are all equal are refused.
    """
    increments = np.asarray(increments, dtype=np.float64)
    if len(increments) < MIN_READINGS:
        raise HrgError(f"{name}: found {len(increments)} readings, expected {MIN_READINGS} or more")
    if not np.all(np.isfinite(increments)):
        row = int(np.argmin(np.isfinite(increments)))
        raise HrgError(f"{name}: reading {row}: found {increments[row]}, expected a number")
    if np.ptp(increments) == 0:
        raise HrgError(f"{name}: found {increments[0]:g} in all readings, expected noise")
    mean = float(np.mean(increments))
    step = find_quantization_step(increments)
    angle = np.cumsum(increments - mean)
    return Channel(name, kind, interval, angle, temperature, step, mean=mean / interval)


def _take_bench_log(log: Log) -> StaticRecord:
    """The output angle of a bench log less the turntable's angle, over its longest stretch without
    gaps. The pattern creeps over the gyro's bias map at Earth's rate, so a rate ramp is expected.
    Columns that are not there are no loss, but for the table's angle.
    """
    notes = [note for note in log.exclusions if not note.startswith(ABSENT_COLUMN)]
    if not log.has_values("table_angle"):
        _refuse_turning(log)
        notes.append(note_missing_inputs("table_angle"))
        log = replace(log, table_angle=np.zeros(len(log.time)))
    stretch, gaps = _choose_stretch(log)
    notes += [*gaps, *_describe_stretch(log, stretch)]
    angle = (log.gyro_angle - log.table_angle)[stretch]
    temperature = log.temperature[stretch]
    is_known = bool(np.all(np.isfinite(temperature)))
    channel = channel_from_increments(
        *("gyro", GYRO, log.interval, np.diff(angle)), temperature[1:] if is_known else None
    )
    return StaticRecord(log.source, (replace(channel, may_drift=True),), tuple(notes))


def _choose_stretch(log: Log) -> tuple[slice, list[str]]:
    """Rows of the longest stretch without gaps, and a sentence where there are gaps.

    Raises:
        HrgError: no row has both angles, or gaps leave too few rows.
    """
    stretches = log.stretches("gyro_angle", "table_angle")
    if not stretches:
        raise HrgError(
            f"{log.source}: no row has gyro_angle_deg and table_angle_deg; expected more than "
            f"{MIN_READINGS}"
        )
    stretch = max(stretches, key=lambda s: s.stop - s.start)
    if len(stretches) == 1:
        return stretch, []
    count = stretch.stop - stretch.start
    begin, end = log.time[stretch][[0, -1]]
    gaps = (
        f"gaps part it into {len(stretches)} stretches: only the longest is used, "
        f"{begin:.6g} to {end:.6g} s, {count} of {len(log.time)} rows"
    )
    if count <= MIN_READINGS:
        raise HrgError(f"{log.source}: {gaps}; expected more than {MIN_READINGS} rows")
    return stretch, [gaps]


def _describe_stretch(log: Log, stretch: slice) -> list[str]:
    """Sentences where the table turned, or the pattern crept."""
    notes = []
    turn = float(np.ptp(log.table_angle[stretch]))
    if turn > MAX_TURN:
        notes.append(
            f"not at rest: the table turned through {turn / DEG:.4g} deg. Its angle is taken out; "
            "the gyro's scale-factor error and its bias at other pattern angles are in the figures"
        )
    pattern = log.wave_angle[stretch][np.isfinite(log.wave_angle[stretch])]
    creep = float(np.ptp(pattern)) if len(pattern) else 0.0
    if creep > MIN_CREEP:
        notes.append(
            f"the pattern crept by {creep / DEG:.3g} deg: bias over the pattern angle is in rate "
            "random walk and rate ramp; `hrg bench random-walk` on a campaign takes it out"
        )
    return notes


def _refuse_turning(log: Log) -> None:
    """Refuse a log without the table's angle whose gyro turned, and say when."""
    times = find_turning_times(log)
    if len(times):
        raise HrgError(
            f"{log.source}: the gyro turned, first at {times[0]:.6g} s, last at {times[-1]:.6g} s, "
            "and no table_angle_deg says how far; expected that column, or a gyro at rest: cut the "
            "log there"
        )


def _describe_motion(gyro: Channel) -> str:
    """A sentence where the means of a gyro's rate over `TURNING_TIME` scatter by more than its
    noise and Earth's rate; empty where they don't."""
    rows = max(1, round(TURNING_TIME / gyro.interval))
    means = np.diff(gyro.angle[::rows]) / (rows * gyro.interval)
    departures = np.abs(means - np.median(means))
    noise = estimate_robust_deviation(means)
    if np.max(departures, initial=0.0) < max(TURNING_RATE, MOTION_SIGMAS * noise):
        return ""
    return (
        f"{gyro.name}: not at rest: it turned at up to {np.max(departures) / DEG_PER_H:.3g} deg/h, "
        "which is in the figures"
    )


def find_quantization_step(values: Array) -> float | None:
    """The step of which all values are whole multiples to 1e-3 of it; None where there is none."""
    levels = np.unique(values)
    if len(levels) < 2 or len(levels) > len(values) / 4:
        return None
    size = float(np.max(np.abs(levels)))
    steps = np.diff(levels)
    steps = steps[steps > 1e-9 * size]
    if not len(steps):
        return None
    step = float(np.min(steps))
    multiples = levels / step
    return step if np.max(np.abs(multiples - np.round(multiples))) < 1e-3 else None
