"""Dead reckoning of a recorded log: align on its beginning, navigate to its end. The linear model's
1-sigma follows the navigated path."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pandas as pd
import xarray as xr

from ins_eval.alignment.align import align
from ins_eval.alignment.result import Alignment
from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.state import State, Track
from ins_eval.error_model.error_budget import compute_sigma_budget, compute_weights
from ins_eval.error_model.linear_model import propagate_covariance
from ins_eval.flights.assumed_errors import AssumedErrors, assume_errors
from ins_eval.flights.flight import Truth, count_still_increments, hold_height
from ins_eval.flights.linear import STEP, choose_steps, prepare_flight_model
from ins_eval.flights.plan import Plan
from ins_eval.flights.report import Flight
from ins_eval.imu.imu import Imu
from ins_eval.navigation.strapdown import navigate
from ins_eval.results import flights
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

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


Reference = Callable[[Array], Track]
"""True states at times (m,), s; attitudes that nobody knows are NaN."""

LOG_TRAJECTORY = "dead reckoning"
"""Name in place of the trajectory of a log."""


def stand_still(position: Array) -> Reference:
    """Truth of a vehicle that stood there all the time, whatever way it faced."""

    def track(time: Array) -> Track:
        rows = len(time)
        unknown = np.full((rows, 3, 3), np.nan)
        return Track(time, np.tile(position, (rows, 1)), np.zeros((rows, 3)), unknown)

    return track


def navigate_log(
    plan: Plan,
    name: str,
    log: Increments,
    position: Array,
    imu: Imu,
    reference: Reference | None,
) -> Flight:
    """Align on a log's beginning, and navigate.

    position: (3,) at its beginning: latitude, longitude, rad, height, m; imu: that whose errors are
    assumed; reference: the truth, if there is one; it holds the height too.
    """
    _, zero = count_still_increments(plan.alignment, plan.interval, warm_up=0.0)
    log = replace(log, start=-zero * log.interval)
    alignment = align(log.between(0, zero), position, imu.errors)
    measured = log.between(zero, zero + plan.count)
    start = State.at_rest(position, alignment.mat_nb)
    heights = np.full(plan.count + 1, start.height)
    if reference:
        heights = reference(measured.bounds).position[:, 2]
    fine = choose_fine_rows(plan)
    way = navigate(start, measured, hold_height(plan, heights), fine, plan.samples)
    track = thin_track(way, plan.keep_every // fine)
    dataset = flights.tabulate_navigated([track])
    if reference:
        dataset = flights.compare_with_truth([track], reference(track.time))
    sigma, budget = propagate_log_covariance(
        plan, measured, start, way, heights, assume_errors(imu), alignment
    )
    dataset = xr.merge([dataset, flights.tabulate_sigmas(track.time, sigma)])
    place = np.asarray(position)
    return Flight(plan, LOG_TRAJECTORY, name, place, [alignment], dataset, sigma_budget=budget)
