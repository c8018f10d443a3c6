"""Dead reckoning of a recorded log: align on its beginning, navigate to its end."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import xarray as xr

from ins_eval.alignment.align import align
from ins_eval.common.state import State, Track
from ins_eval.flights.assumed_errors import assume_errors
from ins_eval.flights.flight import hold_height
from ins_eval.flights.log_sigma import (
    choose_fine_rows,
    propagate_log_covariance,
    thin_track,
)
from ins_eval.flights.plan import Plan
from ins_eval.flights.report import Flight
from ins_eval.flights.truth import count_still_increments
from ins_eval.imu.imu import Imu
from ins_eval.navigation.strapdown import navigate
from ins_eval.results import flights
from pyhrg.common.arrays import Array
from pyhrg.records.imu.increments import Increments

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
