"""How forces and errors of sampled control loops lag those of quasi-steady loops."""

from functools import cache

import numpy as np
from scipy import signal

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.records import Log

FORCES = ("amplitude_force", "quadrature_force")
"""Channels that are zero while the drive is off."""


def apply_loop_response(
    values: dict[str, Array], device: Device, log: Log, aim: Array | float
) -> dict[str, Array]:
    """Quasi-steady forces through the loops' transfer functions, and the amplitude's error
    (docs/methods/replay.md, Eqs. 5 to 6a). Changes `values`.

    aim: (n,) amplitude that the loop holds; 0 in a difference of two gyros.
    """
    interval, is_driven = log.interval, log.is_driven
    departures = {
        "amplitude_force": values["amplitude"] / device.amplitude,
        "quadrature_force": values["quadrature"],
    }
    loops = (device.amplitude_loop, device.quadrature_loop)
    for name, frequency in zip(FORCES, loops, strict=True):
        slope = np.diff(departures[name], prepend=departures[name][0]) / interval
        needed = values[name] - np.where(is_driven, slope, 0.0)
        if name == "amplitude_force":
            error = compute_loop_error(needed, frequency, interval)
            held = np.where(is_driven, aim, values["amplitude"])
            values["amplitude"] = held - device.amplitude * error
        values[name] = compute_loop_force(needed, frequency, interval)
    return values


def compute_loop_force(force: Array, natural_frequency: float, interval: float) -> Array:
    """(n,) or (n, b) force of a critically damped loop of natural frequency w, rad/s, where a
    quasi-steady loop would apply `force`, of the same shape: (2 w s + w^2)/(s + w)^2
    (docs/methods/replay.md, Eq. 5). The input is linear between rows."""
    w = natural_frequency
    return _filter((2 * w, w * w), w, force, interval)


def compute_loop_error(force: Array, natural_frequency: float, interval: float) -> Array:
    """(n,) departure of the controlled quantity from its set point while the needed force, 1/s,
    changes: s/(s + w)^2 (docs/methods/replay.md, Eq. 6). The input is linear between rows."""
    return _filter((1.0, 0.0), natural_frequency, force, interval)


def _filter(numerator: tuple[float, float], w: float, force: Array, interval: float) -> Array:
    coefficients, steady_state = _discretize(numerator, w, interval)
    steady = np.multiply.outer(steady_state, force[0])
    return np.asarray(signal.lfilter(*coefficients, force, axis=0, zi=steady)[0])


@cache
def _discretize(
    numerator: tuple[float, float], w: float, interval: float
) -> tuple[tuple[Array, Array], Array]:
    """Coefficients for an input that is linear between rows, and the steady state for a unit."""
    loop = signal.cont2discrete((numerator, (1.0, 2 * w, w * w)), interval, method="foh")
    coefficients = np.ravel(loop[0]), loop[1]
    return coefficients, signal.lfilter_zi(*coefficients)
