"""Alignment beyond first order."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.mission_model.alignment_at_rest import (
    compute_attitude_error,
    compute_second_order_error,
)
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission
from pyhrg.common.units import DEG_PER_H, MICRO_G
from pyhrg.records.imu.log import Increments

RATE = DEG_PER_H * np.array([[0.1, -0.07, 0.05]])
FORCE = MICRO_G * np.array([[20.0, -30.0, 10.0]])


def test_attitude_is_that_of_the_alignment(short: StudyMission, weights: MissionWeights) -> None:
    """Beside that of ideal sensors, which lean with the plumb line by 4e-8 rad at 50 m."""
    true = short.trajectory().increments(-280.0, 1.0, 280)
    measured = Increments(1.0, true.rotation + RATE, true.velocity + FORCE, -280.0)
    standing = weights.alignment
    ideal = level_and_gyrocompass(true, standing.latitude)
    made = level_and_gyrocompass(measured, standing.latitude) @ ideal.T
    found = compute_attitude_error(standing, RATE, FORCE)[0]
    assert found == pytest.approx(Rotation.from_matrix(made).as_rotvec(), abs=1e-9)


def test_what_is_beyond_first_order_is_of_second(weights: MissionWeights) -> None:
    whole = compute_second_order_error(weights.alignment, RATE, FORCE)
    tenth = compute_second_order_error(weights.alignment, RATE / 10, FORCE / 10)
    assert np.abs(whole).max() > 0
    assert tenth == pytest.approx(whole / 100, rel=0.02, abs=1e-3 * np.abs(whole).max())
