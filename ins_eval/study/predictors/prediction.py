"""A predicted distribution of position errors, of one triad or many."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.radial_error import radius_at

Array = NDArray[np.float64]


class Prediction(Protocol):
    """Of errors north and east at k times of r triads, m."""

    @property
    def expected(self) -> Array:
        """(r, k, 2) mean error north and east."""
        ...

    def radius(self, share: float) -> Array:
        """(r, k) radial error that isn't exceeded with this probability."""
        ...


@dataclass(frozen=True)
class Normal:
    """expected: (r, k, 2) m; covariance: (r, k, 2, 2) m^2."""

    expected: Array
    covariance: Array

    def radius(self, share: float) -> Array:
        """As `Prediction`.

        Raises:
            ValueError: a share that is not between 0 and 1.
        """
        return radius_at(share, self.expected, self.covariance)


@dataclass(frozen=True)
class Drawn:
    """A distribution known by draws (r, m, k, 2), m."""

    draws: Array

    @property
    def expected(self) -> Array:
        """As `Prediction`."""
        return np.asarray(self.draws.mean(axis=1))

    def radius(self, share: float) -> Array:
        """As `Prediction`; of m draws the probability is right within sqrt(share (1 - share)/m)."""
        return np.asarray(np.quantile(np.linalg.norm(self.draws, axis=-1), share, axis=1))
