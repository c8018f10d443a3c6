"""WGS-84: rotation, shape and normal gravity. All functions take scalars or arrays; rad and m."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pyhrg.common.caches.compiled import compile_loop
from pyhrg.common.site import EARTH_RATE

RATE = EARTH_RATE
"""Rotation rate of Earth, rad/s."""
SEMI_MAJOR = 6378137.0
"""Equatorial radius, m."""
FLATTENING = 1 / 298.257223563
"""Flattening f of the ellipsoid."""
ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING)
"""First eccentricity of the ellipsoid, squared."""
GRAVITY_EQUATOR = 9.7803253359
"""Normal gravity on the ellipsoid at the equator, m/s^2."""
SOMIGLIANA = 0.00193185265241
"""Constant k of Somigliana's formula for normal gravity."""
GRAVITY_RATIO = 0.00344978650684
"""Centrifugal acceleration over gravitation at the equator, m = RATE^2 a^2 b / GM."""

PLUMB_LINE = 8.08e-9
"""The north component of normal gravity is -PLUMB_LINE h sin(2 phi) at height h, by the curvature
of the plumb line, 1/s^2 (Groves 2013, Eq. 2.140)."""


@compile_loop
def meridian_radius(latitude):
    """Radius of curvature M of the meridian, m (Groves 2013, Eq. 2.105)."""
    w = 1 - ECCENTRICITY_SQUARED * np.sin(latitude) ** 2
    return SEMI_MAJOR * (1 - ECCENTRICITY_SQUARED) / (w * np.sqrt(w))


@compile_loop
def transverse_radius(latitude):
    """Radius of curvature N of the prime vertical, m (Groves 2013, Eq. 2.106)."""
    return SEMI_MAJOR / np.sqrt(1 - ECCENTRICITY_SQUARED * np.sin(latitude) ** 2)


@compile_loop
def gravity(latitude, height):
    """Normal gravity, m/s^2, positive down, at a height to second order (NIMA TR8350.2, Eqs. 4-1
    and 4-3)."""
    s = np.sin(latitude) ** 2
    surface = GRAVITY_EQUATOR * (1 + SOMIGLIANA * s) / np.sqrt(1 - ECCENTRICITY_SQUARED * s)
    ratio = height / SEMI_MAJOR
    slope = 1 + FLATTENING + GRAVITY_RATIO - 2 * FLATTENING * s
    return surface * (1 - 2 * slope * ratio + 3 * ratio**2)


@compile_loop
def horizontal_gravity(latitude, height, deflection):
    """North and east component of gravity, m/s^2, in axes of the ellipsoid.

    The north component of normal gravity is that of the plumb line, which is curved. A deflection
    of the vertical (xi, eta), rad, turns the zenith to the north and to the east (Heiskanen and
    Moritz 1967, section 2-23), so that gravity points to the south and to the west.
    """
    down = gravity(latitude, height)
    north = -PLUMB_LINE * height * np.sin(2 * latitude)
    return north - deflection[0] * down, -deflection[1] * down


def rotation_rate(latitude: ArrayLike) -> NDArray[np.float64]:
    """Earth's rotation `omega_ie_n` (..., 3), rad/s, north, east, down, at latitudes (...)."""
    north, down = np.cos(latitude), -np.sin(latitude)
    return RATE * np.stack([north, np.zeros_like(north), down], axis=-1)
