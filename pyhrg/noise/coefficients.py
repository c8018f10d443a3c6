"""Noise coefficients of IEEE Std 952, annex C, with intervals. Flicker noise of a bias instability
B has the two-sided density B^2/(2 pi f): its draws, and its approximation by Gauss-Markov processes
(docs/methods/noise.md, Eqs. (15), (16)).
"""

import math
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.signal import oaconvolve

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


def draw_flicker(
    coefficient: float, shape: tuple[int, ...], generator: np.random.Generator
) -> NDArray[np.float64]:
    """Draw flicker noise that begins at zero, as means over n equal intervals (n, channels).

    It is the half-order sum of white noise of variance B^2. Well below the sampling frequency its
    density B^2/|2 sin(pi f T)| is that of IEEE Std 952, B^2/(2 pi f), so that the floor of the
    Allan deviation is sqrt(2 ln 2/pi) B = 0.664 B at any interval T (N. Kasdin, Discrete simulation
    of colored noise and stochastic processes, Proc. IEEE 83 (1995), section V).

    coefficient: B, in the unit of the result.
    """
    white = generator.normal(0.0, coefficient, size=shape[::-1])
    noise = oaconvolve(white, half_integral_response(shape[0])[None], axes=1)
    return np.asarray(noise[:, : shape[0]].T)


def half_integral_response(count: int) -> NDArray[np.float64]:
    """Return the impulse response (count,) of a half-order sum: 1, 1/2, 3/8, ... (Kasdin 1995, Eq.
    104)."""
    k = np.arange(1.0, count)
    return np.concatenate([[1.0], np.cumprod((k - 0.5) / k)])


def compute_process_variance(coefficient: float, ratio: float = 10.0) -> float:
    """Variance of each of the independent Gauss-Markov processes whose sum approximates flicker
    noise: B^2 ln r / pi, in the squared unit of the coefficient B (Eq. (16)).

    `ratio` r is that of one correlation time to the one before.
    """
    return coefficient**2 * math.log(ratio) / math.pi
