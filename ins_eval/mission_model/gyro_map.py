"""A gyro's bias and scale-factor error over its pattern angle, as harmonic coefficients.

Measured rate less true rate W at pattern angle th is bias(th) + W scale(th), each a mean and
harmonics 2, 4, 6, 8 (docs/methods/mission_model.md, Eq. 1). `measure_gyro_map` measures both by a
simulation of the FMU without noise, so that the map contains every mechanism of the device. Maps,
and weights of maps, are turned for patterns that start at other angles (Eq. 2).
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ins_eval.error_model.effects import ANGULAR_GAIN
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.device.device import AngleMap
from pyhrg.fmu import GyroFmu

HARMONICS = (2, 4, 6, 8)
TERMS = 1 + 2 * len(HARMONICS)
"""Number of terms of a map: the mean, and a cosine and a sine of each harmonic."""
NAMES = ("mean", *(f"{wave}{h}" for h in HARMONICS for wave in ("cos", "sin")))
"""Names of the terms, as in `pyhrg.device.device.AngleMap`, which has no sixth harmonic."""


def list_coefficients(angle_map: AngleMap) -> Array:
    """(TERMS,) coefficients of a map that a bench measured or electronics subtract."""
    return np.array([getattr(angle_map, name, 0.0) for name in NAMES])


def evaluate_terms(angle: Array) -> Array:
    """(..., TERMS) 1, cos 2th, sin 2th, cos 4th, ... of pattern angles th (...), rad."""
    waves = [wave(h * angle) for h in HARMONICS for wave in (np.cos, np.sin)]
    return np.stack([np.ones_like(angle), *waves], axis=-1)


def fit_coefficients(rows: Array, values: Array) -> Array:
    """(c,) least-squares coefficients of values (n,) by the normal equations, which suffice: the
    columns of rows (n, c) are harmonics over whole periods, nearly orthogonal."""
    return np.asarray(np.linalg.solve(rows.T @ rows, rows.T @ values))


SETTLING_S = 10.0
"""Time at rest before the first reading, s. Chosen."""


@dataclass(frozen=True)
class Sweep:
    """How the simulated turntable turns. rate: in both directions, rad/s; interval: time between
    readings, s."""

    rate: float
    interval: float

    @property
    def waiting(self) -> int:
        """Number of rows at rest before the first reading."""
        return round(SETTLING_S / self.interval)

    @property
    def rows(self) -> int:
        """Number of all rows in each direction."""
        return self.waiting + round(np.pi / (ANGULAR_GAIN * self.rate) / self.interval)


SLOW = Sweep(1 * DEG, 1.0)
"""Slow enough that the delay of the loops has no visible effect. With the scale factor's map it
makes a bias that grows with the square of the rate."""
FAST = Sweep(60 * DEG, 0.1)
"""Fast enough that the bias by that delay can be measured."""


def measure_gyro_map(
    fmu: GyroFmu,
    parameters: Mapping[str, float],
    inputs: Mapping[str, Array] | None = None,
    sweep: Sweep = SLOW,
) -> Array:
    """(2 TERMS,) coefficients of a gyro's bias, rad/s, then of its scale-factor error, by least
    squares over half a turn of the pattern in each direction.

    Half a turn is a period of the second harmonic.

    fmu: `HRGSlow`; parameters: parameters of the FMU, SI; every noise is zero; inputs: further
    inputs of the FMU during the sweep, (sweep.rows,) each, SI; sweep: the turntable's motion.
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
        at = evaluate_terms(0.5 * (ends[1:, 1] + ends[:-1, 1]))
        rows.append(np.hstack([at, np.sign(rate) * at]))
    fitted = fit_coefficients(np.vstack(rows), np.concatenate(errors))
    return np.concatenate([fitted[:TERMS], fitted[TERMS:] / sweep.rate])


def start_maps(maps: Array, angles: Array) -> Array:
    """(..., n TERMS, 3) maps over the pattern's turn from angles (..., 3), rad; leading dimensions
    are broadcast."""
    return _rotate_harmonics(maps, angles, sign=1.0)


def undo_start(maps: Array, angles: Array) -> Array:
    """The inverse of `start_maps`."""
    return _rotate_harmonics(maps, angles, sign=-1.0)


def turn_weights(weights: Array, angles: Array) -> Array:
    """(..., k, 2, n TERMS, 3) weights of maps over the pattern angle itself.

    Args:
        weights: (k, 2, n TERMS, 3) weights of maps over the turn from the start angle.
        angles: (..., 3) start angles, rad.
    """
    return _rotate_harmonics(weights, angles[..., None, None, :], sign=-1.0)


def _rotate_harmonics(values: Array, angles: Array, sign: float) -> Array:
    """Rotate cosine and sine of each harmonic h by h times the angles."""
    leading = np.broadcast_shapes(values.shape[:-2], angles.shape[:-1])
    mixed = np.array(np.broadcast_to(values, (*leading, *values.shape[-2:])))
    for first in range(0, values.shape[-2], TERMS):
        for place, h in enumerate(HARMONICS):
            at = first + 1 + 2 * place
            cos, sin = values[..., at, :], values[..., at + 1, :]
            c, s = np.cos(h * angles), sign * np.sin(h * angles)
            mixed[..., at, :] = cos * c + sin * s
            mixed[..., at + 1, :] = sin * c - cos * s
    return mixed
