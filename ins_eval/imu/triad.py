"""Errors of three like sensors: of accelerometers, and of gyros that are no model of physics."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.imu.flicker import flicker

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Constant:
    """A constant of each axis: a part that is given and a part that is drawn for each triad.

    value: one for all, or as many as there are; deviation: standard deviation of what is drawn.
    """

    value: tuple[float, ...] | float = 0.0
    deviation: float = 0.0

    def draw(self, shape: tuple[int, ...], generator: np.random.Generator) -> Array:
        """Values of one triad."""
        given = np.reshape(self.value, shape) if np.ndim(self.value) else self.value
        return np.asarray(given + generator.normal(0.0, self.deviation, size=shape))

    @property
    def size(self) -> float:
        """Root mean square over axes and triads."""
        return float(np.hypot(self.deviation, np.sqrt(np.mean(np.square(self.value)))))


OFF_DIAGONAL = ~np.eye(3, dtype=bool)


@dataclass(frozen=True)
class Triad:
    """Three sensors with input axes nearly the body's; ideal by default. Terms of IEEE Std 528.

    With u the unit of what is sensed (m/s^2 or rad/s):

    bias: u; scale_factor: error of it, relative;
    misalignment: six, rad: how much of y and z is felt by x, of x and z by y, of x and y by z
    (Groves 2013, Eq. 4.16);
    white: random walk of the increments' sum, u sqrt(s);
    bias_instability: IEEE coefficient B, u; the Allan deviation's floor is 0.664 B;
    quantum: one count of the increments' sum, u s; 0 is none.
    """

    bias: Constant = Constant()
    scale_factor: Constant = Constant()
    misalignment: Constant = Constant()
    white: float = 0.0
    bias_instability: float = 0.0
    quantum: float = 0.0

    def measure(self, truth: Array, interval: float, generator: np.random.Generator) -> Array:
        """Increments (n, 3) of true ones (n, 3) over equal intervals, s; constants drawn anew.

        What is switched off draws as much as what is on, bias instability apart, so that triads of
        one seed share what they have in common.
        """
        bias = self.bias.draw((3,), generator)
        noise = generator.normal(0.0, self.white, size=truth.shape)
        increments = truth @ self._sensitivity(generator).T
        increments = increments + bias * interval + noise * np.sqrt(interval)
        if self.bias_instability:
            increments += interval * flicker(self.bias_instability, truth.shape, generator)
        return quantised(increments, self.quantum) if self.quantum else increments

    def _sensitivity(self, generator: np.random.Generator) -> Array:
        """(3, 3) from what is there to what is sensed."""
        matrix = np.diag(1.0 + self.scale_factor.draw((3,), generator))
        matrix[OFF_DIAGONAL] = self.misalignment.draw((6,), generator)
        return matrix


IDEAL = Triad()


def quantised(increments: Array, quantum: float) -> Array:
    """Increments (n, ...) in whole counts; the rest is kept for the next, so that their sum is
    never off by more than half a count."""
    counts = np.rint(np.cumsum(increments, axis=0) / quantum)
    return np.asarray(quantum * np.diff(counts, axis=0, prepend=0.0))
