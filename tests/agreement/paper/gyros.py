"""Gyros of the FMU as the paper's claims need them."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from fmu_build.bundle import build_fmu
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu
from tests.driving import advance

Parameters = Mapping[str, float]

K = 0.277
TAU = 450.0
"""Bryan factor and decay time, s, of the gyros here: the FMU's own."""
DAMPING = "resonator.material.dampingAnisotropy"
DAMPING_AXIS = "resonator.material.dampingAxis"
SPLIT = "resonator.material.frequencySplit"
STIFFNESS_AXIS = "resonator.material.stiffnessAxis"
QUADRATURE = "controller.quadratureSetpoint"


@cache
def load_fmu(model: str = "HRG") -> GyroFmu:
    """One of `ROOTS`, built where it is not yet."""
    return GyroFmu(build_fmu(model))


def simulate_output_rate(
    parameters: Parameters,
    start_angle: float,
    rate: float = 0.0,
    settle: float = 5.0,
    duration: float = 1.0,
    model: str = "HRG",
    **commands: float,
) -> float:
    """Mean output rate, rad/s, over `duration` s after `settle` s.

    Args:
        parameters: of the FMU, by name, SI.
        start_angle: of the pattern, rad.
        rate: of the case, rad/s.
        commands: inputs of the FMU that are held, SI.
    """
    with load_fmu(model).power_on(parameters, seed=0, start_angle=start_angle) as gyro:
        for name, value in commands.items():
            gyro.command(name, value)
        begin = advance(gyro, rate, settle)
        return (advance(gyro, rate, duration) - begin) / duration


@dataclass(frozen=True)
class Turn:
    """A turn at constant rate: (n,) true angle of the pattern and the gyro's angle, rad, at times
    (n,), s."""

    time: Array
    pattern_angle: Array
    gyro_angle: Array


def simulate_turn(
    parameters: Parameters, rate: float, duration: float, settle: float = 10.0
) -> Turn:
    """The case turned at a rate, rad/s, read every 0.1 s, from `settle` s on."""
    rows, step = round((settle + duration) / 0.1), 0.01
    moving = {"angularRate": np.full((rows, 10), rate)}
    with load_fmu().power_on(parameters, seed=0, start_angle=0.0) as gyro:
        ends, _ = gyro.record(moving, {}, step, ["patternAngle", "gyroAngle"])
    late = slice(round(settle / 0.1) - 1, None)
    time = 0.1 * np.arange(1.0, rows + 1)
    return Turn(time[late], *ends[late].T)
