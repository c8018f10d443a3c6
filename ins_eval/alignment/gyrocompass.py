"""Bounds of gyrocompassing in closed form: how well a standing vehicle can find north and level.

Attitude errors are rotation vectors about north, east, down, as in `TrackError`. The equations are
in docs/methods/alignment.md.
"""

import numpy as np
from numpy.typing import ArrayLike

from ins_eval.common import earth
from ins_eval.common.arrays import Array


def bias_sensitivity(latitude: ArrayLike, gravity: ArrayLike) -> Array:
    """Return the attitude error (..., 3, 6) per bias of gyros and accelerometers.

    docs/methods/alignment.md, Eq. 1 (Groves 2013, section 5.6.2). Attitude errors are about north,
    east, down, rad; biases are about and along the same axes, rad/s and m/s^2. A navigator that
    does not turn afterwards is affected neither by these biases nor by the attitude errors: they
    cancel.
    """
    sensitivity = np.zeros((*np.shape(latitude), 3, 6))
    sensitivity[..., 0, 4] = -1 / np.asarray(gravity)
    sensitivity[..., 1, 3] = 1 / np.asarray(gravity)
    sensitivity[..., 2, 1] = -1 / (earth.RATE * np.cos(latitude))
    sensitivity[..., 2, 4] = np.tan(latitude) / gravity
    return sensitivity


def heading_sigma(rate_variance: float, latitude: float) -> float:
    """Return the heading's standard deviation, rad, for a variance of the east rate, (rad/s)^2."""
    return float(np.sqrt(rate_variance) / (earth.RATE * np.cos(latitude)))


def averaged_rate_variance(angle_random_walk: float, duration: float) -> float:
    """Return the variance of a gyro's mean rate, (rad/s)^2, over a duration, s (Eq. 2).

    No method does better, even if the vehicle does not move at all.
    """
    return angle_random_walk**2 / duration


def fitted_rate_variance(angle_random_walk: float, tilt_noise: float, duration: float) -> float:
    """Return the variance of a straight line's slope fitted to the tilt, (rad/s)^2 (Eq. 3).

    This is the bound of alignment in the inertial frame. The tilt error is a random walk by the
    gyro's N, measured in white noise r: 6/5 N^2/T + 12 r^2/T^3.

    Args:
        angle_random_walk: N, rad/sqrt(s).
        tilt_noise: r, rad sqrt(s): velocity random walk over gravity.
        duration: T, s.
    """
    walk = 1.2 * angle_random_walk**2 / duration
    return walk + 12 * tilt_noise**2 / duration**3


def optimal_rate_variance(angle_random_walk: float, tilt_noise: float, duration: float) -> float:
    """Return the variance of the best linear estimate of the same slope, (rad/s)^2 (Eq. 4).

    It is N^2/(T - 2/k tanh(k T/2)) with k = N/r, the inverse of the smallest cost of a unit slope:
    the integral of (t - x)^2/r^2 + x'^2/N^2 over all x(t), so that x'' = k^2 (x - t) and x' = 0 at
    both ends. Without tilt noise it is Eq. 2, without random walk 12 r^2/T^3.
    """
    k = angle_random_walk / tilt_noise
    lost = 2 / k * np.tanh(k * duration / 2)
    return float(angle_random_walk**2 / (duration - lost))
