"""Recorded logs have a 1-sigma that holds their errors, and a budget that adds up to it."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from ins_eval.flights import linear
from ins_eval.flights.assumed_errors import assume_errors
from ins_eval.flights.flight import sample_truth
from ins_eval.flights.log_flight import navigate_log
from ins_eval.flights.plan import Plan
from ins_eval.flights.report import Flight
from ins_eval.imu.imu import Imu
from ins_eval.imu.specification import load_imu
from ins_eval.trajectories.catalogue import load_trajectory

LOGS, RATE = 10, 20
PLAN = Plan(1 / RATE, 600 * RATE, 200, alignment=200.0)


@pytest.fixture(scope="module")
def imu() -> Imu:
    return replace(load_imu("simple"), interval=PLAN.interval)


@pytest.fixture(scope="module")
def logs(imu: Imu) -> list[Flight]:
    """10 cars recorded with the truth, seeds 0 to 9."""
    car = load_trajectory("car", PLAN.duration, 200.0)
    ideal = car.increments(-200.0, PLAN.interval, 200 * RATE + PLAN.count)
    position = car.position(np.array(0.0))
    return [
        navigate_log(PLAN, "log", imu.measure(ideal, seed).increments, position, imu, car.track)
        for seed in range(LOGS)
    ]


def test_one_sigma_holds(logs: list[Flight]) -> None:
    """Squared errors of position over 10 logs in chi-square's 99.9 % interval."""
    whole = 0.0
    for log in logs:
        last = log.dataset.isel(time=-1, run=0)
        error = np.array([last["north_error"], last["east_error"]])
        cross = float(last["north_east_covariance"])
        sigma = np.diag([float(last["north_sigma"]) ** 2, float(last["east_sigma"]) ** 2])
        covariance = sigma + cross * (1 - np.eye(2))
        whole += float(error @ np.linalg.solve(covariance, error))
    low, high = chi2.interval(0.999, 2 * LOGS)
    assert low < whole < high


def test_one_sigma_is_that_of_the_true_way(logs: list[Flight], imu: Imu) -> None:
    """Along the navigated way instead of the true one: within 2 %."""
    truth = sample_truth(PLAN, load_trajectory("car", PLAN.duration, 220.0))
    alignment = logs[0].alignments[0]
    covariance = linear.propagate_flight_covariance(PLAN, truth, assume_errors(imu), alignment)
    found = logs[0].dataset["north_sigma"].values, logs[0].dataset["east_sigma"].values
    assert found[0][-1] == pytest.approx(np.sqrt(covariance[-1, 0, 0]), rel=0.02)
    assert found[1][-1] == pytest.approx(np.sqrt(covariance[-1, 1, 1]), rel=0.02)


def test_budget_adds_up_to_the_one_sigma(logs: list[Flight]) -> None:
    """Constants, processes, walks and alignment, in squares, to 1e-6."""
    log = logs[0]
    assert log.sigma_budget is not None
    total = np.sqrt(np.square(log.sigma_budget[["north_sigma_m", "east_sigma_m"]]).sum())
    last = log.dataset.isel(time=-1)
    assert total["north_sigma_m"] == pytest.approx(float(last["north_sigma"]), rel=1e-6)
    assert total["east_sigma_m"] == pytest.approx(float(last["east_sigma"]), rel=1e-6)
    effects = set(log.sigma_budget["effect"])
    assert {"gyro bias", "gyro bias instability", "random walks"} <= effects
