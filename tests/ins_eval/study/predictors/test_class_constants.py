"""Constants of classes: on other triads of the same kind they give the median and the interval."""

import numpy as np
import pytest
from scipy.stats import binom

from ins_eval.study.predictors.class_constants import compute_constant, predict
from tests.ins_eval.study.predictors import cases, flights

COUNT = 1000
WEIGHTS = cases.mission(seed=5)


@pytest.mark.parametrize("share", [0.05, 0.5, 0.95])
def test_quantiles_hold_their_share_of_other_triads(share: float) -> None:
    """The constant comes from 400 triads, whose sampling error doubles the binomial's variance at
    the most; one in 10^5 outside."""
    ratios = cases.class_ratios(cases.triads(seed=1, count=400), WEIGHTS)["circumference_class"]
    others = cases.triads(seed=2, count=COUNT)
    predicted = predict(ratios, others.circumference_stability, WEIGHTS.time).radius(share)
    inside = int(np.sum(flights.radial(others, WEIGHTS) <= predicted))
    effective = COUNT // 4
    low, high = binom.ppf(5e-6, effective, share), binom.isf(5e-6, effective, share)
    assert low / effective <= inside / COUNT <= high / effective


def test_missions_of_a_class_count_alike() -> None:
    ratios = np.concatenate([np.full((3, 4), 1.0), np.full((3, 4), 3.0)], axis=1)
    assert compute_constant(ratios) == 2.0
