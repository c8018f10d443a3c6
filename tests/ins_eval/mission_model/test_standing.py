"""Alignment beyond first order."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from ins_eval.alignment.analytic import static_alignment
from ins_eval.common.increments import Increments
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission
from ins_eval.mission_model.standing import attitude_made, beyond_first_order
from pyhrg.common.units import DEG_PER_H, MICRO_G

RATE = DEG_PER_H * np.array([[0.1, -0.07, 0.05]])
FORCE = MICRO_G * np.array([[20.0, -30.0, 10.0]])


def test_attitude_is_that_of_the_alignment(short: StudyMission, weights: MissionWeights) -> None:
    true = short.trajectory().increments(-280.0, 1.0, 280)
    measured = Increments(1.0, true.rotation + RATE, true.velocity + FORCE, -280.0)
    standing = weights.standing
    made = static_alignment(measured, standing.latitude) @ standing.mat_nb.T
    found = attitude_made(standing, RATE, FORCE)[0]
    assert found == pytest.approx(Rotation.from_matrix(made).as_rotvec(), abs=1e-9)


def test_what_is_beyond_first_order_is_of_second(weights: MissionWeights) -> None:
    whole = beyond_first_order(weights.standing, RATE, FORCE)
    tenth = beyond_first_order(weights.standing, RATE / 10, FORCE / 10)
    assert np.abs(whole).max() > 0
    assert tenth == pytest.approx(whole / 100, rel=0.02, abs=1e-3 * np.abs(whole).max())
