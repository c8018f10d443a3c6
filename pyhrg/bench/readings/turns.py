"""Stretches of a log in which the table turns steadily: the data of every scale-factor test."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records import Log

Array = NDArray[np.float64]

SETTLE = 2.0
"""Left out after the table reached its rate, s."""
PERIOD = 90 * DEG
"""Of the scale-factor map in the pattern angle, rad; the second harmonic takes twice as much."""
ENCODER = 5 * ARCSEC
"""A row's turn may differ from the row's before by this, and by `UNSTEADY` of itself, rad."""
UNSTEADY = 0.005
WHOLE = 1 - 1e-6
"""Of a period, to rounding."""
FIELDS = ("table_angle", "axis_up", "virtual_rotation", "drive_on", "gyro_angle", "wave_angle")
"""Of a log, needed."""


@dataclass(frozen=True)
class Turn:
    """One stretch at one rate, angles (n,) at the ends of its rows, rad.

    input_angle: what the input axis turned through, Earth included; 0 at the beginning.
    excess: gyro angle less input angle; 0 at the beginning.
    """

    source: str
    interval: float
    time: Array
    table_angle: Array
    pattern_angle: Array
    input_angle: Array
    excess: Array

    @property
    def table_rate(self) -> float:
        """Mean, rad/s."""
        return _slope(self.table_angle, self.time)

    @property
    def input_rate(self) -> float:
        """Mean, rad/s, Earth included."""
        return _slope(self.input_angle, self.time)

    @property
    def periods(self) -> float:
        """Periods of the scale-factor map that the pattern went through."""
        return abs(float(self.pattern_angle[-1] - self.pattern_angle[0])) / PERIOD

    def whole_periods(self, each: int = 0) -> tuple[Array, Array, Array]:
        """Time, input angle and excess (m,) at the bounds of whole periods, between rows by line.

        Args:
            each: periods between bounds; 0: two bounds with as many as there are.
        """
        gone = np.abs(self.pattern_angle - self.pattern_angle[0])
        whole = math.floor(self.periods + 1e-6)
        bounds = np.arange(0, whole + 1, each or max(whole, 1)) * PERIOD
        values = (self.time, self.input_angle, self.excess)
        time, angle, excess = (np.interp(bounds, gone, value) for value in values)
        return time, angle, excess


def turns(log: Log, latitude: float) -> list[Turn]:
    """Steady stretches of at least a period, in the order of the log.

    Args:
        log: one power-on.
        latitude: of the site, rad.

    Raises:
        BenchError: there is none.
    """
    found = _all_turns(log, latitude)
    whole = [turn for turn in found if turn.periods >= WHOLE]
    if not whole:
        most = max((turn.periods for turn in found), default=0.0) * PERIOD / DEG
        raise BenchError(
            f"{log.source}: no stretch at a steady rate turns the pattern by {PERIOD / DEG:g} deg, "
            f"a period of the scale-factor map; the longest turns it by {most:.3g} deg"
        )
    return whole


def left_out(log: Log, latitude: float) -> list[str]:
    """A sentence on each steady stretch that is shorter than a period."""
    return [
        f"{log.source}: {turn.time[0]:.6g} to {turn.time[-1]:.6g} s at {turn.table_rate / DEG:.3g} "
        f"deg/s left out: the pattern turned by {turn.periods * PERIOD / DEG:.3g} deg, less than "
        f"the {PERIOD / DEG:g} deg of a period"
        for turn in _all_turns(log, latitude)
        if turn.periods < WHOLE
    ]


def _all_turns(log: Log, latitude: float) -> list[Turn]:
    log.require(*FIELDS)
    return [_turn(log, latitude, rows) for rows in _steady(log)]


def _steady(log: Log) -> list[slice]:
    """Rows of stretches without gap, with drive on, no virtual rotation and a steady rate."""
    turned = np.diff(log.table_angle, prepend=log.table_angle[:1])
    moving = (np.abs(turned) > ENCODER) & (log.virtual_rotation == 0.0) & (log.drive_on > 0.5)
    moving &= ~(log.valid < 0.999)
    unlike = np.abs(np.diff(turned, prepend=0.0)) > ENCODER + UNSTEADY * np.abs(turned)
    settle = math.ceil(SETTLE / log.interval)
    found = []
    for stretch in log.stretches(*FIELDS):
        rows = np.arange(len(turned))[stretch]
        broken = np.flatnonzero(~moving[rows] | unlike[rows])
        for first, after in zip([0, *broken], [*broken, len(rows)], strict=True):
            if after - first > settle + 8:
                found.append(slice(int(rows[first]) + settle, int(rows[after - 1]) + 1))
    return found


def _turn(log: Log, latitude: float, rows: slice) -> Turn:
    time, table, pattern, gyro, axis_up = (
        np.asarray(values[rows])
        for values in (log.time, log.table_angle, log.wave_angle, log.gyro_angle, log.axis_up)
    )
    # a row's attitude holds from the row's before to its own time
    earth = EARTH_RATE * math.sin(latitude) * np.cumsum(axis_up) * log.interval
    angle = table - table[0] + earth - earth[0]
    excess = gyro - gyro[0] - angle
    return Turn(log.source, log.interval, time, table, pattern, angle, excess)


def _slope(angle: Array, time: Array) -> float:
    return float((angle[-1] - angle[0]) / (time[-1] - time[0]))
