"""The linear error model beside a flight: its 1-sigma, and the causes of the final error."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
import xarray as xr
from scipy.spatial.transform import Rotation

from ins_eval.alignment.result import Alignment
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.decomposition import (
    decompose_errors,
    sensor_error,
    sum_over_steps,
)
from ins_eval.error_model.dynamics import ATTITUDE, COUNT
from ins_eval.error_model.effects import Effect
from ins_eval.error_model.error_budget import INITIAL, Weights, compute_budget, compute_weights
from ins_eval.error_model.linear_model import (
    LinearModel,
    join_models,
    linearize,
    model_alignment,
    propagate_covariance,
)
from ins_eval.error_model.motion import Motion, sample_motion, step_mean
from ins_eval.flights.assumed_errors import AssumedErrors, assume_errors
from ins_eval.flights.flight import Run, Truth, hold_height
from ins_eval.flights.gyro_causes import replay_causes
from ins_eval.flights.plan import Plan
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

COLUMNS = ("effect", "axis", "north_contribution_m", "east_contribution_m")


@dataclass(frozen=True)
class Budget:
    """Error budget of run 1.

    Attributes:
        shares: contributions to the final error (`error_model.error_budget`).
        weights: adjoint weights that give the contributions.
    """

    shares: xr.Dataset
    weights: Weights

    @property
    def table(self) -> pd.DataFrame:
        """Contributions by effect and axis, which sum to the linear model's error; zeros left
        out."""
        contribution = self.shares["contribution"].sum("time")
        rows = [
            (str(effect), str(axis), *map(float, contribution.sel(effect=effect, axis=axis)))
            for effect in contribution["effect"].values
            for axis in contribution["axis"].values
        ]
        rows.append((INITIAL, "", *map(float, self.shares["initial"].sum("state").values)))
        return pd.DataFrame([row for row in rows if any(row[2:])], columns=list(COLUMNS))


STEP = 0.5
"""Step of the linear model that is aimed at, s. Tuned on city traffic recorded at 1 Hz: steps of
1 s leave out 3 % of the final error, these 1 %."""
DEFLECTION = "deflection of the vertical"
"""Name in a budget of what the truth's deflection does to a navigator that doesn't know it."""
MOST_STEPS = 20_000
"""Number of steps beyond which a flight takes longer steps."""


@dataclass(frozen=True)
class Steps:
    """Grid of the linear model.

    Attributes:
        step: length of a step, s.
        alignment, flight, row: number of steps in the alignment, in the flight and between rows.
    """

    step: float
    alignment: int
    flight: int
    row: int


def choose_steps(plan: Plan) -> Steps:
    """Whole increments that fill the rows, about `STEP`; alignment's are rounded."""
    wanted = max(STEP, plan.duration / MOST_STEPS) / plan.interval
    fitting = [n for n in range(1, plan.keep_every + 1) if plan.keep_every % n == 0]
    each = min(fitting, key=lambda n: abs(n - wanted))
    step = each * plan.interval
    alignment = 0 if plan.alignment is None else round(plan.alignment / step)
    return Steps(step, alignment, plan.count // each, plan.keep_every // each)


def propagate_flight_covariance(
    plan: Plan, truth: Truth, assumed: AssumedErrors, alignment: Alignment | None
) -> Array:
    """Covariance of the flight's errors at the kept times, (m, 10, 10); what an alignment's holds
    beyond its sensors' constant errors counts as an error of its own."""
    grid = choose_steps(plan)
    model, initial = prepare_flight_model(plan, truth, assumed, alignment)
    every = propagate_covariance(model, initial, assumed.deviations)
    return every[grid.alignment + grid.row :: grid.row]


def prepare_flight_model(
    plan: Plan, truth: Truth, assumed: AssumedErrors, alignment: Alignment | None
) -> tuple[LinearModel, Array]:
    """Linear model of a flight, an alignment before it, and the covariance (10, 10) at its
    beginning."""
    initial = np.zeros((COUNT, COUNT))
    model = _flight(plan, truth, assumed.effects, assumed.noise)
    if alignment:
        before = _alignment(plan, truth, assumed.effects)
        every = propagate_covariance(before, initial, assumed.deviations)
        explained = every[-1][ATTITUDE, ATTITUDE]
        initial[ATTITUDE, ATTITUDE] = clip_negative_eigenvalues(alignment.covariance - explained)
        model = join_models(before, model)
    return model, initial


def compute_error_budget(plan: Plan, truth: Truth, imu: Imu, run: Run) -> Budget:
    """Contributions to the final error of a flight whose sensors' errors are known; what the
    alignment's error holds beyond their mean counts as initial error.

    Errors of gyros of a device are split by its keys, all others by the effects of the linear
    model.
    """
    grid = choose_steps(plan)
    error = sensor_error(run.measured.increments, truth.increments)
    motion = _motion(plan, truth, -grid.alignment, grid.alignment + grid.flight)
    deflected = _deflection_error(motion, truth.trajectory.deflection)
    model = _flight(plan, truth, (), SensorErrors())
    initial = np.zeros(COUNT)
    if run.alignment:
        before = _alignment(plan, truth, ())
        turned = Rotation.from_matrix(run.alignment.mat_nb @ truth.start.mat_nb.T)
        initial[ATTITUDE] = turned.as_rotvec() - _explain_attitude_error(before, error)
        initial[ATTITUDE] -= _explain_attitude_error(before, deflected)
        model = join_models(before, model)
    weights = compute_weights(model)
    signals = _split_errors(imu, truth, run.seed, error, motion)
    if any(truth.trajectory.deflection):
        signals[DEFLECTION] = deflected
    return Budget(compute_budget(weights, signals, initial), weights)


def _split_errors(
    imu: Imu, truth: Truth, seed: int, error: Increments, motion: Motion
) -> dict[str, Increments]:
    """Signals by cause, which sum to the error; those of the run's gyros from their devices."""
    assumed = assume_errors(imu).constant
    if not isinstance(imu.gyros, FmuGyros):
        return decompose_errors(error, motion, assumed.effects, assumed.deviations, assumed.noise)
    known = replay_causes(imu, imu.gyros, truth.increments, seed, motion.start, motion.step)
    grid = motion.start, motion.step, len(motion)
    rest = sum_over_steps(error, *grid)
    for signal in known.values():
        rest = sensor_error(rest, sum_over_steps(signal, *grid))
    assumed = assumed.without_gyros
    parts = decompose_errors(rest, motion, assumed.effects, assumed.deviations, assumed.noise)
    return {**known, **parts}


def _deflection_error(motion: Motion, deflection: tuple[float, float]) -> Increments:
    """Errors of the accelerometers that would do as a deflection does that the navigator lacks."""
    lean = np.array([*deflection, 0.0])
    force_n = earth.gravity(motion.latitude, motion.height)[:, None] * lean
    force = step_mean(np.einsum("nij,ni->nj", motion.mat_nb, force_n))
    return Increments(motion.step, np.zeros_like(force), motion.step * force, motion.start)


def _explain_attitude_error(model: LinearModel, error: Increments) -> Array:
    """(3,) attitude error that sensors' errors leave an averaging alignment with, rad."""
    mean = sum_over_steps(error, model.time[0], model.step, len(model))
    rates = np.concatenate([mean.rotation, mean.velocity], axis=1) / model.step
    return np.asarray(np.einsum("nij,nj->i", model.constant_errors[:, ATTITUDE], rates))


def _flight(
    plan: Plan, truth: Truth, effects: Sequence[Effect], noise: SensorErrors
) -> LinearModel:
    motion = _motion(plan, truth, 0, choose_steps(plan).flight)
    return linearize(motion, hold_height(plan, truth.heights), effects, noise)


def _alignment(plan: Plan, truth: Truth, effects: Sequence[Effect]) -> LinearModel:
    before = choose_steps(plan).alignment
    return model_alignment(_motion(plan, truth, -before, before), effects)


def _motion(plan: Plan, truth: Truth, first: int, count: int) -> Motion:
    step = choose_steps(plan).step
    return sample_motion(truth.trajectory, first * step, step, count)


def clip_negative_eigenvalues(symmetric: Array) -> Array:
    values, vectors = np.linalg.eigh(0.5 * (symmetric + symmetric.T))
    return np.asarray((vectors * np.maximum(values, 0.0)) @ vectors.T)
