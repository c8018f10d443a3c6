"""Flicker noise of a bias instability B, whose two-sided density is B^2/(2 pi f): its draws, and
its approximation by Gauss-Markov processes (docs/methods/noise.md, Eqs. (15), (16))."""

import math

import numpy as np
from numpy.typing import NDArray
from scipy.signal import oaconvolve


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
