"""The linear model beside a recorded log: its 1-sigma along the way that was navigated."""

import numpy as np
import pandas as pd

from ins_eval.alignment.result import Alignment
from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.state import State, Track
from ins_eval.error_model.budget.adjoint import compute_weights
from ins_eval.error_model.budget.sigma_budget import compute_sigma_budget
from ins_eval.error_model.linear_model import propagate_covariance
from ins_eval.flights.assumed_errors import AssumedErrors
from ins_eval.flights.linear import STEP, choose_steps, prepare_flight_model
from ins_eval.flights.plan import Plan
from ins_eval.flights.truth import Truth
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.records.imu.increments import Increments

END_MARGIN = 4
"""Knots by which the way outlasts the flight, so that the last step lies within it."""


def choose_fine_rows(plan: Plan) -> int:
    """Increments between the states of the way: whole steps that fill the rows, about `STEP`."""
    fitting = [n for n in range(plan.samples, plan.keep_every + 1) if plan.keep_every % n == 0]
    fitting = [n for n in fitting if n % plan.samples == 0]
    return min(fitting, key=lambda n: abs(n * plan.interval - STEP))


def thin_track(track: Track, every: int) -> Track:
    """Every n-th state of a track."""
    rows = slice(every - 1, None, every)
    return Track(track.time[rows], track.position[rows], track.velocity[rows], track.mat_nb[rows])


def propagate_log_covariance(
    plan: Plan,
    log: Increments,
    start: State,
    way: Track,
    heights: Array,
    assumed: AssumedErrors,
    alignment: Alignment,
) -> tuple[Array, pd.DataFrame]:
    """Covariance of the errors at the plan's rows (m, 10, 10), and the budget of the last one's
    position (`compute_sigma_budget`).

    way: the navigated states, `choose_fine_rows` apart; heights: as the navigator's height is held.
    """
    trajectory = _trace(plan, start, way)
    truth = Truth(trajectory, log, 0, 0, start, way, heights)
    model, initial = prepare_flight_model(plan, truth, assumed, alignment)
    every = propagate_covariance(model, initial, assumed.deviations)
    grid = choose_steps(plan)
    budget = compute_sigma_budget(compute_weights(model), initial, assumed.deviations)
    return every[grid.alignment + grid.row :: grid.row], budget


def _trace(plan: Plan, start: State, way: Track) -> Trajectory:
    """A trajectory through the navigated states, at rest before time 0 and steady after the end."""
    spacing = way.time[0]
    before = -spacing * np.arange(np.ceil((plan.alignment or 0.0) / spacing) + END_MARGIN, -1, -1)
    attitudes = np.concatenate([start.mat_nb[None], way.mat_nb])
    euler = np.stack(euler_from_mat(attitudes), axis=-1)
    moving = np.concatenate([[start.position], way.position])
    channels = np.hstack([moving, np.unwrap(euler, axis=0)])
    after = channels[-1] + np.arange(1, END_MARGIN + 1)[:, None] * (channels[-1] - channels[-2])
    rows = np.concatenate([np.tile(channels[0], (len(before) - 1, 1)), channels, after])
    later = way.time[-1] + spacing * np.arange(1, END_MARGIN + 1)
    return Trajectory("log", np.concatenate([before, way.time, later]), rows)
