"""What an IMU hands over."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Increments:
    """Sums over equal intervals, body axes (forward, right, down).

    interval: s; rotation: (n, 3) integral of `omega_ib_b`, rad; velocity: (n, 3) integral of
    the specific force `f_b`, m/s.
    """

    interval: float
    rotation: NDArray[np.float64]
    velocity: NDArray[np.float64]

    def between(self, first: int, last: int) -> "Increments":
        """Intervals first to last - 1."""
        return Increments(self.interval, self.rotation[first:last], self.velocity[first:last])
