"""Weights of schedules against those of the mission model, and against symmetries of turned
cases."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.missions import StudyMission
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.schedules.choice import Planner
from ins_eval.schedules.schedule import Schedule, Sweep
from ins_eval.schedules.weights import weigh_schedules


def test_without_a_schedule_they_are_the_missions(planner: Planner, mission: StudyMission) -> None:
    """Sums over seconds against integrals by Boole's rule; bias, then scale factor."""
    ours = weigh_schedules(planner.response, [Schedule()]).maps[0]
    theirs = load_mission_weights(mission).gyros
    for part, tolerance in ((slice(0, TERMS), 5e-3), (slice(TERMS, 2 * TERMS), 1e-2)):
        largest = np.abs(theirs[:, :, part]).max(axis=(0, 1))
        assert np.all(np.abs(ours[:, :, part] - theirs[:, :, part]) <= tolerance * largest)


def test_a_case_turned_by_half_a_turn_turns_the_signs_of_level_gyros(planner: Planner) -> None:
    plain, turned = weigh_schedules(
        planner.response, [Schedule(), Schedule(case=Sweep(start=np.pi))]
    ).maps[:, :, :, 0]
    assert np.allclose(turned, plain * [-1.0, -1.0, 1.0], rtol=1e-9, atol=1e-6)


def test_a_turning_case_shares_noise_between_level_gyros(planner: Planner) -> None:
    """White noise about two axes is the same about two that turn; its sum stays."""
    plain, turning = weigh_schedules(
        planner.response, [Schedule(), Schedule(case=Sweep(0.05, 2 * np.pi))]
    ).walk
    assert turning[:2].sum() == pytest.approx(plain[:2].sum(), rel=1e-9)
    assert turning[2] == pytest.approx(plain[2], rel=1e-9)
    assert turning[0] != pytest.approx(plain[0], rel=1e-2)
