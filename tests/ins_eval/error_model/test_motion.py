"""Motion of a trajectory, and of what was flown along it."""

import numpy as np
import pytest

from ins_eval.error_model.effects import BIASES, bias_map, gyro_scale_factor
from ins_eval.error_model.linear_model import linearize, propagate
from ins_eval.error_model.motion import motion_of_track, sample_motion, step_mean
from ins_eval.error_model.states import COUNT
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from tests.ins_eval.error_model.cases import weave


def test_means_are_exact_for_fifth_degree() -> None:
    time = np.arange(9) * 0.5
    expected = np.diff(np.array([0.0, 2.0, 4.0]) ** 6) / 6 / 2
    assert step_mean(time**5) == pytest.approx(expected, rel=1e-13)


def test_flown_motion_gives_the_same_model() -> None:
    """The model along the navigator's track at 50 Hz agrees with that along the trajectory to 1e-3
    of each error."""
    trajectory = weave(45, 600)
    truth = trajectory.increments(0.0, 0.02, 30_000)
    height = Clamped(trajectory.position(truth.bounds)[:, 2])
    start = trajectory.state(0.0)
    track = navigate(start, truth, height, keep_every=6)
    motions = sample_motion(trajectory, 0.0, 0.48, 1250), motion_of_track(start, track, truth)
    assert motions[1].step == pytest.approx(0.48)
    assert motions[1].turned == pytest.approx(motions[0].turned, abs=1e-9)
    effects = (*BIASES, gyro_scale_factor(), *bias_map(4, np.zeros(3)))
    models = [linearize(motion, height, effects) for motion in motions]
    for place in np.ndindex(5, 3):
        unit = np.zeros((5, 3))
        unit[place] = 1.0
        ends = [propagate(model, np.zeros(COUNT), unit)[-1, :2] for model in models]
        assert np.linalg.norm(ends[1] - ends[0]) < 1e-3 * np.linalg.norm(ends[0]), place


def test_flown_motion_needs_matching_times() -> None:
    trajectory = weave(45, 60)
    truth = trajectory.increments(0.0, 0.02, 500)
    start = trajectory.state(0.0)

    def refused(times: np.ndarray, message: str) -> None:
        with pytest.raises(ValueError, match=message):
            motion_of_track(start, trajectory.track(times), truth)

    refused(0.5 * np.arange(1, 8), "7 rows: expected a multiple of 4")
    refused(1.0 + 0.5 * np.arange(1, 9), r"from 1\.5 to 5\.0 s.*after the increments' start, 0\.0")
    refused(0.5 * np.arange(1, 33), r"up to 16\.0 s: increments end at 10\.0 s")
