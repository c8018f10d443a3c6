"""Stretches of a log at constant virtual rotation and table rate, and the error of the output.

At virtual rotation V (as an input rate), an input rate W of table and Earth and a pattern angle th,
the error of the output rate is W (s + harmonics of th) + B + harmonics of the bias + V (-e +
harmonics): scale-factor error s, bias B, gain error e of the virtual rotation. The last part
changes its sign with V, the bias does not.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.angle_fit import Record, compute_largest_inflation
from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, average_wave, name_terms
from pyhrg.bench.readings.segments import split_rows
from pyhrg.bench.readings.turns import SETTLE, TURN_TOLERANCE, Turn, find_rate_changes
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import Log

BIAS, GAIN, SCALE = "bias", "virtual rotation", "scale factor"
"""Kinds of terms: independent of the rates, proportional to V, proportional to W."""
MAP_PERIODS = (180 * DEG, 90 * DEG)
"""Period of the bias map with a second harmonic, and without one; rad of pattern angle."""
SHORTEST_ROWS = 30
"""Fewest rows of a stretch that is used."""
ORDERS = (4, 2, 8)
"""Harmonics of the pattern angle, the most important first."""


@dataclass(frozen=True)
class Sweep(Turn):
    """A turn of the table, or a rest, at constant virtual rotation.

    virtual_rotation: as an input rate, rad/s; 0 without.
    """

    virtual_rotation: float

    @property
    def table_rate(self) -> float:
        """Mean rate of the table, rad/s; 0 at rest."""
        moved = abs(float(self.table_angle[-1] - self.table_angle[0]))
        return super().table_rate if moved > TURN_TOLERANCE * len(self.time) else 0.0

    def average_period(self) -> tuple[float, float] | None:
        """Mean error of the output rate, rad/s, over a whole period of the bias map, and that
        period, rad of pattern angle; None for a shorter stretch."""
        moved_by = np.abs(self.pattern_angle - self.pattern_angle[0])
        for period in MAP_PERIODS:
            if moved_by[-1] >= period:
                time, excess = (np.interp(period, moved_by, x) for x in (self.time, self.excess))
                return float(excess / (time - self.time[0])), period
        return None

    def record(self, orders: Sequence[int], kinds: Sequence[str]) -> Record:
        """Record for a fit of the excess: mean and harmonics (`orders`) of each kind of terms."""
        steps = np.diff(self.time)
        waves = {"": self.time - self.time[0]}
        for order in orders:
            for name, trig in zip(name_terms(order), (np.cos, np.sin), strict=True):
                mean = average_wave(trig, order, self.pattern_angle)
                waves[f" {name}"] = np.concatenate([[0.0], np.cumsum(mean * steps)])
        rates = {BIAS: 1.0, GAIN: self.virtual_rotation, SCALE: self.input_rate}
        pairs = ((kind, name) for kind in kinds for name in waves)
        columns = {f"{kind}{name}": rates[kind] * waves[name] for kind, name in pairs}
        return Record(self.interval, self.excess, columns)


def find_sweeps(log: Log, site: Site) -> list[Sweep]:
    """Sweeps of a log in order of time, from a settling time after each change."""
    log.require("table_angle", "axis_up", "virtual_rotation", "gyro_angle", "wave_angle")
    settle = math.ceil(SETTLE / log.interval)
    return [
        _read_sweep(log, site, slice(first + settle, after))
        for stretch in log.stretches("table_angle", "virtual_rotation", "gyro_angle", "wave_angle")
        for first, after in split_rows(stretch, _find_changes(log, stretch))
        if after - first > settle + SHORTEST_ROWS
    ]


def _find_changes(log: Log, rows: slice) -> NDArray[np.bool_]:
    """Mask of rows at which table rate or a command changes or the output is not valid."""
    turned = np.diff(log.table_angle[rows], prepend=log.table_angle[rows][:1])
    changed = find_rate_changes(turned)
    for values in (log.virtual_rotation, log.axis_up, log.drive_on):
        changed |= np.diff(values[rows], prepend=values[rows][:1]) != 0
    return np.asarray(changed | (log.drive_on[rows] < 0.5) | (log.valid[rows] < 0.999))


def _read_sweep(log: Log, site: Site, rows: slice) -> Sweep:
    time, table, pattern, gyro = (
        np.asarray(values[rows])
        for values in (log.time, log.table_angle, log.wave_angle, log.gyro_angle)
    )
    earth = site.vertical_rate * float(np.mean(log.axis_up[rows]))
    angle = table - table[0] + earth * (time - time[0])
    command, excess = float(log.virtual_rotation[rows][-1]), gyro - gyro[0] - angle
    return Sweep(log.source, log.interval, time, table, pattern, angle, excess, command)


def select_orders(sweeps: Sequence[Sweep], kinds: Sequence[str]) -> tuple[int, ...]:
    """Harmonics that the sweeps can separate, the same for all kinds of terms."""
    orders: tuple[int, ...] = ()
    for order in ORDERS:
        records = [sweep.record((*orders, order), kinds) for sweep in sweeps]
        if compute_largest_inflation(records) <= LARGEST_INFLATION:
            orders += (order,)
    return orders
