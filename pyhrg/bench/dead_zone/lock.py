"""What a free pattern does at a constant rate: it locks in, or turns in whole periods."""

import math
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import Log

PERIOD = math.pi / 2
"""Period of the dead zone in the pattern angle, rad."""
STILL = 1 * DEG
"""A pattern that moves less than this in the last quarter of the log is locked, rad."""


@dataclass(frozen=True)
class Run:
    """One power-on at a constant rate.

    name: of the test.
    rate: inertial, on the input axis, rad/s; rotation: virtual, as an input rate.
    pattern_rate: mean over whole periods, as an input rate: -(d th/dt)/k; 0 while locked.
    locked: in the last quarter.
    angle: mean pattern angle of the last quarter, rad.
    output: mean output rate of the last half, rad/s.
    """

    name: str
    rate: float
    rotation: float
    pattern_rate: float
    locked: bool
    angle: float
    output: float

    @property
    def net(self) -> float:
        """Input rate less virtual rotation, rad/s: what turns the pattern."""
        return self.rate - self.rotation


def read_run(log: Log, site: Site, bryan_factor: float) -> Run:
    """State of the pattern in a log."""
    log.require("table_angle", "gyro_angle", "wave_angle", "virtual_rotation", "axis_up")
    time, wave, n = log.time, log.wave_angle, len(log.time)
    if n < 100 or np.ptp(log.virtual_rotation) > 0:
        raise BenchError(
            f"{log.source}: expected 100 rows or more of one virtual rotation, got {n}"
        )
    earth = site.vertical_rate * float(np.mean(log.axis_up))
    table = (log.table_angle[-1] - log.table_angle[0]) / (time[-1] - time[0])
    late, half = slice(n - n // 4, n), n // 2
    locked = bool(np.ptp(wave[late]) < STILL)
    elapsed = time[-1] - time[half]
    return Run(
        name=log.source,
        rate=float(table) + earth,
        rotation=float(log.virtual_rotation[0]),
        pattern_rate=0.0 if locked else -_turning_rate(log) / bryan_factor,
        locked=locked,
        angle=float(np.mean(wave[late])),
        output=float((log.gyro_angle[-1] - log.gyro_angle[half]) / elapsed),
    )


def _turning_rate(log: Log) -> float:
    """Mean rate of the pattern over as many whole periods as there are, rad/s."""
    turned = log.wave_angle - log.wave_angle[0]
    periods = math.floor(abs(turned[-1]) / PERIOD)
    if periods < 1:
        raise BenchError(
            f"{log.source}: the pattern is not locked and turned by {abs(turned[-1]) / DEG:.3g} "
            "deg; a mean rate takes a whole period of 90 deg"
        )
    way = math.copysign(1.0, turned[-1]) * turned
    row = int(np.argmax(way >= periods * PERIOD))
    share = (periods * PERIOD - way[row - 1]) / (way[row] - way[row - 1])
    end = log.time[row - 1] + share * (log.time[row] - log.time[row - 1])
    return math.copysign(periods * PERIOD / float(end - log.time[0]), turned[-1])
