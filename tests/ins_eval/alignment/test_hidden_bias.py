"""The bias that alignment hides: after a turn the east gyro's reappears as position error."""

from dataclasses import dataclass

import numpy as np
import pytest

from ins_eval.alignment.analytic import bias_sensitivity, level_and_gyrocompass
from ins_eval.common import earth
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.state import State, position_error
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.imu.log import Increments
from tests.ins_eval import theory

LATITUDE, BIAS = 40 * DEG, 0.01 * DEG_PER_H
STILL = 300.0
"""Alignment, before time 0, s."""
TURN_DURATION = 20.0
"""Duration of the turn after it, s."""
INTERVAL, KEPT = 0.05, 60.0
"""Interval of the increments, and time between positions, s."""
HOURS_2 = 7200.0


@dataclass(frozen=True)
class Growth:
    """Position errors, north and east, m, (m, 2): navigated, and in closed form."""

    navigated: Array
    closed_form: Array


def grow(turn: float) -> Growth:
    """Align heading north with a biased right gyro, turn on the spot, and stand for two hours."""
    ideal = turn_on_the_spot(turn)
    total, zero = round((STILL + HOURS_2) / INTERVAL), round(STILL / INTERVAL)
    true = ideal.increments(-STILL, INTERVAL, total)
    biased = true.rotation + np.array([0.0, BIAS, 0.0]) * INTERVAL
    measured = Increments(INTERVAL, biased, true.velocity, -STILL)
    mat_nb = level_and_gyrocompass(measured.between(0, zero), LATITUDE)
    start = State(LATITUDE, 0.0, 0.0, np.zeros(3), mat_nb)
    flight = measured.between(zero, total)
    clamp = Clamped(np.zeros(len(flight) + 1))
    track = navigate(start, flight, clamp, round(KEPT / INTERVAL))
    error = position_error(track.position, np.array([LATITUDE, 0.0, 0.0]))[:, :2]
    return Growth(error, solve_after_turn(turn, track.time - TURN_DURATION / 2))


def solve_after_turn(turn: float, time: Array) -> Array:
    """(m, 2) position error, m, at equally spaced times (m,) after a sudden turn at time 0.

    The heading error of the alignment stays, and the bias points elsewhere.
    """
    biases = np.array([0.0, BIAS, *[0.0] * 4])
    start = np.zeros(theory.STATES)
    start[theory.ATTITUDE] = bias_sensitivity(LATITUDE, earth.gravity(LATITUDE, 0.0)) @ biases
    turned = mat_from_euler(np.array(0.0), np.array(0.0), np.array(turn)) @ biases[:3]
    at_rest = theory.AtRest(LATITUDE)
    step = time[1] - time[0] if len(time) > 1 else time[0]
    first = at_rest.errors(np.array([0.0, time[0]]), start, turned, np.zeros(3))[1]
    later = at_rest.errors(step * np.arange(max(len(time), 2)), first, turned, np.zeros(3))
    return later[: len(time), theory.POSITION]


def turn_on_the_spot(turn: float) -> Trajectory:
    time = np.arange(-STILL - 10.0, HOURS_2 + 10.0, 1.0)
    s = np.clip(time / TURN_DURATION, 0.0, 1.0)
    zero = np.zeros_like(time)
    yaw = turn * s**3 * (10 - 15 * s + 6 * s**2)
    channels = [np.full_like(time, LATITUDE), zero, zero, zero, zero, yaw]
    return Trajectory("turn", time, np.stack(channels, axis=-1))


def test_without_a_turn_the_bias_stays_hidden() -> None:
    """1 m of the kilometres that it is worth."""
    assert np.max(np.abs(grow(0.0).navigated)) < 1.0


@pytest.mark.parametrize(("turn_deg", "kilometres"), [(90, 2.9), (180, 4.1)])
def test_after_a_turn_it_grows_as_the_closed_form(turn_deg: float, kilometres: float) -> None:
    """To 0.2 %: the turn takes 20 s. The sizes are those of docs/navigation.md."""
    growth = grow(turn_deg * DEG)
    radial = np.hypot(*growth.closed_form[-1])
    assert radial / 1000 == pytest.approx(kilometres, abs=0.05)
    assert np.max(np.abs(growth.navigated - growth.closed_form)) < 0.002 * radial


def test_half_a_turn_counts_the_bias_twice() -> None:
    """Early on, before Earth's rotation matters: Schuler's oscillation under a drift of 2 e."""
    time = np.array([600.0])
    schuler = np.sqrt(earth.gravity(LATITUDE, 0.0) / earth.meridian_radius(LATITUDE))
    north = earth.meridian_radius(LATITUDE) * (time - np.sin(schuler * time) / schuler)
    result = solve_after_turn(180 * DEG, time)[:, 0]
    assert result == pytest.approx(2 * BIAS * north, rel=0.01)
