"""Stretches of a log at a constant rate of the table, found from the encoder."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import DEG
from pyhrg.records import Log

Array = NDArray[np.float64]

ALIKE = 1e-3
"""Rates of neighbouring rows within this of each other are one plateau's, relative."""
RESOLUTION = 2e-6 * DEG
"""Of the encoder, rad: rates also differ by this over a row."""


@dataclass(frozen=True)
class Plateau:
    """A constant rate of the table.

    rate: of the table, rad/s.
    first, last: rows of the log; it lasts from the end of `first` to the end of `last`.
    """

    rate: float
    first: int
    last: int

    def later(self, share: float) -> "Plateau":
        """Its last `share`, 0 to 1."""
        rows = max(1, round(share * (self.last - self.first)))
        return Plateau(self.rate, self.last - rows, self.last)

    def mean_rate(self, log: Log, angle: Array) -> float:
        """Of an angle (n,) of the log over the plateau, rad/s."""
        span = log.time[self.last] - log.time[self.first]
        return float((angle[self.last] - angle[self.first]) / span)


def plateaus(log: Log, shortest: float) -> list[Plateau]:
    """All plateaus of a log that last at least `shortest`, s, in order."""
    log.require("table_angle", "gyro_angle", "wave_angle")
    found = []
    for stretch in log.stretches("table_angle", "gyro_angle", "wave_angle"):
        angle, time = log.table_angle[stretch], log.time[stretch]
        if len(time) < 2:
            continue
        rate = np.diff(angle) / np.diff(time)
        begin = 0
        for row in range(1, len(rate) + 1):
            if row < len(rate) and _alike(rate[row], rate[begin], log.interval):
                continue
            if time[row] - time[begin] >= shortest - 1e-9:
                mean = float((angle[row] - angle[begin]) / (time[row] - time[begin]))
                found.append(Plateau(mean, stretch.start + begin, stretch.start + row))
            begin = row
    return found


def _alike(rate: float, other: float, interval: float) -> bool:
    return bool(abs(rate - other) <= ALIKE * abs(other) + RESOLUTION / interval)
