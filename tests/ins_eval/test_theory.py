"""The navigator's errors at rest against closed forms."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common import earth
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.state import State, Track, track_error
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from pyhrg.common.units import DEG_PER_H
from pyhrg.records.imu.log import Increments
from tests.ins_eval import theory

RATE = 10
"""Increments a second: enough at rest."""
EACH = 60
"""Time between rows, s."""
GYRO_BIAS, FORCE_BIAS = 1e-4 * DEG_PER_H, 1e-6
"""Small, so that the navigator is linear in them: at 0.01 deg/h it is not, to 0.4 % after 24 h."""


def make_biased_increments(
    latitude: float, yaw: float, hours: float, gyro: np.ndarray, force: np.ndarray
) -> Increments:
    """Increments of a level vehicle at rest; biases in body axes, rad/s and m/s^2."""
    to_body = mat_from_euler(*np.array([0.0, 0.0, yaw])).T
    rate = to_body @ (earth.RATE * np.array([np.cos(latitude), 0.0, -np.sin(latitude)])) + gyro
    felt = to_body @ np.array([0.0, 0.0, -earth.gravity(latitude, 0.0)]) + force
    count = round(hours * 3600 * RATE)
    return Increments(1 / RATE, np.tile(rate / RATE, (count, 1)), np.tile(felt / RATE, (count, 1)))


def errors(
    latitude: float,
    hours: float,
    start: np.ndarray | None = None,
    gyro: np.ndarray | None = None,
    force: np.ndarray | None = None,
) -> tuple[np.ndarray, np.ndarray]:
    """Times and (m, 7) errors of the navigator, in the order of `theory.STATES`."""
    start = np.zeros(theory.STATES) if start is None else start
    gyro, force = (np.zeros(3) if x is None else x for x in (gyro, force))
    turned = Rotation.from_rotvec(start[theory.ATTITUDE]).as_matrix()
    state = State(latitude, 0.0, 0.0, np.append(start[theory.VELOCITY], 0.0), turned)
    record = make_biased_increments(latitude, 0.0, hours, gyro, force)
    track = navigate(state, record, Clamped(np.zeros(len(record) + 1)), EACH * RATE)
    error = track_error(track, at_rest(track.time, latitude))
    return track.time, np.hstack([error.attitude, error.velocity[:, :2], error.position[:, :2]])


def at_rest(time: np.ndarray, latitude: float) -> Track:
    n = len(time)
    position = np.tile([latitude, 0.0, 0.0], (n, 1))
    return Track(time, position, np.zeros((n, 3)), np.tile(np.eye(3), (n, 1, 1)))


def unit(i: int, size: float = 1.0, n: int = 3) -> np.ndarray:
    return size * np.eye(n)[i]


def sizes(states: np.ndarray) -> np.ndarray:
    """Largest of each group of states, for errors relative to it."""
    groups = (theory.ATTITUDE, theory.VELOCITY, theory.POSITION)
    return np.concatenate([np.full(g.stop - g.start, np.max(np.abs(states[:, g]))) for g in groups])


@pytest.mark.parametrize("latitude_deg", [-60.0, 0.0, 34.0])
@pytest.mark.parametrize("axis", range(3), ids=["north", "east", "down"])
@pytest.mark.parametrize("sensor", ["gyro", "force"])
def test_single_bias_over_24_h(latitude_deg: float, axis: int, sensor: str) -> None:
    """Each state within 1e-4 of its group's largest; a down force bias does nothing."""
    latitude = np.deg2rad(latitude_deg)
    gyro = unit(axis, GYRO_BIAS) if sensor == "gyro" else np.zeros(3)
    force = unit(axis, FORCE_BIAS) if sensor == "force" else np.zeros(3)
    time, got = errors(latitude, 24.0, gyro=gyro, force=force)
    along = np.append(0.0, time)
    expected = theory.AtRest(latitude).errors(along, np.zeros(theory.STATES), gyro, force)[1:]
    if sensor == "force" and axis == 2:
        assert np.max(np.abs(got[:, theory.POSITION])) < 1e-5
    else:
        assert np.max(np.abs(got - expected) / sizes(expected)) < 1e-4


@pytest.mark.parametrize("state", range(5), ids=["roll", "pitch", "yaw", "north", "east"])
def test_initial_errors_over_24_h(state: int) -> None:
    latitude = np.deg2rad(45.0)
    start = unit(state, 1e-6 if state < 3 else 1e-3, theory.STATES)
    time, got = errors(latitude, 24.0, start)
    expected = theory.AtRest(latitude).errors(
        np.append(0.0, time), start, np.zeros(3), np.zeros(3)
    )[1:]
    assert np.max(np.abs(got - expected) / sizes(expected)) < 1e-5


def fit_frequencies(time: np.ndarray, values: np.ndarray, guesses: np.ndarray) -> np.ndarray:
    """Frequencies of sinusoids, a mean and a slope, by separable least squares."""

    def residual(frequencies: np.ndarray) -> np.ndarray:
        phases = np.outer(time, frequencies)
        columns = np.column_stack([np.cos(phases), np.sin(phases), np.ones_like(time), time])
        return values - columns @ np.linalg.lstsq(columns, values, rcond=None)[0]

    scale = np.max(np.abs(values))
    result = least_squares(
        lambda x: residual(x * guesses) / scale, np.ones(len(guesses)), xtol=1e-14, ftol=1e-14
    )
    return np.asarray(result.x * guesses)


