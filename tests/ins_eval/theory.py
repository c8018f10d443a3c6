"""Closed forms of an inertial navigator's errors at rest.

The vehicle is at rest and its height is clamped, so that the linear error equations have constant
coefficients (Britting 1971, chapter 8; Titterton and Weston 2004, section 12.3;
Groves 2013, section 14.2). Signs are those of `TrackError`: navigator less truth.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.linalg import expm

from ins_eval.alignment.kalman import standing
from ins_eval.common import earth
from pyhrg.common.arrays import Array

STATES = 7
"""Attitude about north, east and down (rad), velocity north and east (m/s), position north and
east (m)."""
ATTITUDE, VELOCITY, POSITION = slice(0, 3), slice(3, 5), slice(5, 7)


class Frequencies(NamedTuple):
    """Frequencies of free errors, rad/s: two Schuler modes, whose beat is Foucault's, and Earth's
    rate."""

    fast: float
    slow: float
    earth: float


def schuler_frequency(latitude: float, height: float = 0.0) -> float:
    """Return sqrt(g/R), rad/s, a period of 84.4 min (Schuler 1923); R is the geometric mean of both
    radii of curvature."""
    radius = np.sqrt(_radius_n(latitude, height) * _radius_e(latitude, height))
    return float(np.sqrt(earth.gravity(latitude, height) / radius))


def free_frequencies(latitude: float, height: float = 0.0) -> Frequencies:
    """Return the frequencies of the roots of (s^2 + W^2) ((s^2 + ws^2)^2 + 4 s^2 W^2 sin^2 L),
    which hold on a sphere (Britting 1971, chapter 8)."""
    vertical = earth.RATE * np.sin(abs(latitude))
    middle = np.hypot(schuler_frequency(latitude, height), vertical)
    return Frequencies(float(middle + vertical), float(middle - vertical), earth.RATE)


@dataclass(frozen=True)
class AtRest:
    """A navigator at rest at a latitude, rad, and a clamped height, m."""

    latitude: float
    height: float = 0.0

    def dynamics(self) -> Array:
        """Return F (7, 7) of dx/dt = F x + u, in the order of `STATES`: the alignment filter's."""
        return standing.dynamics(self.latitude, self.height)[:STATES, :STATES]

    def errors(self, time: Array, start: Array, gyro_bias: Array, force_bias: Array) -> Array:
        """Return the errors (m, 7) at equally spaced times (m,), s, the first of which is 0.

        Args:
            start: (7,) errors at time 0.
            gyro_bias, force_bias: (3,) in navigation axes, rad/s and m/s^2; the down component of
                the latter has no effect.
        """
        augmented = np.zeros((STATES + 1, STATES + 1))
        augmented[:STATES, :STATES] = self.dynamics()
        augmented[ATTITUDE, STATES] = gyro_bias
        augmented[VELOCITY, STATES] = np.asarray(force_bias)[:2]
        transition = expm(augmented * (time[1] - time[0]))
        states = [np.append(start, 1.0)]
        for _ in time[1:]:
            states.append(transition @ states[-1])
        return np.array(states)[:, :STATES]


def drift_of_level_gyro(bias: float, time: Array, latitude: float) -> Array:
    """Return the position error, m, R b (t - sin(ws t)/ws), which holds for a few hours.

    That of a north gyro is east, that of an east gyro south (Titterton and Weston 2004, section
    12.3).
    """
    ws = schuler_frequency(latitude)
    return np.asarray(_radius(latitude) * bias * (time - np.sin(ws * time) / ws))


def drift_of_down_gyro(bias: float, time: Array, latitude: float) -> Array:
    """Return the position error south, m, R b W cos L (t^2/2 - (1 - cos(ws t))/ws^2); as above."""
    ws = schuler_frequency(latitude)
    grown = 0.5 * time**2 - (1 - np.cos(ws * time)) / ws**2
    return np.asarray(_radius(latitude) * bias * earth.RATE * np.cos(latitude) * grown)


def drift_of_accelerometer(bias: float, time: Array, latitude: float) -> Array:
    """Return the position error along the bias, m, b (1 - cos(ws t))/ws^2; as above."""
    ws = schuler_frequency(latitude)
    return np.asarray(bias * (1 - np.cos(ws * time)) / ws**2)


def gyrocompassing_error(gyro_bias: Array, force_bias: Array, latitude: float) -> Array:
    """Return the attitude error (3,), rad, of gyrocompassing with biases in navigation axes.

    Tilts are b/g, and the east gyro causes a heading error of -b/(W cos L) (Groves 2013, section
    5.6.2).
    """
    gravity = earth.gravity(latitude, 0.0)
    about_north, about_east = -force_bias[1] / gravity, force_bias[0] / gravity
    rate = earth.RATE * np.cos(latitude)
    heading = -(gyro_bias[1] / rate + about_north * np.tan(latitude))
    return np.array([about_north, about_east, heading])


def free_height(error: float, time: Array, latitude: float) -> Array:
    """Return the growth of a free height error, m: error cosh(sqrt(2 g/R) t) (Groves 2013, section
    5.7), with the slope of normal gravity for 2 g/R."""
    return np.asarray(error * np.cosh(np.sqrt(gravity_slope(latitude)) * time))


def damped_height(step: float, time: Array, time_constant: float, latitude: float) -> Array:
    """Return the height error after a step of the barometer, m: the response of the triple pole,
    1 - exp(-a t) (1 - 2 a t + (a^2 - 2 g/R) t^2/2), a = 1 / time_constant (Siouris 1993, 4.5)."""
    a = 1 / time_constant
    bracket = 1 - 2 * a * time + (a**2 - gravity_slope(latitude)) * time**2 / 2
    return np.asarray(step * (1 - np.exp(-a * time) * bracket))


def gravity_slope(latitude: float) -> float:
    """Return -dg/dh at the ellipsoid, 1/s^2 (NIMA TR8350.2, Eq. 4-3)."""
    sin = np.sin(latitude)
    slope = 1 + earth.FLATTENING + earth.GRAVITY_RATIO - 2 * earth.FLATTENING * sin**2
    return float(2 * earth.gravity(latitude, 0.0) * slope / earth.SEMI_MAJOR)


def _radius_n(latitude: float, height: float) -> float:
    return float(earth.meridian_radius(latitude)) + height


def _radius_e(latitude: float, height: float) -> float:
    return float(earth.transverse_radius(latitude)) + height


def _radius(latitude: float) -> float:
    return float(earth.gravity(latitude, 0.0)) / schuler_frequency(latitude) ** 2
