"""Steady stretches of a log with virtual rotation on or off: what the output gains in them.

With virtual rotation V (an input rate), table and Earth at W, the pattern at th, the output less
W is W (s + its harmonics) + B + the bias's harmonics + V (-e + harmonics): scale factor, bias, gain
error of the virtual rotation. The last changes its sign with V, the bias does not.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.angle_fit import Record, inflation
from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, harmonic
from pyhrg.bench.readings.turns import ENCODER, SETTLE, UNSTEADY
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG
from pyhrg.records import Log

Array = NDArray[np.float64]

BIAS, GAIN, SCALE = "bias", "virtual rotation", "scale factor"
WHOLE = (180 * DEG, 90 * DEG)
"""Periods of the bias map with and without a second harmonic, rad of pattern."""
FEWEST = 30
"""Rows of a stretch that is of use."""
ORDERS = (4, 2, 8)


@dataclass(frozen=True)
class Sweep:
    """Rows of one stretch, (n,): virtual rotation and table rate are constant.

    virtual_rotation, table_rate: rad/s; 0 where off or at rest.
    excess: output less table and Earth, 0 at the beginning, rad.
    """

    source: str
    interval: float
    virtual_rotation: float
    table_rate: float
    time: Array
    pattern_angle: Array
    input_angle: Array
    excess: Array

    def whole(self) -> tuple[float, float] | None:
        """Mean excess, rad/s, over a whole period of pattern, and that period; None if shorter."""
        gone = np.abs(self.pattern_angle - self.pattern_angle[0])
        for period in WHOLE:
            if gone[-1] >= period:
                time, excess = (np.interp(period, gone, x) for x in (self.time, self.excess))
                return float(excess / (time - self.time[0])), period
        return None

    def record(self, orders: Sequence[int], kinds: Sequence[str]) -> Record:
        """Columns of the terms of each kind (`BIAS`, `GAIN`, `SCALE`), for a fit of the excess."""
        steps = np.diff(self.time)
        middle = (self.pattern_angle[1:] + self.pattern_angle[:-1]) / 2
        swept = np.diff(self.pattern_angle)
        waves = {"": self.time - self.time[0]}
        for order in orders:
            for name, trig in zip(harmonic(order), (np.cos, np.sin), strict=True):
                mean = trig(order * middle) * np.sinc(order * swept / (2 * np.pi))
                waves[f" {name}"] = np.concatenate([[0.0], np.cumsum(mean * steps)])
        rates = {BIAS: 1.0, GAIN: self.virtual_rotation, SCALE: self.input_rate}
        columns = {
            f"{kind}{name}": rates[kind] * wave for kind in kinds for name, wave in waves.items()
        }
        return Record(self.interval, self.excess, columns)

    @property
    def input_rate(self) -> float:
        """Of table and Earth, rad/s."""
        return float(self.input_angle[-1] / (self.time[-1] - self.time[0]))


def sweeps(log: Log, latitude: float) -> list[Sweep]:
    """Steady stretches in the order of the log, a settling time after each change.

    Args:
        log: one power-on.
        latitude: of the site, rad.
    """
    log.require("table_angle", "axis_up", "virtual_rotation", "gyro_angle", "wave_angle")
    settle = math.ceil(SETTLE / log.interval)
    found = []
    for stretch in log.stretches("table_angle", "virtual_rotation", "gyro_angle", "wave_angle"):
        rows = np.arange(len(log.time))[stretch]
        broken = np.flatnonzero(_changes(log, stretch))
        for first, after in zip([0, *broken], [*broken, len(rows)], strict=True):
            if after - first > settle + FEWEST:
                found.append(
                    _sweep(log, latitude, slice(rows[first] + settle, rows[after - 1] + 1))
                )
    return found


def _changes(log: Log, rows: slice) -> NDArray[np.bool_]:
    """Rows at which the table or a command changes, or the gyro doesn't measure."""
    turned = np.diff(log.table_angle[rows], prepend=log.table_angle[rows][:1])
    changed = np.abs(np.diff(turned, prepend=0.0)) > ENCODER + UNSTEADY * np.abs(turned)
    for values in (log.virtual_rotation, log.axis_up, log.drive_on):
        changed |= np.diff(values[rows], prepend=values[rows][:1]) != 0
    return np.asarray(changed | (log.drive_on[rows] < 0.5) | (log.valid[rows] < 0.999))


def _sweep(log: Log, latitude: float, rows: slice) -> Sweep:
    time, table, pattern, gyro = (
        np.asarray(values[rows])
        for values in (log.time, log.table_angle, log.wave_angle, log.gyro_angle)
    )
    span = time[-1] - time[0]
    earth = EARTH_RATE * math.sin(latitude) * float(np.mean(log.axis_up[rows]))
    angle = table - table[0] + earth * (time - time[0])
    moved = float(table[-1] - table[0])
    rate = moved / span if abs(moved) > ENCODER * len(time) else 0.0
    command = float(log.virtual_rotation[rows][-1])
    excess = gyro - gyro[0] - angle
    return Sweep(log.source, log.interval, command, rate, time, pattern, angle, excess)


def separable(found: Sequence[Sweep], kinds: Sequence[str]) -> tuple[int, ...]:
    """Harmonics that the sweeps tell apart, for all kinds of terms alike."""
    orders: list[int] = []
    for order in ORDERS:
        trial = [*orders, order]
        if inflation([sweep.record(trial, kinds) for sweep in found]) <= LARGEST_INFLATION:
            orders.append(order)
    return tuple(orders)
