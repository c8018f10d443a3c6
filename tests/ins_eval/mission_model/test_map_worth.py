"""The worth of a map against position errors of drawn maps."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS, start_maps
from ins_eval.mission_model.mission_weights import compute_mission_weights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import compute_map_errors, compute_map_worth

DRAWS, ANGLE = 4000, 0.7


def test_it_is_the_rms_of_drawn_maps() -> None:
    """Within 4 % (three sigma of 4000 draws), for a gyro along each axis."""
    weights = compute_mission_weights(plan_mission("car", 0.2))
    generator = np.random.default_rng(1)
    root = 1e-8 * generator.standard_normal((2 * TERMS, 2 * TERMS))
    found = compute_map_worth(weights, root @ root.T, ANGLE)
    for axis in range(3):
        maps = np.zeros((DRAWS, 2 * TERMS, 3))
        maps[:, :, axis] = generator.standard_normal((DRAWS, 2 * TERMS)) @ root.T
        turned = start_maps(maps, np.full((DRAWS, 3), ANGLE))
        errors = compute_map_errors(weights.gyros[-1:], turned)[:, 0]
        assert found[axis] == pytest.approx(np.sqrt(np.sum(errors**2, axis=1).mean()), rel=0.04)
