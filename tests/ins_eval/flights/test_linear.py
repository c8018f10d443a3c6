"""The linear model beside flights: its 1-sigma holds them, its budget explains them."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from ins_eval.common.state import position_error
from ins_eval.flights import linear
from ins_eval.flights.assumed_errors import AssumedErrors, assume_errors
from ins_eval.flights.flight import Runs, Truth, fly_runs, sample_truth
from ins_eval.flights.plan import Plan, count_row_increments
from ins_eval.imu import specification
from ins_eval.imu.imu import Imu
from ins_eval.imu.stated_gyros import StatedGyros
from ins_eval.trajectories import catalogue
from tests.recordings import find_recording

RUNS, RATE, MINUTES = 120, 20, 20
PLAN = Plan(
    1 / RATE,
    MINUTES * 60 * RATE,
    count_row_increments(1 / RATE, 2),
    alignment=None,
    seed=7,
    runs=RUNS,
)


@pytest.fixture(scope="module")
def imu() -> Imu:
    """Simple, of constant errors and white noise alone."""
    found = specification.load_imu("simple")
    assert isinstance(found.gyros, StatedGyros)
    gyros = StatedGyros(replace(found.gyros.error_model, bias_instability=0.0))
    forces = replace(found.accelerometers, bias_instability=0.0, quantization_step=0.0)
    return replace(found, gyros=gyros, accelerometers=forces, interval=1 / RATE)


@pytest.fixture(scope="module")
def weaving() -> Truth:
    return sample_truth(PLAN, catalogue.load_trajectory("weaving", PLAN.duration))


@pytest.fixture(scope="module")
def flown(imu: Imu, weaving: Truth) -> Runs:
    return fly_runs(PLAN, weaving, imu)


def errors_at_the_end(flights: Runs, true: Truth) -> np.ndarray:
    """(runs, 2) m."""
    ends = np.array([track.position[-1] for track in flights.tracks])
    return position_error(ends, true.track.position[-1])[:, :2]


def explained(errors: np.ndarray, covariance: np.ndarray) -> bool:
    """Whether the sum of squared errors, in sigmas, is within its 99.9 % interval."""
    whole = np.einsum("ri,ij,rj->", errors, np.linalg.inv(covariance[:2, :2]), errors)
    low, high = chi2.interval(0.999, errors.size)
    return bool(low < whole < high)


def test_sigma_holds_flights(imu: Imu, weaving: Truth, flown: Runs) -> None:
    errors = errors_at_the_end(flown, weaving)
    covariance = linear.propagate_flight_covariance(PLAN, weaving, assume_errors(imu), None)
    assert len(covariance) == len(weaving.track)
    assert explained(errors, covariance[-1])


def test_without_what_acts_in_manoeuvres_it_does_not(imu: Imu, weaving: Truth, flown: Runs) -> None:
    whole = assume_errors(imu)
    of_biases = [number for number, e in enumerate(whole.effects) if e.name.endswith("bias")]
    less = AssumedErrors(
        tuple(whole.effects[number] for number in of_biases),
        whole.deviations[of_biases],
        whole.noise,
    )
    covariance = linear.propagate_flight_covariance(PLAN, weaving, less, None)
    assert not explained(errors_at_the_end(flown, weaving), covariance[-1])


def test_budget_sums_to_the_flight(imu: Imu, weaving: Truth, flown: Runs) -> None:
    budget = linear.compute_error_budget(PLAN, weaving, imu, flown.first)
    total = budget.shares["contribution"].sum(("effect", "axis", "time")).values
    error = errors_at_the_end(flown, weaving)[0]
    np.testing.assert_allclose(total, error, atol=0.01 * float(np.hypot(*error)))


def test_budget_counts_alignment_in(imu: Imu) -> None:
    plan = replace(PLAN, alignment=120.0, runs=1, height="baro")
    car = sample_truth(plan, catalogue.load_trajectory("car", plan.duration, 140.0))
    flights = fly_runs(plan, car, imu)
    shares = linear.compute_error_budget(plan, car, imu, flights.first).shares
    total = shares["contribution"].sum(("effect", "axis", "time")) + shares["initial"].sum("state")
    error = errors_at_the_end(flights, car)[0]
    np.testing.assert_allclose(total, error, atol=0.01 * float(np.hypot(*error)))
    assert float(np.abs(shares["initial"]).sum()) > 0


def test_budget_sums_to_a_recorded_drive(imu: Imu) -> None:
    """City traffic changes velocity and attitude from second to second; 0.3 % is left,
    0.9 % with steps of 1 s."""
    path = find_recording("turin_drive.csv.gz")
    plan = replace(PLAN, count=18 * 60 * RATE, alignment=280.0, runs=1)
    drive = sample_truth(plan, catalogue.load_trajectory(path, plan.duration, 300.0))
    flights = fly_runs(plan, drive, imu)
    shares = linear.compute_error_budget(plan, drive, imu, flights.first).shares
    total = shares["contribution"].sum(("effect", "axis", "time")) + shares["initial"].sum("state")
    error = errors_at_the_end(flights, drive)[0]
    np.testing.assert_allclose(total, error, atol=0.005 * float(np.hypot(*error)))


def test_sigma_starts_from_the_alignment(imu: Imu) -> None:
    plan = replace(PLAN, count=10 * RATE, keep_every=2, alignment=120.0, runs=1)
    car = sample_truth(plan, catalogue.load_trajectory("car", plan.duration, 140.0))
    alignment = fly_runs(plan, car, imu).first.alignment
    assert alignment
    covariance = linear.propagate_flight_covariance(plan, car, assume_errors(imu), alignment)
    np.testing.assert_allclose(
        np.sqrt(np.diag(covariance[0])[6:9]), np.sqrt(np.diag(alignment.covariance)), rtol=0.03
    )


@pytest.mark.parametrize(("rate", "samples"), [(100, 2), (100, 3), (100, 4), (10, 3), (2000, 4)])
def test_steps_fill_rows_and_flight(rate: int, samples: int) -> None:
    plan = Plan(1 / rate, 3600 * rate, count_row_increments(1 / rate, samples), samples=samples)
    grid = linear.choose_steps(plan)
    assert 0.5 <= grid.step / linear.STEP <= 1.5
    assert grid.row * grid.step == pytest.approx(plan.row_spacing)
    assert grid.flight * grid.step == pytest.approx(plan.duration)


def test_long_flights_take_longer_steps() -> None:
    plan = Plan(0.01, 24 * 360_000, count_row_increments(0.01, 2))
    assert linear.choose_steps(plan).flight <= linear.MOST_STEPS


def test_only_positive_variances_are_left() -> None:
    np.testing.assert_allclose(
        linear.clip_negative_eigenvalues(np.diag([2.0, -1.0, 0.0])), np.diag([2.0, 0, 0])
    )
