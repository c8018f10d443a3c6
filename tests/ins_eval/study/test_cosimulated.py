"""The co-simulation: its noise is its seed's, its mounting that of the linear model."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission
from ins_eval.mission_model.position_errors import compute_map_errors
from ins_eval.study.cosimulated import MissionTruth, cosimulate, sample_truth, tilt_input_axes
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from pyhrg.common.units import ARCSEC
from pyhrg.fmu import GyroFmu


@pytest.fixture(scope="module")
def truth(short: StudyMission) -> MissionTruth:
    return sample_truth(short)


def test_axes_lean_towards_the_others() -> None:
    """By 1 mrad towards the next axis, 2 mrad towards the one after."""
    axes = tilt_input_axes(np.repeat([[1e-3], [2e-3]], 3, axis=1))
    expected = [[1, 1e-3, 2e-3], [2e-3, 1, 1e-3], [1e-3, 2e-3, 1]]
    np.testing.assert_allclose(axes, expected, atol=3e-6)
    np.testing.assert_allclose(np.linalg.norm(axes, axis=1), 1.0)


def test_mounting_is_that_of_the_linear_model(
    fmu: GyroFmu, some: list[DrawnTriad], truth: MissionTruth, weights: MissionWeights
) -> None:
    """Errors with a lean of 100 arcsec less those without: within 1 % of the linear ones."""
    leaning = 100 * ARCSEC * np.random.default_rng(1).normal(size=(2, 3))
    with_lean, without = (
        cosimulate(fmu, truth, replace(some[0], mounting=mounting))
        for mounting in (leaning, np.zeros((2, 3)))
    )
    linear = compute_map_errors(weights.mounting, leaning[None])[0]
    difference = np.linalg.norm(with_lean - without - linear)
    assert difference < 0.01 * np.linalg.norm(linear)


def test_noise_is_its_seeds(fmu: GyroFmu, some: list[DrawnTriad], truth: MissionTruth) -> None:
    one, same, other = (
        cosimulate(fmu, truth, some[0], np.random.SeedSequence(seed)) for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(one, same)
    quiet = cosimulate(fmu, truth, some[0])
    assert np.abs(one - quiet).max() > 1.0
    assert np.abs(one - other).max() > 1.0
