"""What a gyro does wrong as a function of its pattern angle, in few numbers.

Measured rate less true rate W at pattern angle th: bias(th) + W scale(th), each a mean and
harmonics 2, 4, 6, 8. `characterised` reads the map off the FMU, noise apart: whatever mechanisms a
device has, the map is theirs.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.effects import BRYAN_FACTOR
from pyhrg.common.units import DEG
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

HARMONICS = (2, 4, 6, 8)
TERMS = 1 + 2 * len(HARMONICS)
"""Of a map: mean, and a cosine and a sine of each harmonic."""
NAMES = ("mean", *(f"{wave}{h}" for h in HARMONICS for wave in ("cos", "sin")))
"""Of the terms, as those of `pyhrg.device.device.AngleMap`, which has no sixth harmonic."""


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


WAITING = 10.0
"""At rest before the first reading, s."""


@dataclass(frozen=True)
class Sweep:
    """How the table turns while a map is read: rate, either way, rad/s; interval between readings,
    s."""

    rate: float
    interval: float

    @property
    def waiting(self) -> int:
        """Rows at rest before the first reading."""
        return round(WAITING / self.interval)

    @property
    def rows(self) -> int:
        """All rows each way."""
        return self.waiting + round(np.pi / (BRYAN_FACTOR * self.rate) / self.interval)


SLOW = Sweep(1 * DEG, 1.0)
"""So that a delay of the loops, which makes of the scale factor's map a bias that grows with the
square of the rate, doesn't show."""
FAST = Sweep(60 * DEG, 0.1)
"""So that it does."""


def characterised(
    fmu: GyroFmu,
    parameters: Mapping[str, float],
    inputs: Mapping[str, Array] | None = None,
    sweep: Sweep = SLOW,
) -> GyroMap:
    """The map of a gyro without noise, over half a turn of the pattern each way: a period
    of the second harmonic.

    Args:
        fmu: `HRGSlow`.
        parameters: of the FMU, SI, with every noise zero.
        inputs: of the FMU meanwhile, (sweep.rows,) each, SI.
        sweep: of the table.
    """
    others = {name: values[:, None] for name, values in (inputs or {}).items()}
    rows, errors = [], []
    for rate in (sweep.rate, -sweep.rate):
        turning = rate * np.repeat([0.0, 1.0], [sweep.waiting, sweep.rows - sweep.waiting])[:, None]
        with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
            moving = {"angularRate": turning, **others}
            ends, _ = gyro.record(moving, {}, sweep.interval, ["gyroAngle", "patternAngle"])
        ends = ends[sweep.waiting :]
        errors.append(np.diff(ends[:, 0]) / sweep.interval - rate)
        at = terms(0.5 * (ends[1:, 1] + ends[:-1, 1]))
        rows.append(np.hstack([at, np.sign(rate) * at]))
    fitted = np.linalg.lstsq(np.vstack(rows), np.concatenate(errors), rcond=None)[0]
    return GyroMap(fitted[:TERMS], fitted[TERMS:] / sweep.rate)
