"""A static record: channels of one sensor each, whatever file they are from."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.errors import HrgError
from pyhrg.gap.static_record.terms import GYRO, Kind
from pyhrg.records import Log

Array = NDArray[np.float64]

LEAST = 1024
"""Readings of a channel: half of them are held out."""


class RecordError(HrgError):
    """The record can't be diagnosed; the message says why."""


@dataclass(frozen=True)
class Channel:
    """One sensor at rest.

    angle: (n,) integral of what it senses, SI, evenly spaced, without gaps; temperature: (n,) K,
    if it was logged; quantum: step of the readings' grid, SI, if they lie on one; drifts: whether a
    ramp of the rate is nothing to wonder at.
    """

    name: str
    kind: Kind
    interval: float
    angle: Array
    temperature: Array | None = None
    quantum: float | None = None
    drifts: bool = False

    def part(self, first: int, last: int) -> "Channel":
        """Readings first to last - 1."""
        temperature = None if self.temperature is None else self.temperature[first:last]
        return replace(self, angle=self.angle[first:last], temperature=temperature)

    @property
    def half(self) -> int:
        """The first reading that is held out."""
        return len(self.angle) // 2


@dataclass(frozen=True)
class StaticRecord:
    """Of one file; notes: what was left out of it."""

    source: str
    channels: tuple[Channel, ...]
    notes: tuple[str, ...] = ()


def of_increments(
    name: str, kind: Kind, interval: float, increments: Array, temperature: Array | None = None
) -> Channel:
    """The channel of readings (n,) that are increments, SI.

    Raises:
        RecordError: too few, or one that is not finite, or all the same.
    """
    increments = np.asarray(increments, dtype=np.float64)
    if len(increments) < LEAST:
        raise RecordError(f"{name}: found {len(increments)} readings, expected {LEAST} or more")
    if not np.all(np.isfinite(increments)):
        row = int(np.argmin(np.isfinite(increments)))
        raise RecordError(f"{name}: reading {row}: found {increments[row]}, expected a number")
    if np.ptp(increments) == 0:
        raise RecordError(f"{name}: found {increments[0]:g} in all readings, expected noise")
    angle = np.cumsum(increments - np.mean(increments))
    return Channel(name, kind, interval, angle, temperature, grid(increments))


def of_log(log: Log) -> StaticRecord:
    """The output of a bench log over its longest stretch without gaps, the table's angle taken off.

    The pattern creeps over the gyro's bias map: a ramp is expected.

    Raises:
        LogError: it has no output or no table angle.
        RecordError: the stretch is too short.
    """
    stretch = max(log.stretches("gyro_angle", "table_angle"), key=lambda s: s.stop - s.start)
    angle = (log.gyro_angle - log.table_angle)[stretch]
    temperature = log.temperature[stretch]
    known = bool(np.all(np.isfinite(temperature)))
    channel = of_increments(
        *("gyro", GYRO, log.interval, np.diff(angle)), temperature[1:] if known else None
    )
    return StaticRecord(log.source, (replace(channel, drifts=True),), log.exclusions)


def grid(values: Array) -> float | None:
    """The step of which all values are whole multiples; None where they lie on no grid."""
    levels = np.unique(values)
    if len(levels) < 2 or len(levels) > len(values) / 4:
        return None
    size = float(np.max(np.abs(levels)))
    steps = np.diff(levels)
    step = float(np.min(steps[steps > 1e-9 * size]))
    multiples = levels / step
    return step if np.max(np.abs(multiples - np.round(multiples))) < 1e-3 else None
