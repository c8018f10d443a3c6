"""What a gyro's map follows in flight: a map of its own for each signal, and their sum flies.

A harmonic of the scale factor is the error of the detected pattern angle, as rate. When it changes,
the angle that is read moves by itself, turning or not: at rest 3 ppm/K of an electrode's gain make
a bias of 0.02 deg/h while the gyro warms by 2 K in a minute. Maps grow with warmth w as
a w + b w^2: a calibrated gyro flies the small difference of large terms, each of its own curve.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.effects import (
    BRYAN_FACTOR,
    Effect,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
    pattern_angle,
    pick_off_map,
)
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.imu.gyros import case_axes
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS
from ins_eval.mission_model.missions import CASE_WARM_UP
from ins_eval.mission_model.warming import growth, heating, warmth

Array = NDArray[np.float64]
Regressor = Callable[[Motion], Array]

AXES = 3
CROSS_AXES = np.stack([case_axes(axis)[0] for axis in np.eye(AXES)])
"""(3, 3) x electrodes of the gyros along forward, right, down, a row each, in body axes."""


@dataclass(frozen=True)
class Signal:
    """name; value: (m, 1 or 3) of each gyro at a motion's nodes; rate: of its change, per s."""

    name: str
    value: Regressor
    rate: Regressor


def _over_time(
    name: str, value: Callable[[Array], Array], rate: Callable[[Array], Array]
) -> Signal:
    return Signal(name, lambda m: value(_nodes(m))[:, None], lambda m: rate(_nodes(m))[:, None])


def _of_motion(name: str, value: Regressor) -> Signal:
    return Signal(name, value, lambda m: np.gradient(value(m), m.step / PARTS, axis=0))


def _nodes(motion: Motion) -> Array:
    return np.asarray(motion.start + motion.step / PARTS * np.arange(len(motion.rate)))


SIGNALS = (
    _over_time("power-on", np.ones_like, np.zeros_like),
    _over_time("warmth", warmth, growth),
    _over_time("warmth squared", lambda t: warmth(t) ** 2, lambda t: 2 * warmth(t) * growth(t)),
    _over_time("heating", heating, lambda t: -heating(t) / CASE_WARM_UP),
    _of_motion("specific force along x electrodes, m/s^2", lambda m: m.force @ CROSS_AXES.T),
    _of_motion("specific force along input axis, m/s^2", lambda m: m.force),
    _of_motion("rate squared, (rad/s)^2", lambda m: m.rate**2),
)
STEADY, WARMING, ENVIRONMENT = slice(0, 1), slice(1, 3), slice(3, 7)
"""Of `SIGNALS`, by what makes them."""
COUNT = len(SIGNALS) * 2 * TERMS
"""Coefficients in flight: those of a `GyroMap` for each signal in turn."""


def coefficients_of(signals: slice) -> slice:
    """Of `COUNT`, those of some signals."""
    return slice(signals.start * 2 * TERMS, signals.stop * 2 * TERMS)


def signal_effects() -> list[Effect]:
    """`COUNT` effects, started at pattern angle 0."""
    zero = np.zeros(AXES)
    bias = [gyro_bias(), *(e for h in HARMONICS for e in bias_map(h, zero))]
    scale = [gyro_scale_factor(), *(e for h in HARMONICS for e in pick_off_map(h, zero))]
    errors = [*[None] * (TERMS + 1), *angle_errors(zero)]
    return [
        following(effect, signal, error)
        for signal in SIGNALS
        for effect, error in zip((*bias, *scale), errors, strict=True)
    ]


def following(effect: Effect, signal: Signal, angle_error: Regressor | None = None) -> Effect:
    """An effect whose coefficient follows a signal.

    Args:
        effect: as it is where the signal is 1.
        signal: what it follows.
        angle_error: the effect's integral over the turn, (m, 3) rad per coefficient, if it is the
            rate of an angle's error.
    """

    def regressor(motion: Motion) -> Array:
        followed = effect.regressor(motion) * signal.value(motion)
        if angle_error is None:
            return np.asarray(followed)
        return np.asarray(followed + angle_error(motion) * signal.rate(motion))

    return replace(effect, name=f"{effect.name}, {signal.name}", regressor=regressor)


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
