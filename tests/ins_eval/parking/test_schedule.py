"""Start angles chosen by the linear model, against its error at every other angle."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import NAMES, TERMS, evaluate_terms, start_maps
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import compute_expected_error
from ins_eval.mission_model.signals import COUNT
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.parking.schedule import choose_start_angles
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device.device import AngleMap

MAPS = [
    AngleMap(mean=0.3 * DEG_PER_H, cos4=0.4 * DEG_PER_H, sin2=0.1 * DEG_PER_H),
    AngleMap(mean=-0.2 * DEG_PER_H, sin4=0.5 * DEG_PER_H, cos8=0.05 * DEG_PER_H),
]


@pytest.fixture(scope="module")
def weights() -> MissionWeights:
    return load_mission_weights(plan_mission("car", 0.1))


def compute_mean_square(weights: MissionWeights, angles: np.ndarray) -> float:
    """Mean square of the mission's position error with patterns that start at angles (2,)."""
    maps = np.zeros((COUNT, 3))
    for axis, (bias_map, angle) in enumerate(zip(MAPS, angles, strict=True)):
        coefficients = np.array([getattr(bias_map, name, 0.0) for name in NAMES])
        coefficients[0] -= evaluate_terms(angle) @ coefficients
        maps[:TERMS, axis] = coefficients
    started = start_maps(maps, np.append(angles, 0.0))
    return float(np.mean(np.square(compute_expected_error(weights, started[None]))))


def test_no_other_angles_leave_less(weights: MissionWeights) -> None:
    """Every 3 deg of both gyros; the typical pair of angles leaves a hundred times more."""
    least = compute_mean_square(weights, choose_start_angles(weights, MAPS))
    grid = np.arange(0.0, 180.0, 3.0) * DEG
    others = [compute_mean_square(weights, np.array([a, b])) for a in grid for b in grid[::4]]
    assert least <= min(others)
    assert least < 0.01 * np.median(others)
