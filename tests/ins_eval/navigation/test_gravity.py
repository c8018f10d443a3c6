"""Gravity's level components: the plumb line's curvature, and the deflection of the vertical."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.common.state import State, position_error
from ins_eval.flights import linear
from ins_eval.flights.flight import fly_runs, sample_truth
from ins_eval.flights.plan import Plan
from ins_eval.imu.imu import Imu
from ins_eval.imu.specification import load_imu
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.units import ARCSEC
from tests.ins_eval import theory
from tests.ins_eval.cases import at_rest

LATITUDE = np.deg2rad(40.0)
NORTH, EAST = 6.0, -3.0
"""Deflection, arcsec."""
HOUR = 3600
RESTING = f"""
start = {{ latitude_deg = 40, longitude_deg = 10, height_m = 9000, heading_deg = 30 }}
course = [{{ kind = "rest", duration_s = 4000 }}]
deflection = {{ north_arcsec = {NORTH}, east_arcsec = {EAST} }}
"""


@pytest.fixture
def resting(tmp_path: Path) -> str:
    path = tmp_path / "resting.toml"
    path.write_text(RESTING)
    return str(path)


def test_high_above_the_ellipsoid_it_stays_where_it_is() -> None:
    """9 km up, 1 h at rest: without gravity's north component it went 63 m astray, R dg/g (1 - cos
    of the Schuler angle) to the south."""
    height = 9000.0
    record = at_rest(LATITUDE, height, HOUR, np.zeros(3))
    assert np.sum(record.velocity[:, 0]) == pytest.approx(
        8.08e-9 * height * np.sin(2 * LATITUDE) * HOUR
    )
    start = State(LATITUDE, 0.0, height, np.zeros(3), np.eye(3))
    track = navigate(start, record, Clamped(np.full(HOUR * 100 + 1, height)), HOUR * 100)
    error = position_error(track.position, start.position[None])[0]
    assert np.hypot(error[0], error[1]) < 1e-3


def expect_at_rest(seconds: int, start: np.ndarray) -> np.ndarray:
    """(m, 2) position errors, m, each minute, by the closed form of an accelerometer's bias."""
    force = earth.gravity(LATITUDE, 9000.0) * ARCSEC * np.array([NORTH, EAST, 0.0])
    time = np.arange(0.0, seconds + 60, 60)
    found = theory.AtRest(LATITUDE, 9000.0).errors(time, start, np.zeros(3), force)
    return found[:, theory.POSITION]


def test_deflection_swings_at_schulers_frequency(resting: str) -> None:
    """As an accelerometer's bias of g xi; nothing is left of it where the navigator is told."""
    truth = load_trajectory(resting, HOUR)
    record = truth.increments(0.0, 0.1, HOUR * 10)
    start, heights = truth.state(0.0), Clamped(np.full(HOUR * 10 + 1, 9000.0))
    alone = navigate(start, record, heights, 600)
    told = navigate(start, record, heights, 600, deflection=(NORTH * ARCSEC, EAST * ARCSEC))
    error = position_error(alone.position, start.position)[:, :2]
    expected = expect_at_rest(HOUR, np.zeros(theory.STATES))
    np.testing.assert_allclose(error, expected[1:], atol=0.1)
    assert np.max(np.hypot(*error.T)) > 400
    assert np.max(np.abs(position_error(told.position, start.position))) < 1e-3


def test_budget_names_the_deflection(resting: str) -> None:
    """An ideal IMU: all of the error is the deflection's; after an alignment none is left."""
    plan = Plan(0.1, HOUR * 10, 100, alignment=None, runs=1)
    truth = sample_truth(plan, load_trajectory(resting, HOUR))
    runs = fly_runs(plan, truth, Imu(interval=0.1))
    table = linear.compute_error_budget(plan, truth, Imu(interval=0.1), runs.first).table
    flown = position_error(runs.first.track.position[-1], truth.track.position[-1])
    assert set(table["effect"]) == {"deflection of the vertical"}
    assert table["north_contribution_m"].sum() == pytest.approx(flown[0], rel=1e-3)
    assert table["east_contribution_m"].sum() == pytest.approx(flown[1], rel=1e-3)
    assert np.hypot(*flown[:2]) > 100


def test_alignment_hides_most_of_it(resting: str, tmp_path: Path) -> None:
    """Of 240 m it leaves 40, those of another latitude: the same IMU errs by so much less without
    the deflection."""
    plain = tmp_path / "plain.toml"
    plain.write_text(RESTING.replace("deflection =", "# "))
    plan, imu = (
        Plan(0.1, HOUR * 10, 100, alignment=280.0),
        replace(load_imu("simple"), interval=0.1),
    )
    ends = []
    for mission in (resting, str(plain)):
        truth = sample_truth(plan, load_trajectory(mission, HOUR, 300.0))
        runs = fly_runs(plan, truth, imu)
        end = position_error(runs.first.track.position[-1], truth.track.position[-1])[:2]
        table = linear.compute_error_budget(plan, truth, imu, runs.first).table
        total = table[["north_contribution_m", "east_contribution_m"]].sum()
        np.testing.assert_allclose(total, end, atol=0.01 * float(np.hypot(*end)))
        ends.append(end)
    start = np.zeros(theory.STATES)
    force = earth.gravity(LATITUDE, 9000.0) * ARCSEC * np.array([NORTH, EAST, 0.0])
    start[theory.ATTITUDE] = theory.gyrocompassing_error(np.zeros(3), force, LATITUDE)
    expected = expect_at_rest(HOUR, start)[-1]
    np.testing.assert_allclose(ends[0] - ends[1], expected, atol=0.1 * np.hypot(*expected))
    assert np.hypot(*expected) < 50
