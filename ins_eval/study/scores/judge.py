"""Whether an estimate meets a requirement, by its whole interval."""

import math

from ins_eval.study.scores.resampling import Estimate
from ins_eval.study.tables.score import FAILS, HOLDS, UNDECIDED


def judge_bounds(estimate: Estimate, low: float = -math.inf, high: float = math.inf) -> str:
    """The verdict on "from `low` to `high`": the whole interval is within, outside, or neither. An
    estimate without an interval is undecided."""
    if low <= estimate.low and estimate.high <= high:
        return HOLDS
    return FAILS if estimate.high < low or estimate.low > high else UNDECIDED


def judge_outside(estimate: Estimate, low: float, high: float) -> str:
    """The verdict on "below `low` or above `high`"."""
    opposite = {HOLDS: FAILS, FAILS: HOLDS, UNDECIDED: UNDECIDED}
    return opposite[judge_bounds(estimate, low, high)]


def judge_contains(estimate: Estimate, value: float) -> str:
    return HOLDS if estimate.low <= value <= estimate.high else FAILS
