"""Bias instability: noise whose spectral density falls as 1/f."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import oaconvolve


def flicker(
    coefficient: float, shape: tuple[int, ...], generator: np.random.Generator
) -> NDArray[np.float64]:
    """Means over equal intervals (n, channels) of flicker noise that begins at zero.

    White noise of variance B^2, summed half a time: its density B^2/|2 sin(pi f T)| is that of
    IEEE Std 952, B^2/(2 pi f), below the sampling frequency, so that the Allan deviation's floor is
    sqrt(2 ln 2/pi) B = 0.664 B at any interval T (N. Kasdin, Discrete simulation of colored noise
    and stochastic processes, Proc. IEEE 83 (1995), section V).

    Args:
        coefficient: B, in the unit of the result.
        shape: intervals, channels.
        generator: of the white noise.
    """
    white = generator.normal(0.0, coefficient, size=shape[::-1])
    summed = oaconvolve(white, half_integral(shape[0])[None], axes=1)
    return np.asarray(summed[:, : shape[0]].T)


def half_integral(count: int) -> NDArray[np.float64]:
    """(count,) response of a sum taken half a time: 1, 1/2, 3/8, ... (Kasdin 1995, Eq. 104)."""
    k = np.arange(1.0, count)
    return np.concatenate([[1.0], np.cumprod((k - 0.5) / k)])
