"""How well a standing vehicle can find north and level, in closed form.

Attitude errors are rotation vectors about north, east, down, as in
`ins_eval.common.state.TrackError`.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.common import earth

Array = NDArray[np.float64]


def bias_sensitivity(latitude: float, gravity: float) -> Array:
    """(3, 6): attitude error per gyro and accelerometer bias about and along north, east, down.

    The tilts cancel the accelerometers' biases and the rotation of Earth that heading and tilt
    show to the east gyro cancels its bias, so that a navigator that does not turn sees neither
    (Groves 2013, section 5.6.2): north -b_E/g, east b_N/g, down
    -e_E/(RATE cos latitude) + b_E/g tan latitude.
    """
    sensitivity = np.zeros((3, 6))
    sensitivity[0, 4] = -1 / gravity
    sensitivity[1, 3] = 1 / gravity
    sensitivity[2, 1] = -1 / (earth.RATE * np.cos(latitude))
    sensitivity[2, 4] = np.tan(latitude) / gravity
    return sensitivity


def heading_sigma(rate_variance: float, latitude: float) -> float:
    """rad, of an east rate that is known to a variance, (rad/s)^2."""
    return float(np.sqrt(rate_variance) / (earth.RATE * np.cos(latitude)))


def averaged_rate_variance(angle_random_walk: float, duration: float) -> float:
    """Of the mean of a gyro at rest, (rad/s)^2; the best where the vehicle does not move at all."""
    return angle_random_walk**2 / duration


def fitted_rate_variance(angle_random_walk: float, tilt_noise: float, duration: float) -> float:
    """Of the slope of a straight line fitted to the tilt by least squares, (rad/s)^2.

    What gravity's direction in the inertial frame gives. The tilt walks by the gyro's N and is
    measured in white noise r: 6/5 N^2/T + 12 r^2/T^3.

    Args:
        angle_random_walk: N, rad/sqrt(s).
        tilt_noise: r, rad sqrt(s): velocity random walk over gravity.
        duration: T, s.
    """
    walk = 1.2 * angle_random_walk**2 / duration
    return walk + 12 * tilt_noise**2 / duration**3


def optimal_rate_variance(angle_random_walk: float, tilt_noise: float, duration: float) -> float:
    """Of the best linear estimate of the same slope: N^2/(T - 2/k tanh(k T/2)), k = N/r.

    The inverse of the least cost J of fitting a unit slope by a walk: with x(t) free,
    J = min of the integral of (t - x)^2/r^2 + x'^2/N^2, so x'' = k^2 (x - t), x' = 0 at both ends.
    Without tilt noise it is the gyro's average; without walk, the straight line's 12 r^2/T^3.
    """
    k = angle_random_walk / tilt_noise
    lost = 2 / k * np.tanh(k * duration / 2)
    return float(angle_random_walk**2 / (duration - lost))
