"""What sensors do wrong, as coefficients of known signals along the true motion.

An effect belongs to all three gyros or all three accelerometers; each axis has a coefficient of
its own: error_i(t) = coefficient_i x regressor_i(t), measured less true, body axes.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.motion import Motion

Array = NDArray[np.float64]

BRYAN_FACTOR = 0.277
"""Turning of a gyro's pattern per turning of its case, backward."""

Sensor = Literal["gyro", "accelerometer"]


@dataclass(frozen=True)
class Effect:
    """One kind of error.

    unit: of its coefficients, SI; regressor: (m, 3) at a motion's nodes; correlation_time: s; a
    coefficient that wanders (Gauss-Markov, first order) instead of being constant. It holds over a
    step, which must be much shorter. family: effects that a budget counts as one; its own name
    unless given.
    """

    name: str
    sensor: Sensor
    unit: str
    regressor: Callable[[Motion], Array]
    correlation_time: float = np.inf
    family: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "family", self.family or self.name)


def _ones(motion: Motion) -> Array:
    return np.ones_like(motion.rate)


def gyro_bias(correlation_time: float = np.inf) -> Effect:
    """Constant rates, or wandering ones."""
    name = "gyro bias" if np.isinf(correlation_time) else "gyro bias instability"
    return Effect(name, "gyro", "rad/s", _ones, correlation_time)


def accelerometer_bias(correlation_time: float = np.inf) -> Effect:
    """Constant specific forces, or wandering ones."""
    wanders = "" if np.isinf(correlation_time) else " instability"
    return Effect(f"accelerometer bias{wanders}", "accelerometer", "m/s^2", _ones, correlation_time)


BIASES = (gyro_bias(), accelerometer_bias())
"""With position, velocity and attitude: the fifteen states."""


def gyro_scale_factor() -> Effect:
    """Measured rate over true rate, less 1."""
    return Effect("gyro scale factor", "gyro", "1", lambda motion: motion.rate)


def accelerometer_scale_factor() -> Effect:
    """Measured force over true force, less 1."""
    return Effect("accelerometer scale factor", "accelerometer", "1", lambda motion: motion.force)


def bias_map(harmonic: int, first_angle: Array) -> tuple[Effect, Effect]:
    """Bias that goes with the pattern angle: cosine and sine of so many times it.

    Args:
        harmonic: 2, 4, 8: multiple of the physical pattern angle.
        first_angle: (3,) pattern angles at the motion's start, rad.
    """

    def effect(name: str, wave: Callable[[Array], Array]) -> Effect:
        return Effect(
            f"bias map {name} {harmonic}",
            "gyro",
            "rad/s",
            lambda motion: wave(harmonic * pattern_angle(motion, first_angle)),
            family=f"bias map, harmonic {harmonic}",
        )

    return effect("cos", np.cos), effect("sin", np.sin)


def pick_off_map(harmonic: int, first_angle: Array) -> tuple[Effect, Effect]:
    """Scale factor that goes with the pattern angle (pick-offs of unequal gain, not orthogonal):
    true rate times the cosine and sine of so many times it. Arguments as `bias_map`."""

    def effect(name: str, wave: Callable[[Array], Array]) -> Effect:
        return Effect(
            f"pick-off map {name} {harmonic}",
            "gyro",
            "1",
            lambda motion: motion.rate * wave(harmonic * pattern_angle(motion, first_angle)),
            family=f"pick-off map, harmonic {harmonic}",
        )

    return effect("cos", np.cos), effect("sin", np.sin)


def pattern_angle(motion: Motion, first_angle: Array) -> Array:
    """(m, 3) pattern angles at the nodes, rad, of three gyros along the body axes."""
    return np.asarray(first_angle) - BRYAN_FACTOR * motion.turned
