"""The linear model against the nonlinear navigator, and over steps of any length."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.dynamics import COUNT, dynamics, sensor_inputs
from ins_eval.error_model.effects import (
    BIASES,
    Effect,
    accelerometer_bias,
    accelerometer_scale_factor,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
    pick_off_map,
)
from ins_eval.error_model.linear_model import (
    join_models,
    linearize,
    propagate_covariance,
)
from ins_eval.error_model.motion import Motion, sample_motion
from ins_eval.navigation.height import BaroDamped, Clamped, Free, Height
from ins_eval.trajectories.catalogue import load_trajectory
from tests.ins_eval.error_model.cases import Flight, propagate, weave

HOUR = 3600.0
FIRST_ANGLE = np.array([0.1, 0.7, 1.3])
CLAMPED = Clamped(np.zeros(1))

START_SIZES = (10.0, 10.0, 10.0, 0.01, 0.01, 0.01, 1e-5, 1e-5, 1e-5)
EFFECTS: tuple[tuple[Effect, float], ...] = (
    (gyro_bias(), 5e-9),
    (accelerometer_bias(), 1e-4),
    (gyro_scale_factor(), 1e-6),
    (accelerometer_scale_factor(), 1e-5),
    (bias_map(2, FIRST_ANGLE)[0], 5e-8),
    *((effect, 5e-8) for effect in bias_map(4, FIRST_ANGLE)),
    (bias_map(8, FIRST_ANGLE)[1], 5e-8),
    *((effect, 1e-6) for effect in pick_off_map(4, FIRST_ANGLE)),
)


@pytest.fixture(scope="module", params=["weave", "high latitude", "rolls", "car"])
def flight(request: pytest.FixtureRequest) -> Flight:
    flown = {
        "weave": lambda: weave(45, HOUR),
        "high latitude": lambda: weave(75, HOUR),
        "rolls": lambda: weave(45, HOUR, roll_every=600),
        "car": lambda: load_trajectory("car", HOUR + 10, 20.0),
    }[request.param]()
    return Flight.of(flown, HOUR, interval=0.04)


def odd_part(flight: Flight, height: Height, start: np.ndarray, sensors: np.ndarray) -> np.ndarray:
    """Half the difference of the navigator's errors for errors of both signs: no second order."""
    forward = flight.flown(height, start, sensors)
    return 0.5 * (forward - flight.flown(_mirrored(height, flight), -start, -sensors))


def _mirrored(height: Height, flight: Flight) -> Height:
    if isinstance(height, Clamped):
        return Clamped(2 * flight.heights - height.heights)
    return height


def horizontal_difference(result: np.ndarray, expected: np.ndarray) -> float:
    difference = np.linalg.norm((result - expected)[:, :2])
    return float(difference / np.linalg.norm(expected[:, :2]))


@pytest.mark.parametrize("kind", ["clamped", "damped"])
def test_initial_errors_are_the_navigators(flight: Flight, kind: str) -> None:
    """Each to 5e-5 of the horizontal error that it leads to. A clamped height's error is its
    reference's, and a clamped velocity has none. What a damped height's errors pass on, 2 mm and
    0.2 m, is to 2e-3 and 2e-4: the navigator's loop is of first order in its step there, which
    the test of the damped height shows."""
    damped = kind == "damped"
    height = BaroDamped(flight.heights) if damped else Clamped(flight.heights)
    model = linearize(sample_motion(flight.trajectory, 0.0, 1.0, 3600), height)
    for state, size in enumerate(START_SIZES):
        if state == 5 and not damped:
            continue
        start = np.zeros(COUNT)
        start[state] = size
        linear = propagate(model, start, np.zeros((2, 3)))[60::60, :9]
        own = Clamped(flight.heights - size) if state == 2 and not damped else height
        flown = odd_part(flight, own, start[:9], np.zeros((1, 6)))
        bound = {2: 2e-4, 5: 2e-3}.get(state, 5e-5) if damped else 5e-5
        assert horizontal_difference(flown, linear) < bound, state


