"""Increments: what an IMU gives the navigator."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Increments:
    """Sums over equal intervals, body axes (forward, right, down).

    interval: s; rotation: (n, 3) integral of `omega_ib_b`, rad; velocity: (n, 3) integral of
    the specific force `f_b`, m/s; start: time at the beginning of the first interval, s.
    """

    interval: float
    rotation: NDArray[np.float64]
    velocity: NDArray[np.float64]
    start: float = 0.0

    def __len__(self) -> int:
        return len(self.rotation)

    @property
    def duration(self) -> float:
        """Duration of all intervals, s."""
        return len(self) * self.interval

    @property
    def bounds(self) -> NDArray[np.float64]:
        """(n + 1,) times at which intervals begin and end, s."""
        return np.asarray(self.start + self.interval * np.arange(len(self) + 1.0))

    def between(self, first: int, last: int) -> "Increments":
        """The increments of intervals `first` to `last - 1`."""
        return Increments(
            self.interval,
            self.rotation[first:last],
            self.velocity[first:last],
            self.start + first * self.interval,
        )
