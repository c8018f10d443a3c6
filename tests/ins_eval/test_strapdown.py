"""The navigator's own error, and what a gyro bias does, against published figures."""

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid
from scipy.spatial.transform import Rotation

from ins_eval import strapdown
from ins_eval.metrics import position_error
from ins_eval.mission import Mission, mission
from ins_eval.missions import car
from ins_eval.strapdown import State, navigate
from ins_eval.trajectories import Knots, Trajectory
from pyhrg.units import DEG_PER_H
from tests.ins_eval.cases import at_rest


@pytest.fixture(scope="module")
def two_hours() -> Mission:
    return mission(car(320.0, 7210.0), 2.0)


def test_own_error_is_below_10_m_at_2_h(two_hours: Mission) -> None:
    """No sensor error at all, alignment included, on the default manoeuvre: a metre, in fact."""
    error = np.hypot(*two_hours.fly(two_hours.truth).T)
    assert np.max(error) < 1.0


def test_default_manoeuvre_goes_through_all_headings(two_hours: Mission) -> None:
    heading = np.cumsum(two_hours.truth.rotation[:, 2])
    octants = np.unique(np.floor(np.mod(heading, 2 * np.pi) / (np.pi / 4)))
    assert len(octants) == 8


def test_published_up_gyro_bias() -> None:
    """Latitude 34 deg, height 380 m, up gyro +0.01 deg/h: two independent codes agree on
    105.06/8.01 m north/east at 1 h and 450.1/46.7 m at 2 h to 0.1 %."""
    latitude, height = np.deg2rad(34.0), 380.0
    record = at_rest(latitude, height, 7200, np.array([0, 0, -0.01 * DEG_PER_H]))
    start = State(latitude, 0.0, np.zeros(3), np.eye(3))
    track = navigate(start, record, np.full(360_001, height), 360_000)
    truth = np.tile([latitude, 0.0, height], (2, 1))
    expected = [[105.06, 8.01], [450.1, 46.7]]
    assert position_error(track, truth) == pytest.approx(np.array(expected), rel=2e-3)


def weaving_error(hertz: int) -> float:
    """Own error after 10 min of an aircraft that weaves by 20 deg at 250 m/s, m."""
    time = np.arange(-5, 611, 0.25)
    heading = np.deg2rad(20) * np.sin(2 * np.pi * time / 60)
    roll = np.arctan(250 * np.gradient(heading, time) / 9.8)
    north = cumulative_trapezoid(250 * np.cos(heading), time, initial=0)
    east = cumulative_trapezoid(250 * np.sin(heading), time, initial=0)
    latitude = np.deg2rad(45) + north / 6.37e6
    level = np.zeros_like(time)
    aircraft = Trajectory(
        "weaving",
        Knots(time, latitude, east / 4.5e6, level + 1000, roll, level, heading),
    )
    increments = aircraft.increments(0.0, 1 / hertz, 600 * hertz)
    position = aircraft.position(np.arange(300 * hertz + 1) * 2 / hertz)
    zero = np.array(0.0)
    start = State(position[0, 0], position[0, 1], aircraft.velocity(zero), aircraft.mat_nb(zero))
    track = navigate(start, increments, position[:, 2], 600 * hertz)
    return float(np.hypot(*position_error(track, position[-1:])[0]))


def test_error_falls_as_the_square_of_the_step() -> None:
    coarse, fine = weaving_error(50), weaving_error(100)
    assert coarse < 0.05
    assert coarse / fine == pytest.approx(4.0, rel=0.1)


def test_odd_number_of_intervals_is_refused() -> None:
    record = at_rest(0.5, 0.0, 0.03, np.zeros(3))
    with pytest.raises(ValueError, match="3 intervals, every 2 kept: both must be even"):
        navigate(State(0.5, 0.0, np.zeros(3), np.eye(3)), record, np.zeros(2), 2)


def test_heights_must_match() -> None:
    record = at_rest(0.5, 0.0, 0.04, np.zeros(3))
    with pytest.raises(ValueError, match="5 heights given, 3 expected"):
        navigate(State(0.5, 0.0, np.zeros(3), np.eye(3)), record, np.zeros(5), 2)


def exact_motion(start: float, length: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Increments of rotation and velocity, and the exact velocity change in the axes of the start,
    of a body that cones and shakes at once; by 2000 midpoint steps."""
    count = 2000
    h = length / count
    t = start + h * (np.arange(count) + 0.5)
    omega = np.stack([np.cos(9 * t), np.sin(9 * t), 0.3 + 0.2 * t], axis=-1)
    force = np.stack([3 * np.sin(9 * t), 2 + np.cos(9 * t), 9.8 + t], axis=-1)
    change, turned = np.zeros(3), Rotation.identity()
    for w, f in zip(omega, force, strict=True):
        half = turned * Rotation.from_rotvec(0.5 * h * w)
        change = change + half.apply(f) * h
        turned = turned * Rotation.from_rotvec(h * w)
    return omega.sum(axis=0) * h, force.sum(axis=0) * h, np.append(change, turned.as_rotvec())


@pytest.mark.parametrize(("quantity", "order"), [("coning", 5), ("sculling", 4)])
def test_two_sample_corrections_have_their_order(quantity: str, order: int) -> None:
    """Error over one pair of intervals falls with the 5th power of its length for coning, the 4th
    for sculling; a wrong or missing correction leaves the 3rd."""
    errors = []
    for length in (0.08, 0.04):
        r1, v1, _ = exact_motion(0.2, length / 2)
        r2, v2, _ = exact_motion(0.2 + length / 2, length / 2)
        change, rotation = np.split(exact_motion(0.2, length)[2], 2)
        if quantity == "coning":
            got, exact = strapdown._coning(tuple(r1), tuple(r2)), rotation
        else:
            got, exact = strapdown._sculling(*map(tuple, (r1, r2, v1, v2))), change
        errors.append(np.linalg.norm(np.array(got) - exact))
    assert errors[0] / errors[1] > 2 ** (order - 0.5)
