"""The vertical channel: free, clamped, and drawn to a barometer, against closed forms."""

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.common.state import State, Track
from ins_eval.navigation.height import BaroDamped, Clamped, Free, Height
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments
from tests.ins_eval import theory
from tests.ins_eval.cases import at_rest

LATITUDE = np.deg2rad(45.0)
EACH = 600


def at_rest_from(height: float, hold: Height, seconds: int, latitude: float = LATITUDE) -> Track:
    """A navigator that starts at `height` while the vehicle rests at 0 m."""
    start = State(latitude, 0.0, height, np.zeros(3), np.eye(3))
    return navigate(start, at_rest(latitude, 0.0, seconds, np.zeros(3)), hold, EACH)


def climbing() -> Trajectory:
    """Up by 300 m and down again every 100 s, heading north at 100 m/s."""
    time = np.arange(-5.0, 205.0, 0.5)
    w = 2 * np.pi / 100
    zero = np.zeros_like(time)
    height = 500 - 300 * np.cos(w * time)
    channels = [LATITUDE + 1.57e-5 * time, zero, height, zero, zero, zero]
    return Trajectory("climb", time, np.stack(channels, axis=-1))


def test_free_height_runs_away_as_a_hyperbolic_cosine() -> None:
    """The down velocity grows as a sinh. At 80 deg, since Coriolis acceleration, which the closed
    form leaves out, slows the growth nearer the equator (by 0.6 % in 1 h at 45 deg)."""
    latitude = np.deg2rad(80.0)
    track = at_rest_from(1.0, Free(), 3600, latitude)
    expected = theory.free_height(1.0, track.time, latitude)
    assert track.position[:, 2] == pytest.approx(expected, rel=1e-3)
    rate = np.sqrt(theory.gravity_slope(latitude))
    assert -track.velocity[:, 2] == pytest.approx(rate * np.sinh(rate * track.time), rel=1e-3)
    assert expected[-1] > 250


@pytest.mark.parametrize("time_constant", [20.0, 100.0])
def test_step_of_the_barometer_is_answered_by_a_triple_pole(time_constant: float) -> None:
    barometer = BaroDamped(np.full(60_001, 10.0), time_constant)
    track = at_rest_from(0.0, barometer, 600)
    expected = theory.damped_height(10.0, track.time, time_constant, LATITUDE)
    assert track.position[:, 2] == pytest.approx(expected, abs=10 * 1e-4)
    assert np.max(expected) > 10.5


def test_triple_pole_is_met_to_the_second_order_of_the_step() -> None:
    """A pole so fast that the steps show."""
    errors = []
    for rate in (5, 10, 20):
        force = [0.0, 0.0, -earth.gravity(LATITUDE, 0.0) / rate]
        still = at_rest(LATITUDE, 0.0, 0.01, np.zeros(3)).rotation * 100 / rate
        count = 20 * rate
        record = Increments(1 / rate, np.repeat(still, count, axis=0), np.tile(force, (count, 1)))
        start = State(LATITUDE, 0.0, 0.0, np.zeros(3), np.eye(3))
        track = navigate(start, record, BaroDamped(np.full(count + 1, 10.0), 4.0), 2 * rate)
        expected = theory.damped_height(10.0, track.time, 4.0, LATITUDE)
        errors.append(np.max(np.abs(track.position[:, 2] - expected)))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 1.8), (orders, errors)


def test_damped_height_forgets_its_start() -> None:
    track = at_rest_from(50.0, BaroDamped(np.zeros(180_001)), 1800)
    assert abs(track.position[-1, 2]) < 0.01


@pytest.mark.parametrize("hold", [Free, Clamped, BaroDamped])
def test_climbs_and_dives(hold: type) -> None:
    """Without errors: each channel keeps height and speed, and north and east with it."""
    trajectory = climbing()
    increments = trajectory.increments(0.0, 0.01, 20_000)
    heights = trajectory.position(increments.bounds)[:, 2]
    channel = Free() if hold is Free else hold(heights)
    track = navigate(trajectory.state(0.0), increments, channel, 1000)
    truth = trajectory.track(track.time)
    assert np.max(np.abs(track.position[:, 2] - truth.position[:, 2])) < 2e-4
    assert np.max(np.abs(track.velocity - truth.velocity)) < 1e-4
    assert np.max(np.abs(track.position[:, :2] - truth.position[:, :2])) * 6.4e6 < 1e-3


@pytest.mark.parametrize("hold", [Free, BaroDamped])
def test_vertical_error_falls_as_the_square_of_the_step(hold: type) -> None:
    trajectory = climbing()
    errors = []
    for rate in (5, 10, 20):
        increments = trajectory.increments(0.0, 1 / rate, 200 * rate)
        heights = trajectory.position(increments.bounds)[:, 2]
        channel = Free() if hold is Free else hold(heights)
        track = navigate(trajectory.state(0.0), increments, channel, 20 * rate)
        truth = trajectory.position(track.time)[:, 2]
        errors.append(np.max(np.abs(track.position[:, 2] - truth)))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 1.8), (orders, errors)


def make_four_increments() -> tuple[State, Increments]:
    start = State(LATITUDE, 0.0, 0.0, np.zeros(3), np.eye(3))
    return start, at_rest(LATITUDE, 0.0, 0.04, np.zeros(3))


def test_height_that_is_not_finite_is_named() -> None:
    with pytest.raises(HrgError, match="height 2 is nan: expected finite, in m"):
        navigate(*make_four_increments(), Clamped(np.array([0, 0, np.nan, 0, 0])), 2)


@pytest.mark.parametrize("time_constant", [0.0, -1.0, 0.02, np.nan, np.inf])
def test_time_constant_must_be_longer_than_a_step(time_constant: float) -> None:
    with pytest.raises(HrgError, match=r"expected longer than a step, 0.02 s"):
        navigate(*make_four_increments(), BaroDamped(np.zeros(5), time_constant), 2)