def test_effects_of_the_sensors_are_the_navigators(flight: Flight) -> None:
    """Each effect on each axis to 1e-4 of the horizontal error that it leads to; rolls at 68 deg/s
    need steps of 0.5 s."""
    effects = tuple(effect for effect, _ in EFFECTS)
    height = Clamped(flight.heights)
    model = linearize(sample_motion(flight.trajectory, 0.0, 0.5, 7200), height, effects)
    middle = sample_motion(flight.trajectory, 0.0, 0.08, round(HOUR / 0.08))
    for number, (effect, size) in enumerate(EFFECTS):
        signal = size * effect.regressor(middle)[1::2]
        for axis in range(3):
            coefficients = np.zeros((len(effects), 3))
            coefficients[number, axis] = size
            sensors = np.zeros((len(signal), 6))
            sensors[:, axis + 3 * (effect.sensor == "accelerometer")] = signal[:, axis]
            linear = propagate(model, np.zeros(COUNT), coefficients)[120::120, :9]
            flown = odd_part(flight, height, np.zeros(9), sensors)
            assert horizontal_difference(flown, linear) < 1e-4, (effect.name, axis)


def test_free_height_runs_away_as_the_navigators() -> None:
    flight = Flight.of(weave(45, 1200), 1200)
    model = linearize(sample_motion(flight.trajectory, 0.0, 1.0, 1200), Free())
    start = np.zeros(COUNT)
    start[2] = 1.0
    linear = propagate(model, start, np.zeros((2, 3)))[60::60, :9]
    flown = odd_part(flight, Free(), start[:9], np.zeros((1, 6)))
    assert linear[-1, 2] > 3.0
    assert flown[:, 2] == pytest.approx(linear[:, 2], rel=1e-4)


@pytest.mark.parametrize(("state", "size"), [(2, 10.0), (5, 0.01)])
def test_damped_height_comes_back_as_the_navigators(state: int, size: float) -> None:
    """Height to 1e-4. What it passes on to north and east differs in proportion to the navigator's
    step, so that the linear model is what the navigator tends to."""
    off = []
    start = np.zeros(COUNT)
    start[state] = size
    for interval in (0.04, 0.02, 0.01):
        flight = Flight.of(weave(45, 1200), 1200, interval)
        height = BaroDamped(flight.heights)
        model = linearize(sample_motion(flight.trajectory, 0.0, 1.0, 1200), height)
        linear = propagate(model, start, np.zeros((2, 3)))[60::60, :9]
        flown = odd_part(flight, height, start[:9], np.zeros((1, 6)))
        off.append(horizontal_difference(flown, linear))
        assert np.linalg.norm((flown - linear)[:, 2]) < 1e-4 * np.linalg.norm(linear[:, 2])
    assert off[1] < 0.55 * off[0]
    assert off[2] < 0.55 * off[1]


def test_remainder_is_of_second_order() -> None:
    """Twice the error, four times the difference."""
    flight = Flight.of(weave(45, HOUR), HOUR)
    height = Clamped(flight.heights)
    model = linearize(sample_motion(flight.trajectory, 0.0, 1.0, 3600), height)
    remainders = []
    for size in (1.0, 2.0):
        start = size * np.array([500, 500, 0, 1, 1, 0, 1e-3, 1e-3, 1e-3, 0])
        linear = propagate(model, start, np.zeros((2, 3)))[60::60, :9]
        flown = flight.errors(height, start[:9], np.zeros((1, 6)))
        remainders.append(np.linalg.norm((flown - linear)[:, :2]))
    assert remainders[1] / remainders[0] == pytest.approx(4.0, rel=0.05)


def test_second_order_in_the_step_through_rolls() -> None:
    trajectory = weave(45, 1200, roll_every=300)
    effects = (*BIASES, gyro_scale_factor(), *bias_map(4, FIRST_ANGLE))

    def final(step: float) -> np.ndarray:
        model = linearize(
            sample_motion(trajectory, 0.0, step, round(1200 / step)), CLAMPED, effects
        )
        start = np.array([0, 0, 0, 0.1, 0.1, 0, 1e-5, 1e-5, 1e-5, 0])
        return propagate(model, start, np.full((5, 3), 1e-7))[-1, :2]

    exact = final(0.125)
    errors = [np.linalg.norm(final(step) - exact) for step in (0.5, 1.0)]
    assert errors[1] < 2e-4 * np.linalg.norm(exact)
    assert errors[1] > 3.0 * errors[0]


