"""How forces and errors of sampled control loops lag those of quasi-steady loops."""

from functools import cache

import numpy as np
from scipy import signal

from pyhrg.common.arrays import Array


def compute_loop_force(force: Array, natural_frequency: float, interval: float) -> Array:
    """(n,) force of a critically damped loop of natural frequency w, rad/s, where a quasi-steady
    loop would apply (n,) `force`: (2 w s + w^2)/(s + w)^2 (docs/methods/replay.md, Eq. 5). The
    input is linear between rows."""
    w = natural_frequency
    return _filter((2 * w, w * w), w, force, interval)


def compute_loop_error(force: Array, natural_frequency: float, interval: float) -> Array:
    """(n,) departure of the controlled quantity from its set point while the needed force, 1/s,
    changes: s/(s + w)^2 (docs/methods/replay.md, Eq. 6). The input is linear between rows."""
    return _filter((1.0, 0.0), natural_frequency, force, interval)


def _filter(numerator: tuple[float, float], w: float, force: Array, interval: float) -> Array:
    coefficients, steady_state = _discretize(numerator, w, interval)
    return np.asarray(signal.lfilter(*coefficients, force, zi=steady_state * force[0])[0])


@cache
def _discretize(
    numerator: tuple[float, float], w: float, interval: float
) -> tuple[tuple[Array, Array], Array]:
    """Coefficients for an input that is linear between rows, and the steady state for a unit."""
    loop = signal.cont2discrete((numerator, (1.0, 2 * w, w * w)), interval, method="foh")
    coefficients = np.ravel(loop[0]), loop[1]
    return coefficients, signal.lfilter_zi(*coefficients)
