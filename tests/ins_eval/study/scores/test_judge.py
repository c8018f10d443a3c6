"""Verdicts by whole intervals."""

import math

import pytest

from ins_eval.study.scores.judge import judge_bounds, judge_contains, judge_outside
from ins_eval.study.scores.resampling import Estimate


@pytest.mark.parametrize(
    ("low", "high", "verdict"),
    [(0.8, 1.2, "holds"), (0.7, 1.2, "undecided"), (1.4, 2.0, "fails"), (0.1, 0.5, "fails")],
)
def test_bounds(low: float, high: float, verdict: str) -> None:
    estimate = Estimate((low + high) / 2, low, high)
    assert judge_bounds(estimate, 1 / 1.3, 1.3) == verdict
    opposite = {"holds": "fails", "fails": "holds", "undecided": "undecided"}
    assert judge_outside(estimate, 1 / 1.3, 1.3) == opposite[verdict]


def test_no_interval_decides_nothing() -> None:
    none = Estimate(math.nan, math.nan, math.nan)
    assert judge_bounds(none, 0.97) == judge_outside(none, 0.5, 2.0) == "undecided"


def test_contained_value() -> None:
    assert judge_contains(Estimate(0.1, -0.1, 0.3), 0.0) == "holds"
    assert judge_contains(Estimate(0.2, 0.1, 0.3), 0.0) == "fails"
