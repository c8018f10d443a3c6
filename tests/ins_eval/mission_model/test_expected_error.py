"""The expected error against flights without noise and accelerometers, alignment included."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.mission_model.mission_weights import MissionWeights, compute_mission_weights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import (
    compute_expected_error,
    compute_linear_position_errors,
)
from tests.ins_eval.study.predictors import cases


@pytest.fixture(scope="module")
def car() -> MissionWeights:
    return compute_mission_weights(plan_mission("car", 0.5))


def test_it_is_flown_without_noise_and_accelerometers(car: MissionWeights) -> None:
    triads = cases.triads(seed=1, count=10)
    quiet = replace(
        triads,
        noise=np.zeros_like(triads.noise),
        accelerometers=np.zeros_like(triads.accelerometers),
        mounting=np.zeros_like(triads.mounting),
    )
    parts = compute_linear_position_errors(quiet, car, mission=0)
    found = compute_expected_error(car, triads.in_flight)
    np.testing.assert_allclose(found, parts.error, rtol=1e-9, atol=1e-6)
    assert np.max(np.abs(parts.alignment)) > 1.0
