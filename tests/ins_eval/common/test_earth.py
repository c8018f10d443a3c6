"""Normal gravity above the ellipsoid, against the gradient of its potential."""

import numpy as np
import pytest

from ins_eval.common import earth

GM = 3.986004418e14
"""Gravitational constant of WGS-84, m^3/s^2."""
POLAR = earth.SEMI_MAJOR * (1 - earth.FLATTENING)
FOCAL = earth.SEMI_MAJOR * np.sqrt(earth.ECCENTRICITY_SQUARED)
"""Linear eccentricity E of the ellipsoid, m."""


def series(ratio: float) -> float:
    """q of Heiskanen and Moritz (1967), Eq. 2-57, as a series in E/u."""
    n = np.arange(1, 12)
    return float(
        np.sum(2 * (-1.0) ** (n + 1) * n / ((2 * n + 1) * (2 * n + 3)) * ratio ** (2 * n + 1))
    )


def potential(r: float, z: float) -> float:
    """Normal potential, m^2/s^2, at a distance from the axis and a height over the equator
    (Heiskanen and Moritz 1967, Eq. 2-62)."""
    excess = r**2 + z**2 - FOCAL**2
    u = np.sqrt(0.5 * excess * (1 + np.sqrt(1 + (2 * FOCAL * z / excess) ** 2)))
    sin2 = (z / u) ** 2
    share = series(FOCAL / u) / series(FOCAL / POLAR)
    spin = earth.RATE**2 * earth.SEMI_MAJOR**2
    return float(
        GM / FOCAL * np.arctan(FOCAL / u)
        + 0.5 * spin * share * (sin2 - 1 / 3)
        + 0.5 * earth.RATE**2 * r**2
    )


@pytest.mark.parametrize("latitude_deg", [-60.0, 0.0, 20.0, 45.0, 75.0])
@pytest.mark.parametrize("height", [0.0, 2000.0, 12_000.0, 40_000.0])
def test_gravity_is_the_gradient_of_the_normal_potential(
    latitude_deg: float, height: float
) -> None:
    """North to 2 % of its size at 45 deg (Groves rounds and neglects h/R), down to 2e-6."""
    latitude, step = np.deg2rad(latitude_deg), 200.0
    sin, cos = np.sin(latitude), np.cos(latitude)
    normal = earth.transverse_radius(latitude)
    r = (normal + height) * cos
    z = (normal * (1 - earth.ECCENTRICITY_SQUARED) + height) * sin
    by_r = (potential(r + step, z) - potential(r - step, z)) / (2 * step)
    by_z = (potential(r, z + step) - potential(r, z - step)) / (2 * step)
    north, east = earth.horizontal_gravity(latitude, height, (0.0, 0.0))
    assert north == pytest.approx(cos * by_z - sin * by_r, abs=0.02 * 8.08e-9 * height + 1e-8)
    assert east == 0.0
    assert earth.gravity(latitude, height) == pytest.approx(-cos * by_r - sin * by_z, rel=2e-6)
