"""How much a standing vehicle tilts, from its gyros' record.

As much of the rotation about level axes as the gyros' own noise leaves unexplained is the
vehicle's: to and fro, white from step to step, and wandering off, a random walk. Rotation at a
steady rate is not looked at: it is what heading shows in.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from ins_eval.common.sensor_errors import SensorErrors

Array = NDArray[np.float64]

BOUNDS = ((1e-7, 1.0), (1e-10, 1.0))
"""Of `Tilting`; less than its lower end makes no difference to heading."""


@dataclass(frozen=True)
class Tilting:
    """On each level axis. white: standard deviation, rad, the counts' remainders in it;
    walk: rad/sqrt(s)."""

    white: float
    walk: float


def likeliest_tilting(turned: Array, step: float, errors: SensorErrors) -> Tilting:
    """The likeliest of rotations since the start (m, 2), rad, every step, s.

    Whittle's likelihood of the periodogram of the steps' mean rates, frequency 0 left out
    (Whittle 1953).
    """
    rate = np.diff(turned, axis=0, prepend=0.0) / step
    frequency = np.fft.rfftfreq(len(rate), step)[1:]
    periodogram = np.mean(np.abs(np.fft.rfft(rate, axis=0)[1:]) ** 2, axis=1) * step / len(rate)
    own = errors.angle_random_walk**2 + errors.gyro_bias_instability**2 / (2 * np.pi * frequency)
    differenced = 4 * np.sin(np.pi * frequency * step) ** 2 / step

    def cost(logarithms: Array) -> float:
        white, walk = np.exp(2 * logarithms)
        density = own + white * differenced + walk
        return float(np.sum(np.log(density) + periodogram / density))

    spread = float(np.sqrt(np.mean(periodogram)))
    start = np.clip(np.log([spread * np.sqrt(step) + 1e-30, spread + 1e-30]), *np.log(BOUNDS).T)
    found = minimize(cost, start, method="Nelder-Mead", bounds=np.log(BOUNDS))
    return Tilting(*map(float, np.exp(found.x)))
