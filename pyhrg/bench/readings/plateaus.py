"""Stretches of a log at a constant table rate, by the table encoder."""

from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records import Log

RATE_TOLERANCE = 1e-3
"""Largest relative difference of a row's table rate from the first row's on one plateau. Chosen."""
TURN_TOLERANCE = 2e-6 * DEG
"""Turns of two rows on one plateau may also differ by this, rad. Derived: the most that rounding of
encoder angles to six decimals of a degree makes."""


@dataclass(frozen=True)
class Plateau:
    """A stretch at a constant table rate.

    Attributes:
        rate: rate of the table, rad/s.
        first, last: rows of the log; the stretch lasts from the end of `first` to the end of
            `last`.
    """

    rate: float
    first: int
    last: int

    def later(self, share: float) -> "Plateau":
        """The last `share`, 0 to 1, of the stretch."""
        rows = max(1, round(share * (self.last - self.first)))
        return Plateau(self.rate, self.last - rows, self.last)

    def mean_rate(self, log: Log, angle: Array) -> float:
        """Mean rate of an angle (n,) of the log over the stretch, rad/s."""
        span = log.time[self.last] - log.time[self.first]
        return float((angle[self.last] - angle[self.first]) / span)


def find_plateaus(log: Log, shortest: float) -> list[Plateau]:
    """Plateaus of a log that last at least `shortest` seconds, in order of time."""
    log.require("table_angle", "gyro_angle", "wave_angle")
    stretches = []
    for stretch in log.stretches("table_angle", "gyro_angle", "wave_angle"):
        angle, time = log.table_angle[stretch], log.time[stretch]
        if len(time) < 2:
            continue
        rate = np.diff(angle) / np.diff(time)
        begin = 0
        for row in range(1, len(rate) + 1):
            tolerance = RATE_TOLERANCE * abs(rate[begin]) + TURN_TOLERANCE / log.interval
            if row < len(rate) and abs(rate[row] - rate[begin]) <= tolerance:
                continue
            if time[row] - time[begin] >= shortest - 1e-9:
                mean = float((angle[row] - angle[begin]) / (time[row] - time[begin]))
                stretches.append(Plateau(mean, stretch.start + begin, stretch.start + row))
            begin = row
    return stretches
