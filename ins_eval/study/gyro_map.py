"""What a gyro does wrong as a function of its pattern angle, in few numbers.

Measured rate less true rate W at pattern angle th: bias(th) + W scale(th), each a mean and
harmonics 2, 4, 8. `characterised` reads the map off the FMU, noise apart: whatever mechanisms a
device has, the map is theirs.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.fmu import GyroFmu
from pyhrg.units import DEG

Array = NDArray[np.float64]

HARMONICS = (2, 4, 8)
TERMS = 1 + 2 * len(HARMONICS)
"""Of a map: mean, and a cosine and a sine of each harmonic."""


@dataclass(frozen=True)
class GyroMap:
    """bias: (TERMS,) rad/s; scale: (TERMS,) 1; coefficients of `terms` of the pattern angle."""

    bias: Array
    scale: Array

    def started_at(self, angle: float) -> "GyroMap":
        """The same map over the pattern's turn from this angle, rad."""
        return GyroMap(_turned(self.bias, angle), _turned(self.scale, angle))

    @property
    def coefficients(self) -> Array:
        """(2 TERMS,) bias, then scale."""
        return np.concatenate([self.bias, self.scale])

    @staticmethod
    def of(coefficients: Array) -> "GyroMap":
        """The map of (2 TERMS,) coefficients."""
        return GyroMap(coefficients[:TERMS], coefficients[TERMS:])


def terms(angle: Array) -> Array:
    """(..., TERMS) 1, cos 2th, sin 2th, cos 4th, ... of pattern angles th (...), rad."""
    waves = [wave(h * angle) for h in HARMONICS for wave in (np.cos, np.sin)]
    return np.stack([np.ones_like(angle), *waves], axis=-1)


def _turned(coefficients: Array, angle: float) -> Array:
    turned = np.array(coefficients, dtype=float)
    for place, h in enumerate(HARMONICS):
        cos, sin = coefficients[1 + 2 * place : 3 + 2 * place]
        c, s = np.cos(h * angle), np.sin(h * angle)
        turned[1 + 2 * place : 3 + 2 * place] = cos * c + sin * s, sin * c - cos * s
    return turned


RATE = 1 * DEG
"""At which the table turns, either way, rad/s: slowly, since a delay of the loops makes of the
scale factor's map a bias that grows with the square of the rate."""
INTERVAL = 1.0
"""Between readings, s."""
SETTLING = 10.0
"""Before the first reading, s."""
BRYAN_FACTOR = 0.277


def characterised(fmu: GyroFmu, parameters: Mapping[str, float]) -> GyroMap:
    """The map of a gyro without noise, over half a turn of the pattern each way: a period
    of the second harmonic.

    Args:
        fmu: `HRGSlow`.
        parameters: of the FMU, SI, with every noise zero.
    """
    count = round(np.pi / (BRYAN_FACTOR * RATE) / INTERVAL)
    waiting = np.zeros(round(SETTLING / INTERVAL))
    rows, errors = [], []
    for rate in (RATE, -RATE):
        with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
            gyro.drive(waiting, INTERVAL)
            turning = {"angularRate": np.full((count, 1), rate)}
            ends, _ = gyro.record(turning, {}, INTERVAL, ["gyroAngle", "patternAngle"])
        errors.append(np.diff(ends[:, 0]) / INTERVAL - rate)
        at = terms(0.5 * (ends[1:, 1] + ends[:-1, 1]))
        rows.append(np.hstack([at, np.sign(rate) * at]))
    fitted = np.linalg.lstsq(np.vstack(rows), np.concatenate(errors), rcond=None)[0]
    return GyroMap(fitted[:TERMS], fitted[TERMS:] / RATE)
