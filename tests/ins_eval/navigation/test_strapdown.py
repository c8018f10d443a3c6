"""The navigator's own error, and what a gyro bias does, against published figures."""

import numpy as np
import pytest

from ins_eval.common.state import State, position_error
from ins_eval.navigation.coefficients import SAMPLES_PER_STEP
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.parking.mission import Mission, sample_mission
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H
from tests.ins_eval.cases import at_rest


@pytest.fixture(scope="module")
def two_hours() -> Mission:
    return sample_mission(load_trajectory("car", 7210.0, 320.0), 2.0)


def test_own_error_is_below_10_m_at_2_h(two_hours: Mission) -> None:
    """No sensor error at all, alignment included, on the default manoeuvre: a metre, in fact."""
    error = np.hypot(*two_hours.fly(two_hours.truth.increments).T)
    assert np.max(error) < 1.0


def test_default_manoeuvre_goes_through_all_headings(two_hours: Mission) -> None:
    heading = np.cumsum(two_hours.truth.increments.rotation[:, 2])
    octants = np.unique(np.floor(np.mod(heading, 2 * np.pi) / (np.pi / 4)))
    assert len(octants) == 8


def test_published_up_gyro_bias() -> None:
    """Latitude 34 deg, height 380 m, up gyro +0.01 deg/h: two independent codes agree on
    105.06/8.01 m north/east at 1 h and 450.1/46.7 m at 2 h to 0.1 %."""
    latitude, height = np.deg2rad(34.0), 380.0
    record = at_rest(latitude, height, 7200, np.array([0, 0, -0.01 * DEG_PER_H]))
    start = State(latitude, 0.0, height, np.zeros(3), np.eye(3))
    track = navigate(start, record, Clamped(np.full(720_001, height)), 360_000)
    truth = np.tile([latitude, 0.0, height], (2, 1))
    expected = [[105.06, 8.01], [450.1, 46.7]]
    assert position_error(track.position, truth)[:, :2] == pytest.approx(
        np.array(expected), rel=2e-3
    )


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
def test_intervals_must_fill_steps(samples: int) -> None:
    record = at_rest(0.5, 0.0, 0.05, np.zeros(3))
    start = State(0.5, 0.0, 0.0, np.zeros(3), np.eye(3))
    with pytest.raises(HrgError, match=f"5 increments.*multiples of samples, {samples}"):
        navigate(start, record, Clamped(np.zeros(6)), samples, samples)


def test_heights_must_match() -> None:
    record = at_rest(0.5, 0.0, 0.04, np.zeros(3))
    start = State(0.5, 0.0, 0.0, np.zeros(3), np.eye(3))
    with pytest.raises(
        HrgError, match=r"shape \(3,\): expected \(5,\), at the bounds of 4 intervals"
    ):
        navigate(start, record, Clamped(np.zeros(3)), 2)
