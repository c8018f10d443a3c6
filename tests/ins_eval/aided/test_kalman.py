"""Filter and smoother against the posterior of all fixes at once, and sensitivities against
differences."""

from collections.abc import Iterator

import numpy as np
import pytest

from ins_eval.aided.fixes import Fixes
from ins_eval.aided.kalman.backward import Adjoint
from ins_eval.aided.kalman.forward import Filter, Step, correct_state
from ins_eval.aided.kalman.measurements import Measurement, compare_fix
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.state import State
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.effects import accelerometer_bias, gyro_bias

STEP, STEPS = 0.5, 6
SENSORS = SensorStates(
    (gyro_bias(), accelerometer_bias(3.0)),
    np.array([[1.0, 2.0, 0.5], [0.7, 0.3, 1.0]]),
    np.array([[0.2, 0.1, 0.0], [0.0, 0.0, 0.0]]),
    np.zeros(6),
)
SIZE = COUNT + len(SENSORS)


def test_smoother_has_the_posterior_of_all_fixes() -> None:
    """Start and driving noise are the unknowns of a dense least-squares problem."""
    generator = np.random.default_rng(3)
    start = np.diag(generator.uniform(0.5, 2.0, COUNT))
    kalman = Filter(SENSORS, start, STEP)
    kept = [(kalman.mean.copy(), kalman.covariance.copy())]
    prior = kalman.covariance.copy()
    rows, values = [], []
    carried = np.eye(SIZE, SIZE * (1 + STEPS))
    noises, steps = [prior], []
    for k in range(STEPS):
        transition = np.eye(COUNT) + generator.normal(0, 0.2, (COUNT, COUNT))
        inputs, root = generator.normal(size=(COUNT, len(SENSORS))), generator.normal(size=(10, 3))
        kalman.predict(transition, inputs, root @ root.T)
        whole = np.zeros((SIZE, SIZE))
        whole[:COUNT, :COUNT], whole[:COUNT, COUNT:] = transition, inputs
        own = np.arange(COUNT, SIZE)
        whole[own, own] = SENSORS.list_persistence(STEP)
        driving = np.zeros((SIZE, SIZE))
        driving[:COUNT, :COUNT] = root @ root.T
        driving[own, own] = SENSORS.list_driving_variance(STEP)
        noises.append(driving)
        carried = whole @ carried
        carried[:, SIZE * (k + 1) : SIZE * (k + 2)] += np.eye(SIZE)
        measured = Measurement(
            generator.normal(size=3), generator.normal(size=(3, COUNT)), np.full(3, 0.3)
        )
        rows.append(measured.sensitivity @ carried[:COUNT] / np.sqrt(0.3))
        values.append(measured.difference / np.sqrt(0.3))
        update = kalman.update(measured, np.inf)
        assert update is not None
        steps.append(Step(transition, inputs, [update]))
        kept.append((kalman.mean.copy(), kalman.covariance.copy()))

    sensitivity, every = np.vstack(rows), np.concatenate(values)
    before = np.zeros((SIZE * (1 + STEPS),) * 2)
    for k, noise in enumerate(noises):
        before[SIZE * k : SIZE * (k + 1), SIZE * k : SIZE * (k + 1)] = noise
    gain = before @ sensitivity.T
    gain = gain @ np.linalg.inv(sensitivity @ before @ sensitivity.T + np.eye(len(every)))
    mean, after = gain @ every, before - gain @ sensitivity @ before

    np.testing.assert_allclose(kalman.mean, carried @ mean, atol=1e-9)
    np.testing.assert_allclose(kalman.covariance, carried @ after @ carried.T, atol=1e-9)
    adjoint = Adjoint(SIZE, SENSORS.list_persistence(STEP))
    for step in reversed(steps):
        adjoint.go_back(step)
    found, covariance = kept[0]
    smoothed = found - covariance @ adjoint.gradient
    np.testing.assert_allclose(smoothed, mean[:SIZE], atol=1e-8)
    left = covariance - covariance @ adjoint.information @ covariance
    np.testing.assert_allclose(left, after[:SIZE, :SIZE], atol=1e-8)


def test_measurements_before_a_drive_condition_the_states() -> None:
    """Twice in turn, against the information form of both at once."""
    generator = np.random.default_rng(5)
    response, values = generator.normal(size=(4, len(SENSORS))), generator.normal(size=4)
    variances = generator.uniform(0.1, 2.0, 4)
    found = SENSORS
    for rows in (slice(0, 3), slice(3, 4)):
        found = found.condition(response[rows], values[rows], variances[rows])
    information = np.linalg.inv(SENSORS.covariance) + response.T / variances @ response
    np.testing.assert_allclose(found.covariance, np.linalg.inv(information), atol=1e-12)
    expected = np.linalg.solve(information, response.T / variances @ values)
    np.testing.assert_allclose(found.mean, expected, atol=1e-12)
    np.testing.assert_array_equal(Filter(found, np.eye(COUNT), STEP).mean[COUNT:], found.mean)


def test_an_improbable_fix_is_left_out() -> None:
    kalman = Filter(SENSORS, np.eye(COUNT), STEP)
    far = Measurement(np.full(3, 100.0), np.eye(3, COUNT), np.ones(3))
    before = kalman.covariance.copy()
    assert kalman.update(far, 30.0) is None
    np.testing.assert_array_equal(kalman.covariance, before)


TRUE = State(
    0.8, 0.2, 300.0, np.array([12.0, -7.0, 0.5]), mat_from_euler(0.1, -0.05, np.array(2.0))
)
RATE, LEVER_ARM = np.array([0.1, -0.2, 0.3]), np.array([1.0, -0.5, 2.0])


def compare(state: State) -> Iterator[Measurement]:
    one = np.ones(1)
    fixes = Fixes(one, TRUE.position[None], np.ones((1, 3)), TRUE.velocity[None], one, one, one)
    return compare_fix(fixes, 0, state, RATE, 0.0, LEVER_ARM)


@pytest.mark.parametrize("error", range(9))
def test_sensitivities_are_derivatives(error: int) -> None:
    """A state with a small error, against its derivative: second order is left."""
    size = 1e-4 if error >= 6 else 1e-3
    errors = np.zeros(COUNT)
    errors[error] = -size
    wrong = correct_state(TRUE, errors)
    for at_truth, measured in zip(compare(TRUE), compare(wrong), strict=True):
        moved = (measured.difference - at_truth.difference) / size
        np.testing.assert_allclose(moved, at_truth.sensitivity[:, error], atol=2e-3)
