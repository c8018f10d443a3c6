"""Flights of a simulated IMU with everything that is said of them."""

from collections.abc import Callable

import xarray as xr

from ins_eval.flights.beliefs import beliefs
from ins_eval.flights.flight import fly
from ins_eval.flights.flown import Flown
from ins_eval.flights.linear import covariance, error_budget
from ins_eval.flights.plan import Plan
from ins_eval.flights.truth import truth
from ins_eval.imu.imu import Imu
from ins_eval.results import flights
from ins_eval.trajectories.trajectory import Trajectory


def experiment(
    plan: Plan, trajectory: Trajectory, imu: Imu, done: Callable[[], object] = lambda: None
) -> Flown:
    """Fly; add errors, the navigator's own, the linear model's 1-sigma, and the budget of run 1.

    Args:
        plan: how to fly.
        trajectory: that covers it.
        imu: with increments at the plan's interval.
        done: called after each of `plan.runs` + 1 flights.

    Raises:
        AlignmentError: what was measured can't be aligned on.
        NavigationError: the navigator can't start or go on.
    """
    true = truth(plan, trajectory)
    flown = fly(plan, true, imu, done)
    sigma = covariance(plan, true, beliefs(imu), flown.first.alignment)
    dataset = xr.merge(
        [
            flights.against(flown.tracks, true.track),
            flights.sigmas(true.track.time, sigma),
            flights.own_error(flown.own, true.track),
        ]
    )
    budget = error_budget(plan, true, imu, flown.first)
    return Flown(
        plan, trajectory.name, f"{imu.name} IMU", true.position, flown.alignments, dataset, budget
    )
