"""Output against input over the range: a line and what departs from it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """Least squares of one power-on: output (n,) = K input + F0, rad/s; K of the nominal one."""

    input: Array
    output: Array

    def fit(self, rows: NDArray[np.bool_] | None = None) -> tuple[float, float]:
        """K and F0, rad/s, of some of the rates."""
        # of the error, so that rounding is of the error's size
        chosen = np.ones(len(self.input), dtype=bool) if rows is None else rows
        error = (self.output - self.input)[chosen]
        slope, offset = np.polyfit(self.input[chosen], error, 1)
        return 1.0 + float(slope), float(offset)

    @property
    def residual(self) -> Array:
        """(n,) output less line, over the largest output."""
        factor, offset = self.fit()
        left = (self.output - self.input) - (factor - 1.0) * self.input - offset
        return np.asarray(left / np.max(np.abs(self.output)))

    @property
    def asymmetry(self) -> float:
        """(K+ - K-) / K."""
        ways = [self.fit(self.input > 0)[0], self.fit(self.input < 0)[0]]
        return (ways[0] - ways[1]) / self.fit()[0]
