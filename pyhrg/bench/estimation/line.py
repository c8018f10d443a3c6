"""Straight line of output rate against input rate, and the deviations from it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """Input and output rates of one power-on, (n,) rad/s, for the line output = K input + F0.

    K is relative to the nominal scale factor.
    """

    input: Array
    output: Array

    def fit(self, rows: NDArray[np.bool_] | None = None) -> tuple[float, float]:
        """K and F0, rad/s, by least squares on some of the rates, or all."""
        # the error is fitted, not the output, so that rounding is relative to the error
        chosen = np.ones(len(self.input), dtype=bool) if rows is None else rows
        error = (self.output - self.input)[chosen]
        slope, offset = np.polyfit(self.input[chosen], error, 1)
        return 1.0 + float(slope), float(offset)

    @property
    def residual(self) -> Array:
        """(n,) output less line, relative to the largest output."""
        factor, offset = self.fit()
        deviation = (self.output - self.input) - (factor - 1.0) * self.input - offset
        return np.asarray(deviation / np.max(np.abs(self.output)))

    @property
    def asymmetry(self) -> float:
        """(K+ - K-) / K, from lines fitted to the positive and to the negative rates."""
        ways = [self.fit(self.input > 0)[0], self.fit(self.input < 0)[0]]
        return (ways[0] - ways[1]) / self.fit()[0]