@pytest.mark.parametrize("latitude_deg", [30.0, 45.0, -60.0])
def test_schuler_foucault_and_24_h_periods(latitude_deg: float) -> None:
    """Frequencies fitted to 48 h of an initial velocity error and a tilt; guesses 1 % off. The
    closed form is a sphere's: Earth's two radii leave 3e-5, and 1e-3 of their difference."""
    latitude = np.deg2rad(latitude_deg)
    start = unit(3, 0.01, theory.STATES) + unit(2, 1e-4, theory.STATES)
    time, got = errors(latitude, 48.0, start)
    expected = theory.free_frequencies(latitude)
    result = fit_frequencies(time, got[:, 3], np.array(expected) * [1.01, 0.99, 1.01])
    assert result == pytest.approx(np.array(expected), rel=1e-4)
    schuler_minutes = 2 * np.pi / theory.schuler_frequency(latitude) / 60
    schuler = 2 * np.pi / 60 / schuler_minutes
    assert np.sqrt(result[0] * result[1]) == pytest.approx(schuler, rel=1e-6)
    assert schuler_minutes == pytest.approx(84.4, abs=0.1)
    foucault = (result[0] - result[1]) / 2
    assert foucault == pytest.approx(earth.RATE * np.sin(abs(latitude)), rel=2e-3)


def test_modes_are_the_dynamics_own() -> None:
    """Closed-form frequencies against the eigenvalues of the textbook matrix."""
    latitude = np.deg2rad(50.0)
    values = np.linalg.eigvals(theory.AtRest(latitude).dynamics())
    modes = sorted(value.imag for value in values if value.imag > 1e-9)
    assert modes == pytest.approx(sorted(theory.free_frequencies(latitude)), rel=1e-4)


@pytest.mark.parametrize(
    ("axis", "formula", "column", "sign"),
    [
        (0, theory.drift_of_level_gyro, 6, 1),
        (1, theory.drift_of_level_gyro, 5, -1),
        (2, theory.drift_of_down_gyro, 5, -1),
    ],
    ids=["north", "east", "down"],
)
def test_single_axis_formulas_of_gyros(axis: int, formula, column: int, sign: int) -> None:  # type: ignore[no-untyped-def]
    """Limits of the full solution for 20 min, before the axes mix: 1 %."""
    latitude = np.deg2rad(34.0)
    time, got = errors(latitude, 1 / 3, gyro=unit(axis, GYRO_BIAS))
    assert got[:, column] == pytest.approx(
        sign * formula(GYRO_BIAS, time, latitude), rel=1e-2, abs=1e-5
    )


@pytest.mark.parametrize("axis", [0, 1], ids=["north", "east"])
def test_single_axis_formula_of_accelerometers(axis: int) -> None:
    latitude = np.deg2rad(34.0)
    time, got = errors(latitude, 1 / 3, force=unit(axis, FORCE_BIAS))
    expected = theory.drift_of_accelerometer(FORCE_BIAS, time, latitude)
    assert got[:, 5 + axis] == pytest.approx(expected, rel=1e-2)


def gyrocompassed_state(latitude: float, gyro: np.ndarray, force: np.ndarray) -> State:
    record = make_biased_increments(latitude, 0.0, 0.1, gyro, force)
    return State(latitude, 0.0, 0.0, np.zeros(3), level_and_gyrocompass(record, latitude))


def test_gyrocompassing_settles_where_theory_says() -> None:
    latitude = np.deg2rad(40.0)
    gyro, force = GYRO_BIAS * np.array([0.5, 1.0, -0.7]), FORCE_BIAS * np.array([1.0, -0.5, 0.3])
    aligned = gyrocompassed_state(latitude, gyro, force).mat_nb
    skew = 0.5 * (aligned - aligned.T)
    attitude = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
    expected = theory.gyrocompassing_error(gyro, force, latitude)
    assert attitude == pytest.approx(expected, rel=1e-3, abs=1e-9)


def test_east_bias_hides_after_gyrocompassing_and_comes_back_after_a_turn() -> None:
    """After alignment facing north it does next to nothing; turned by 180 deg at once, the gyro's
    bias points west while the heading error remains: twice the drift."""
    latitude = np.deg2rad(40.0)
    gyro = unit(1, GYRO_BIAS)
    state = gyrocompassed_state(latitude, gyro, np.zeros(3))
    half_turn = np.diag([-1.0, -1.0, 1.0])
    turned = State(latitude, 0.0, 0.0, np.zeros(3), state.mat_nb @ half_turn)
    drifts = []
    for start, yaw in ((state, 0.0), (turned, np.pi)):
        record = make_biased_increments(latitude, yaw, 1.0, gyro, np.zeros(3))
        track = navigate(start, record, Clamped(np.zeros(len(record) + 1)), len(record))
        position = track_error(track, at_rest(track.time, latitude)).position
        drifts.append(float(position[-1, 0]))
    attitude = theory.gyrocompassing_error(gyro, np.zeros(3), latitude)
    before = np.concatenate([attitude, np.zeros(4)])
    expected = theory.AtRest(latitude).errors(np.array([0, 3600.0]), before, -gyro, np.zeros(3))
    alone = theory.AtRest(latitude).errors(
        np.array([0, 3600.0]), np.zeros(theory.STATES), gyro, np.zeros(3)
    )
    assert abs(drifts[0]) < 0.05 * abs(alone[-1, 5])
    assert drifts[1] == pytest.approx(expected[-1, 5], rel=5e-3)
    assert drifts[1] == pytest.approx(-2 * alone[-1, 5], rel=5e-2)
