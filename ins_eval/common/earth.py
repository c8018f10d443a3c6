"""WGS-84: rotation, shape and gravity. Latitudes in rad; scalars or arrays."""

import numpy as np

from ins_eval.common.compiled import compiled
from pyhrg.common.site import EARTH_RATE

RATE = EARTH_RATE
"""Rotation rate, rad/s."""
SEMI_MAJOR = 6378137.0
"""Equatorial radius, m."""
FLATTENING = 1 / 298.257223563
ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING)
GRAVITY_EQUATOR = 9.7803253359
"""Normal gravity at the equator, m/s^2."""
SOMIGLIANA = 0.00193185265241
"""Somigliana's constant."""
GRAVITY_RATIO = 0.00344978650684
"""m = RATE^2 a^2 b / GM."""


@compiled
def meridian_radius(latitude):
    """Radius of curvature M in the meridian, m (Groves 2013, Eq. 2.105)."""
    w = 1 - ECCENTRICITY_SQUARED * np.sin(latitude) ** 2
    return SEMI_MAJOR * (1 - ECCENTRICITY_SQUARED) / (w * np.sqrt(w))


@compiled
def transverse_radius(latitude):
    """Radius of curvature N across the meridian, m (Groves 2013, Eq. 2.106)."""
    return SEMI_MAJOR / np.sqrt(1 - ECCENTRICITY_SQUARED * np.sin(latitude) ** 2)


@compiled
def gravity(latitude, height):
    """Normal gravity, m/s^2, down (NIMA TR8350.2, Eqs. 4-1 and 4-3)."""
    s = np.sin(latitude) ** 2
    surface = GRAVITY_EQUATOR * (1 + SOMIGLIANA * s) / np.sqrt(1 - ECCENTRICITY_SQUARED * s)
    ratio = height / SEMI_MAJOR
    slope = 1 + FLATTENING + GRAVITY_RATIO - 2 * FLATTENING * s
    return surface * (1 - 2 * slope * ratio + 3 * ratio**2)
