"""Tilting of a standing vehicle, estimated from its gyros' record.

Rotation about level axes in excess of the gyros' own noise is that of the vehicle. Its model is
white noise from step to step plus a random walk. A steady rate is left out: it contains the
heading. docs/methods/alignment.md, Eq. 7.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize

from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array

BOUNDS = ((1e-7, 1.0), (1e-10, 1.0))
"""Search ranges of `Tilting`. Chosen: below the lower ends the heading does not change."""


@dataclass(frozen=True)
class Tilting:
    """Tilting about each level axis.

    angle_white_noise: standard deviation, rad, including quantization; angle_random_walk:
    coefficient, rad/sqrt(s).
    """

    angle_white_noise: float
    angle_random_walk: float


def estimate_tilting(turned: Array, step: float, errors: SensorErrors) -> Tilting:
    """Estimate the tilting from the rotation `turned` (m, 2) about north and east since the start,
    rad, at the end of each step, s.

    It maximizes Whittle's likelihood of the periodogram of the mean rates, without frequency 0
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
    estimate = minimize(cost, start, method="Nelder-Mead", bounds=np.log(BOUNDS))
    return Tilting(*map(float, np.exp(estimate.x)))
