import math

import numpy as np
import pytest

from pyhrg.common.robust import estimate_robust_deviation


def test_normal_numbers_have_their_standard_deviation() -> None:
    values = np.random.default_rng(1).normal(scale=3.0, size=100_000)
    assert estimate_robust_deviation(values) == pytest.approx(3.0, rel=0.02)


def test_a_few_others_move_it_by_next_to_nothing() -> None:
    values = np.random.default_rng(1).normal(size=100_000)
    values[:1000] = 1e6
    assert estimate_robust_deviation(values) == pytest.approx(1.0, rel=0.03)


def test_of_no_values_it_is_not_known() -> None:
    assert math.isnan(estimate_robust_deviation(np.zeros(0)))
