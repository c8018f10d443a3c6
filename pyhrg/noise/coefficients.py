"""Noise coefficients of IEEE Std 952, annex C, with intervals."""

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError

CONFIDENCE = 0.95
"""Probability with which an interval covers the true value."""


class NoiseError(HrgError):
    """The record does not give the noise that is asked for; the message says why."""


@dataclass(frozen=True)
class Coefficient:
    """A noise coefficient and its 95 % interval.

    `low` is 0 where the record does not show the noise; `high` is then an upper bound.
    """

    value: float
    low: float
    high: float

    @property
    def present(self) -> bool:
        """Whether the interval excludes zero."""
        return self.low > 0 or self.high < 0


@dataclass(frozen=True)
class NoiseCoefficients:
    """The coefficients of four noises, in the words of `pyhrg.noise`; a rate ramp is no noise.

    Attributes:
        angle_white_noise: standard deviation of one angle reading, rad; of quantization it is the
            step over sqrt(12).
        angle_random_walk: coefficient N, rad/sqrt(s).
        bias_instability: coefficient B of flicker noise, rad/s; the Allan deviation's floor is
            sqrt(2 ln 2/pi) B = 0.664 B.
        rate_random_walk: coefficient K, rad/s/sqrt(s).
    """

    angle_white_noise: Coefficient
    angle_random_walk: Coefficient
    bias_instability: Coefficient
    rate_random_walk: Coefficient


COEFFICIENT_NAMES = tuple(field.name for field in fields(NoiseCoefficients))
"""Names of the coefficients, which `Device` and the noise models of a diagnosis share."""


def compute_allan_deviation(tau: ArrayLike, noises: NoiseCoefficients) -> Array:
    """Allan deviation of noises at cluster times (s), rad/s (IEEE Std 952, annex C)."""
    t = np.asarray(tau, dtype=np.float64)
    return np.sqrt(
        3 * (noises.angle_white_noise.value / t) ** 2
        + noises.angle_random_walk.value**2 / t
        + 2 * np.log(2) / np.pi * noises.bias_instability.value**2
        + noises.rate_random_walk.value**2 * t / 3
    )
