"""Sensor errors as coefficients times known signals along the true motion.

An effect belongs to all three gyros or to all three accelerometers, and each axis has its own
coefficient: error_i(t) = coefficient_i x regressor_i(t), measured less true, in body axes
(docs/methods/error_model.md, Eq. 6).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from ins_eval.error_model.motion import Motion
from pyhrg.common.arrays import Array

ANGULAR_GAIN = 0.277
"""Angular gain (Bryan factor) k of a hemispherical gyro: the pattern lags the case by k times its
rotation."""

Sensor = Literal["gyro", "accelerometer"]


@dataclass(frozen=True)
class Effect:
    """One kind of sensor error.

    Attributes:
        regressor: signal (m, 3) at the nodes of a motion, per SI unit of the coefficient.
        correlation_time: correlation time of the coefficients, s; infinite for constants. Otherwise
            they are first-order Gauss-Markov processes, constant during a step, which must be much
            shorter.
        family: name under which a budget sums several effects; by default the effect's own name.
    """

    name: str
    sensor: Sensor
    regressor: Callable[[Motion], Array]
    correlation_time: float = np.inf
    family: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "family", self.family or self.name)


def _ones(motion: Motion) -> Array:
    return np.ones_like(motion.rate)


def gyro_bias(correlation_time: float = np.inf) -> Effect:
    """Gyro bias: constant, or a Gauss-Markov process that is part of the bias instability."""
    name = "gyro bias" if np.isinf(correlation_time) else "gyro bias instability"
    return Effect(name, "gyro", _ones, correlation_time)


def accelerometer_bias(correlation_time: float = np.inf) -> Effect:
    """Accelerometer bias: constant, or a Gauss-Markov process, part of the bias instability."""
    wanders = "" if np.isinf(correlation_time) else " instability"
    return Effect(f"accelerometer bias{wanders}", "accelerometer", _ones, correlation_time)


BIASES = (gyro_bias(), accelerometer_bias())
"""Effects that complete position, velocity and attitude to the usual fifteen-state model."""


def gyro_scale_factor() -> Effect:
    return Effect("gyro scale factor", "gyro", lambda motion: motion.rate)


def accelerometer_scale_factor() -> Effect:
    return Effect("accelerometer scale factor", "accelerometer", lambda motion: motion.force)


def misalignment(sensor: Sensor) -> tuple[Effect, Effect]:
    """What each axis feels of the next and of the one after it (Groves 2013, Eq. 4.16): input axes
    that lean towards these."""

    def felt(shift: int) -> Callable[[Motion], Array]:
        def regressor(motion: Motion) -> Array:
            return np.roll(motion.rate if sensor == "gyro" else motion.force, -shift, axis=1)

        return regressor

    family = f"{sensor} misalignment"
    return (
        Effect(f"{family}, next axis", sensor, felt(1), family=family),
        Effect(f"{family}, axis after", sensor, felt(2), family=family),
    )


def bias_map(harmonic: int, first_angle: Array) -> tuple[Effect, Effect]:
    """Bias map: cosine and sine of `harmonic` times the physical pattern angle, which is
    `first_angle` (3,), rad, at the start."""
    return _follow_pattern("bias map", harmonic, first_angle, _ones)


def pick_off_map(
    harmonic: int, first_angle: Array, decay_time: float = np.inf
) -> tuple[Effect, Effect]:
    """Scale-factor map: true rate times the cosine and sine of a multiple of the pattern angle, by
    pick-offs of unequal gain or that are not orthogonal. Arguments as of `bias_map`.

    With a decay time tau, s, of the resonator there is a bias besides (docs/methods/error_model.md,
    Eq. 6a): the amplitude force is misaimed by the error of the detected angle.
    """
    cosine, sine = _follow_pattern("pick-off map", harmonic, first_angle, lambda m: m.rate)
    by_force = 1 / (harmonic * ANGULAR_GAIN * decay_time)
    bias_cosine, bias_sine = _follow_pattern("", harmonic, first_angle, _ones)
    return (
        replace(cosine, regressor=_combine(cosine, -by_force, bias_sine)),
        replace(sine, regressor=_combine(sine, by_force, bias_cosine)),
    )


def _combine(first: Effect, factor: float, then: Effect) -> Callable[[Motion], Array]:
    return lambda motion: first.regressor(motion) + factor * then.regressor(motion)


def _follow_pattern(
    name: str, harmonic: int, first_angle: Array, factor: Callable[[Motion], Array]
) -> tuple[Effect, Effect]:
    def effect(wave_name: str, wave: Callable[[Array], Array]) -> Effect:
        return Effect(
            f"{name} {wave_name} {harmonic}",
            "gyro",
            lambda motion: factor(motion) * wave(harmonic * pattern_angle(motion, first_angle)),
            family=f"{name}, harmonic {harmonic}",
        )

    return effect("cos", np.cos), effect("sin", np.sin)


def pattern_angle(motion: Motion, first_angle: Array) -> Array:
    """Return the pattern angles (m, 3), rad, at the nodes, of gyros along the body axes."""
    return np.asarray(first_angle) - ANGULAR_GAIN * motion.turned
