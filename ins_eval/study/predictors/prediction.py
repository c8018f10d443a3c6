"""A predicted distribution of position errors, of one triad or many."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ins_eval.common.radial_error import radius_quantile
from pyhrg.common.arrays import Array


class Prediction(Protocol):
    """Distribution of the errors north and east of r triads at k times, m."""

    @property
    def expected(self) -> Array:
        """(r, k, 2) mean error north and east."""
        ...

    def radius(self, share: float) -> Array:
        """(r, k) quantile of the horizontal error at this probability, m."""
        ...


@dataclass(frozen=True)
class NormalPrediction:
    """A normal distribution. expected: (r, k, 2) m; covariance: (r, k, 2, 2) m^2."""

    expected: Array
    covariance: Array

    def radius(self, share: float) -> Array:
        """(r, k) quantile of the horizontal error, m.

        Raises:
            ValueError: a share that is not between 0 and 1.
        """
        return radius_quantile(share, self.expected, self.covariance)


@dataclass(frozen=True)
class SampledPrediction:
    """A distribution given by samples (r, m, k, 2), m."""

    samples: Array

    @property
    def expected(self) -> Array:
        """(r, k, 2) mean of the samples, m."""
        return np.asarray(self.samples.mean(axis=1))

    def radius(self, share: float) -> Array:
        """(r, k) quantile of the horizontal error, m. The standard error of its probability is
        sqrt(share (1 - share)/m)."""
        return np.asarray(np.quantile(np.linalg.norm(self.samples, axis=-1), share, axis=1))
