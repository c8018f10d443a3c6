"""Motion of a trajectory, and of what was flown along it."""

import numpy as np
import pytest

from ins_eval.error_model.effects import BIASES, bias_map, gyro_scale_factor
from ins_eval.error_model.linear_model import linear_model, propagated
from ins_eval.error_model.motion import along, flown, step_mean
from ins_eval.error_model.states import COUNT
from ins_eval.navigation.height import Clamped
from ins_eval.state import Track
from tests.ins_eval.error_model.cases import weave


def test_means_are_exact_for_fifth_degree() -> None:
    time = np.arange(9) * 0.5
    expected = np.diff(np.array([0.0, 2.0, 4.0]) ** 6) / 6 / 2
    assert step_mean(time**5) == pytest.approx(expected, rel=1e-13)


def test_flown_motion_gives_the_same_model() -> None:
    """From a track and increments at 50 Hz as from the trajectory, to 1e-3 of each error."""
    trajectory = weave(45, 600)
    truth = trajectory.increments(0.0, 0.02, 30_000)
    track = trajectory.track(np.arange(0, 600.1, 0.1))
    motions = along(trajectory, 0.0, 0.4, 1500), flown(track, truth)
    assert motions[1].step == pytest.approx(0.4)
    assert motions[1].turned == pytest.approx(motions[0].turned, abs=1e-9)
    effects = (*BIASES, gyro_scale_factor(), *bias_map(4, np.zeros(3)))
    models = [linear_model(motion, Clamped(np.zeros(1)), effects) for motion in motions]
    for place in np.ndindex(5, 3):
        one = np.zeros((5, 3))
        one[place] = 1.0
        ends = [propagated(model, np.zeros(COUNT), one)[-1, :2] for model in models]
        assert np.linalg.norm(ends[1] - ends[0]) < 1e-3 * np.linalg.norm(ends[0]), place


def test_flown_motion_needs_matching_times() -> None:
    trajectory = weave(45, 60)
    truth = trajectory.increments(0.0, 0.02, 500)

    def track(times: np.ndarray) -> Track:
        return trajectory.track(times)

    with pytest.raises(ValueError, match="7 nodes of motion: expected a multiple of 4, plus 1"):
        flown(track(np.arange(7) * 0.5), truth)
    with pytest.raises(ValueError, match=r"track from 1\.0 s.*increments' start, 0\.0 s"):
        flown(track(1 + np.arange(9) * 0.5), truth)
    with pytest.raises(ValueError, match=r"track up to 16\.0 s: increments end at 10\.0 s"):
        flown(track(np.arange(33) * 0.5), truth)
