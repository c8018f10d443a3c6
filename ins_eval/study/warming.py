"""What a map does while it changes: a gyro warms after power-on, and its coefficients with it.

A harmonic of the scale factor is the error of the detected pattern angle, as rate. When it grows,
the angle that is read moves by itself, turning or not: at rest 3 ppm/K of an electrode's gain make
a bias of 0.02 deg/h while the gyro warms by 2 K in a minute. Coefficients grow with warmth w as
a w + b w^2: a calibrated gyro flies the small difference of large terms, each of its own curve.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.effects import BRYAN_FACTOR, Effect, pattern_angle
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.study.gyro_map import HARMONICS
from ins_eval.study.missions import STILL, WARM_UP

Array = NDArray[np.float64]
Regressor = Callable[[Motion], Array]


def warmth(time: Array) -> Array:
    """How far a gyro has warmed since power-on, 0 to 1; time: s since alignment."""
    return np.asarray(1 - np.exp(-(time + STILL) / WARM_UP))


def growing(effect: Effect, power: int, angle_error: Regressor | None = None) -> Effect:
    """An effect whose coefficient grows with a power of warmth.

    Args:
        effect: as it is when warm.
        power: 1 or 2.
        angle_error: its integral over the turn, (m, 3) rad per coefficient, if it is the rate of
            an angle's error.
    """

    def regressor(motion: Motion) -> Array:
        nodes = np.arange(len(motion.rate), dtype=np.float64)
        time = np.asarray(motion.start + motion.step / PARTS * nodes)
        warm = warmth(time)[:, None]
        grown = effect.regressor(motion) * warm**power
        if angle_error is None:
            return np.asarray(grown)
        return np.asarray(grown + angle_error(motion) * _growth(warm, power))

    return replace(effect, name=f"{effect.name}, warming {power}", regressor=regressor)


def _growth(warm: Array, power: int) -> Array:
    """Rate of change of a power of warmth, 1/s."""
    return np.asarray(power * warm ** (power - 1) * (1 - warm) / WARM_UP)


def angle_errors(first_angle: Array) -> list[Regressor]:
    """Angle errors whose rates are the harmonics of the scale factor, cosine and sine in turn.

    Args:
        first_angle: (3,) pattern angles at the motion's start, rad.
    """

    def error(harmonic: int, sign: float, wave: Callable[[Array], Array]) -> Regressor:
        factor = sign / (harmonic * BRYAN_FACTOR)
        return lambda motion: factor * wave(harmonic * pattern_angle(motion, first_angle))

    waves = ((-1.0, np.sin), (1.0, np.cos))
    return [error(h, sign, wave) for h in HARMONICS for sign, wave in waves]
