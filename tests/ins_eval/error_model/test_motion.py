"""Means over the steps of a motion."""

import numpy as np
import pytest

from ins_eval.error_model.motion import step_mean


def test_means_are_exact_for_fifth_degree() -> None:
    time = np.arange(9) * 0.5
    expected = np.diff(np.array([0.0, 2.0, 4.0]) ** 6) / 6 / 2
    assert step_mean(time**5) == pytest.approx(expected, rel=1e-13)
