"""A vibration as two waves that travel around the shell in opposite senses.

The waves are the circular components of the complex envelope, C+ = X + iY and C- = X - iY with
X = cx - i sx and Y = cy - i sy. An orbit of amplitude a, quadrature q, pattern angle th and phase
phi is C+ = (a + q) exp(i(phi + 2 th)), C- = (a - q) exp(i(phi - 2 th)).
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pyhrg.device.device import Device


def split_into_waves(displacement: ArrayLike) -> tuple[complex, complex]:
    """Complex amplitudes (C+, C-) of a displacement {cx, sx, cy, sy}."""
    cos_x, sin_x, cos_y, sin_y = np.asarray(displacement, dtype=float)
    x, y = complex(cos_x, -sin_x), complex(cos_y, -sin_y)
    return x + 1j * y, x - 1j * y


def unequal_wave_bias(
    device: Device, pattern_angle: ArrayLike, quadrature: float
) -> NDArray[np.float64]:
    """Output bias at rest, rad/s, at pattern angles (n,), rad, of waves of amplitudes 1 + q, 1 - q.

    Damping anisotropy and frequency split couple the waves. With rho = (1 - q)/(1 + q) the rate of
    their phase difference, 4 th', is (D/2)(rho + 1/rho) sin 4(th - th_tau) +
    (dw/2)(1/rho - rho) cos 4(th - th_w): Lynch's averaged equation, in which
    (rho + 1/rho)/2 = (1 + q^2)/(1 - q^2) and (1/rho - rho)/2 = 2q/(1 - q^2).
    """
    angle = np.asarray(pattern_angle, dtype=float)
    ratio = (1 - quadrature) / (1 + quadrature)
    damping = device.damping_anisotropy * np.sin(4 * (angle - device.damping_axis))
    split = device.frequency_split * np.cos(4 * (angle - device.stiffness_axis))
    difference = damping * (ratio + 1 / ratio) / 2 + split * (1 / ratio - ratio) / 2
    return np.asarray(-difference / (4 * device.bryan_factor))