@pytest.mark.parametrize("step", [1.0, 10.0, 60.0])
def test_48_h_at_rest_do_not_depend_on_the_step(step: float) -> None:
    """Exact at any step, to 1e-9 of the position."""
    rates = np.zeros((COUNT + 1, COUNT + 1))
    still = _at_rest(1.0)
    rates[:COUNT, :COUNT] = dynamics(still, CLAMPED)[0]
    rates[:COUNT, COUNT] = sensor_inputs(still, CLAMPED)[0] @ BIAS.ravel()
    exact = (expm(rates * 172_800) @ np.append(TILTED, 1.0))[:2]
    assert _after_48_h(step)[:2] == pytest.approx(exact, abs=1e-9 * np.linalg.norm(exact))


def test_euler_would_grow() -> None:
    """The control: explicit Euler steps of 1 s let the Schuler oscillation grow by a factor of
    exp(T dt g / 2 R) = 1.14 in 48 h."""
    rates = dynamics(_at_rest(1.0), CLAMPED)[0]
    x = np.linalg.matrix_power(np.eye(COUNT) + rates, 172_800) @ TILTED
    exact = np.linalg.norm(expm(rates * 172_800)[3:5] @ TILTED)
    assert np.linalg.norm(x[3:5]) / exact == pytest.approx(1.14, abs=0.01)


BIAS = np.array([np.full(3, 5e-8), np.full(3, 1e-4)])
TILTED = np.concatenate([np.zeros(6), [1e-4, 0, 0, 0]])


def _after_48_h(step: float) -> np.ndarray:
    model = linearize(_at_rest(step), CLAMPED)
    drive = np.tensordot(model.inputs[0], BIAS, axes=2)
    x = TILTED
    for _ in range(round(172_800 / step)):
        x = model.transition[0] @ x + drive
    return x


def _at_rest(step: float) -> Motion:
    """One step, which is like all others; the car's pitch and roll are 0."""
    still = sample_motion(load_trajectory("car", 10.0, 20.0), -15.0, step=1.0, count=1)
    return replace(still, step=step)


def test_joined_models_must_follow() -> None:
    car = load_trajectory("car", 60.0, 60.0)
    first, then = (linearize(sample_motion(car, start, 1.0, 30), CLAMPED) for start in (-30.0, 0.0))
    assert len(join_models(first, then)) == 60
    with pytest.raises(ValueError, match=r"from -30\.0 s.*same moment"):
        join_models(then, first)
    without = linearize(sample_motion(car, 0.0, 1.0, 30), CLAMPED, BIASES[:1])
    with pytest.raises(ValueError, match="expected the same"):
        join_models(first, without)


def test_covariance_is_that_of_its_parts() -> None:
    """Without noise, the covariance is the sum of outer products of what each part leads to."""
    effects = (*BIASES, gyro_scale_factor())
    model = linearize(sample_motion(weave(45, 600), 0.0, 1.0, 600), Free(), effects)
    initial = np.diag(np.arange(1.0, COUNT + 1)) * 1e-8
    sigmas = np.array([np.full(3, 1e-8), np.full(3, 1e-4), np.full(3, 1e-6)])
    result = propagate_covariance(model, initial, sigmas)[::300]
    parts = []
    for state in range(COUNT):
        start = np.sqrt(initial) @ np.eye(COUNT)[state]
        parts.append(propagate(model, start, np.zeros((3, 3)))[::300])
    for place in np.ndindex(3, 3):
        unit = np.zeros((3, 3))
        unit[place] = sigmas[place]
        parts.append(propagate(model, np.zeros(COUNT), unit)[::300])
    expected = sum(np.einsum("ni,nj->nij", part, part) for part in parts)
    scale = np.sqrt(np.einsum("nii,njj->nij", expected, expected))
    assert np.max(np.abs(result - expected) / np.maximum(scale, 1e-30)) < 1e-9


def test_noise_gained_is_the_integral() -> None:
    """At rest for a minute: velocity and attitude walk."""
    noise = SensorErrors(angle_random_walk=1e-6, velocity_random_walk=1e-3)
    model = linearize(
        sample_motion(load_trajectory("car", 10.0, 80.0), -70.0, 1.0, 60), CLAMPED, (), noise
    )
    result = propagate_covariance(model, np.zeros((COUNT, COUNT)), np.zeros((0, 3)))[-1]
    assert result[6, 6] == pytest.approx(1e-12 * 60, rel=1e-4)
    tilted = (9.8 * 1e-6) ** 2 * 60**3 / 3
    assert result[3, 3] == pytest.approx(1e-6 * 60 + tilted, rel=1e-2)
    assert result[5, 5] == 0.0
