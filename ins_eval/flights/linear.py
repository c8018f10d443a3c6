"""The linear error model beside a flight: its 1-sigma, and whose the final error is."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval.alignment.result import Alignment
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.aligning import alignment_model
from ins_eval.error_model.budget.adjoint import weights
from ins_eval.error_model.budget.budget import budget
from ins_eval.error_model.budget.decomposition import Prior, decomposed, sensor_error, summed
from ins_eval.error_model.effects import Effect
from ins_eval.error_model.linear_model import (
    LinearModel,
    joined,
    linear_model,
    propagated_covariance,
)
from ins_eval.error_model.motion import Motion, along
from ins_eval.error_model.states import ATTITUDE, COUNT
from ins_eval.flights.beliefs import Beliefs, beliefs
from ins_eval.flights.flight import Run, held
from ins_eval.flights.flown import Budget
from ins_eval.flights.plan import Plan
from ins_eval.flights.truth import Truth
from ins_eval.imu.imu import Imu, Measured

Array = NDArray[np.float64]

STEP = 0.5
"""Of the linear model, s, about: through city traffic recorded at 1 Hz, steps of 1 s leave out 3 %
of the final error, these 1 %."""
MOST_STEPS = 20_000
"""Longer flights take longer steps."""


@dataclass(frozen=True)
class Steps:
    """Of the linear model: s; how many are the alignment's, the flight's, and between rows."""

    step: float
    alignment: int
    flight: int
    row: int


def steps(plan: Plan) -> Steps:
    """Whole increments that fill the rows, about `STEP`; alignment's are rounded."""
    wanted = max(STEP, plan.duration / MOST_STEPS) / plan.interval
    fitting = [n for n in range(1, plan.keep_every + 1) if plan.keep_every % n == 0]
    each = min(fitting, key=lambda n: abs(n - wanted))
    step = each * plan.interval
    alignment = 0 if plan.alignment is None else round(plan.alignment / step)
    return Steps(step, alignment, plan.count // each, plan.keep_every // each)


def covariance(plan: Plan, truth: Truth, believed: Beliefs, alignment: Alignment | None) -> Array:
    """Of the flight's errors at the kept times, (m, 10, 10).

    What an alignment's covariance holds beyond its sensors' constant errors counts as an error of
    its own.
    """
    grid, deviations = steps(plan), believed.deviations
    initial = np.zeros((COUNT, COUNT))
    model = _flight(plan, truth, believed.effects, believed.noise)
    if alignment:
        before = _alignment(plan, truth, believed.effects)
        explained = propagated_covariance(before, initial, deviations)[-1][ATTITUDE, ATTITUDE]
        initial[ATTITUDE, ATTITUDE] = positive(alignment.covariance - explained)
        model = joined(before, model)
    every = propagated_covariance(model, initial, deviations)
    return every[grid.alignment + grid.row :: grid.row]


def error_budget(plan: Plan, truth: Truth, imu: Imu, run: Run) -> Budget:
    """Contributions to the final error of a flight whose sensors' errors are known.

    What the alignment's attitude error holds beyond the mean of the sensors' errors counts as
    initial error.
    """
    grid = steps(plan)
    error = sensor_error(run.measured.increments, truth.increments)
    model = _flight(plan, truth, (), SensorErrors())
    initial = np.zeros(COUNT)
    if run.alignment:
        before = _alignment(plan, truth, ())
        initial[ATTITUDE] = attitude_error(run.alignment.mat_nb, truth.start.mat_nb)
        initial[ATTITUDE] -= _explained(before, error)
        model = joined(before, model)
    motion = _motion(plan, truth, -grid.alignment, grid.alignment + grid.flight)
    believed = beliefs(imu, _first_angle(imu, run.measured, motion.start)).constant
    prior = Prior(believed.deviations, believed.noise)
    found = weights(model)
    return Budget(budget(found, decomposed(error, motion, believed.effects, prior), initial), found)


def _first_angle(imu: Imu, measured: Measured, start: float) -> Array | None:
    """(3,) pattern angles when a motion starts, of gyros along the body axes that have them."""
    if measured.pattern_angle is None or not np.allclose(imu.mounting.axes, np.eye(3)):
        return None
    before = round((start - measured.increments.start) / measured.increments.interval) - 1
    return np.asarray(measured.pattern_angle[max(before, 0)])


def attitude_error(mat_nb: Array, true: Array) -> Array:
    """(3,) rotation vector about north, east, down from the true attitude to another, rad."""
    return np.asarray(Rotation.from_matrix(mat_nb @ true.T).as_rotvec())


def _explained(model: LinearModel, error: Increments) -> Array:
    """(3,) attitude error that sensors' errors leave an averaging alignment with, rad."""
    mean = summed(error, model.time[0], model.step, len(model))
    rates = np.concatenate([mean.rotation, mean.velocity], axis=1) / model.step
    return np.asarray(np.einsum("nij,nj->i", model.constant_errors[:, ATTITUDE], rates))


def _flight(
    plan: Plan, truth: Truth, effects: Sequence[Effect], noise: SensorErrors
) -> LinearModel:
    motion = _motion(plan, truth, 0, steps(plan).flight)
    return linear_model(motion, held(plan, truth.heights), effects, noise)


def _alignment(plan: Plan, truth: Truth, effects: Sequence[Effect]) -> LinearModel:
    before = steps(plan).alignment
    return alignment_model(_motion(plan, truth, -before, before), effects)


def _motion(plan: Plan, truth: Truth, first: int, count: int) -> Motion:
    step = steps(plan).step
    return along(truth.trajectory, first * step, step, count)


def positive(symmetric: Array) -> Array:
    """The same without its negative eigenvalues."""
    values, vectors = np.linalg.eigh(0.5 * (symmetric + symmetric.T))
    return np.asarray((vectors * np.maximum(values, 0.0)) @ vectors.T)
