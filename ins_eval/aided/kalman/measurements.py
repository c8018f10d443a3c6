"""What a fix says of the navigator's errors: differences, sensitivities, variances
(docs/methods/aided.md, Eqs. 4 to 6)."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ins_eval.aided.fixes import Fixes
from ins_eval.common.rotation import skew
from ins_eval.common.state import State, displace, position_error
from ins_eval.error_model.dynamics import ATTITUDE, COUNT, POSITION, VELOCITY
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class Measurement:
    """m components of a fix.

    difference: (m,) computed less measured; sensitivity: (m, 10) to the errors of the navigator at
    the bound of a step; variance: (m,).
    """

    difference: Array
    sensitivity: Array
    variance: Array


def compare_fix(
    fixes: Fixes, row: int, state: State, rate: Array, lag: float, lever_arm: Array
) -> Iterator[Measurement]:
    """Measurements of one row of fixes.

    state: computed, at the fix; rate: (3,) `omega_ib_b`, rad/s; lag: time of the fix less that of
    the errors, s; lever_arm: (3,) from IMU to antenna in body axes, m.
    """
    if np.isfinite(fixes.position[row, 0]):
        yield _compare_position(fixes, row, state, lag, lever_arm)
    if np.isfinite(fixes.velocity[row, 0]):
        yield _compare_velocity(fixes, row, state, rate, lever_arm)
    if np.isfinite(fixes.speed[row]):
        yield _compare_speed(fixes, row, state)


def _compare_position(
    fixes: Fixes, row: int, state: State, lag: float, lever_arm: Array
) -> Measurement:
    arm = state.mat_nb @ lever_arm
    sensitivity = np.zeros((3, COUNT))
    sensitivity[:, POSITION] = np.eye(3)
    sensitivity[:, VELOCITY] = lag * np.eye(3)
    sensitivity[:, ATTITUDE] = -skew(arm)
    difference = position_error(displace(state.position, arm), fixes.position[row])
    return Measurement(difference, sensitivity, fixes.position_sigma[row] ** 2)


def _compare_velocity(
    fixes: Fixes, row: int, state: State, rate: Array, lever_arm: Array
) -> Measurement:
    swing = state.mat_nb @ np.cross(rate, lever_arm)
    sensitivity = np.zeros((3, COUNT))
    sensitivity[:, VELOCITY] = np.eye(3)
    sensitivity[:, ATTITUDE] = -skew(swing)
    difference = state.velocity + swing - fixes.velocity[row]
    return Measurement(difference, sensitivity, np.full(3, fixes.velocity_sigma[row] ** 2))


def _compare_speed(fixes: Fixes, row: int, state: State) -> Measurement:
    forward = state.mat_nb[:, 0]
    sensitivity = np.zeros((1, COUNT))
    sensitivity[0, VELOCITY] = forward
    sensitivity[0, ATTITUDE] = forward @ skew(state.velocity)
    difference = np.array([forward @ state.velocity - fixes.speed[row]])
    return Measurement(difference, sensitivity, np.array([fixes.speed_sigma[row] ** 2]))
