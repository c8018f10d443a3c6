"""What loops that run make of forces that loops at rest would give: closed loops, sampled."""

from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy import signal

Array = NDArray[np.float64]
Transfer = tuple[tuple[float, ...], tuple[float, ...]]
"""Coefficients of a numerator and of a denominator."""


def followed(force: Array, natural_frequency: float, interval: float) -> Array:
    """Force of a critically damped loop where one at rest would give `force`.

    Closed loop (2 w s + w^2)/(s + w)^2, a series linear between rows.

    Args:
        force: (n,) at rest.
        natural_frequency: w, rad/s.
        interval: of the rows, s.
    """
    w = natural_frequency
    return _through(((2 * w, w * w), (1.0, 2 * w, w * w)), force, interval)


def let_go(force: Array, natural_frequency: float, interval: float) -> Array:
    """What a critically damped loop loses of what it holds while the force that it needs changes.

    Closed loop s/(s + w)^2, a series linear between rows.

    Args:
        force: (n,) at rest, 1/s.
        natural_frequency: w, rad/s.
        interval: of the rows, s.
    """
    w = natural_frequency
    return _through(((1.0, 0.0), (1.0, 2 * w, w * w)), force, interval)


def _through(transfer: Transfer, force: Array, interval: float) -> Array:
    numerator, denominator, rest = _sampled(transfer, interval)
    return np.asarray(signal.lfilter(numerator, denominator, force, zi=rest * force[0])[0])


@cache
def _sampled(transfer: Transfer, interval: float) -> tuple[Array, Array, Array]:
    """Coefficients for a series linear between rows, and the state that one unit rests in."""
    loop = signal.cont2discrete(transfer, interval, method="foh")
    numerator, denominator = np.ravel(loop[0]), loop[1]
    return numerator, denominator, signal.lfilter_zi(numerator, denominator)
