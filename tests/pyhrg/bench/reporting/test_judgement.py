"""A specification is met or failed only where the whole interval says so."""

import math

import pytest

from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.reporting.judgement import Judgement, describe_unmatched_limits, judge_findings
from pyhrg.common.units import DEG_PER_H

NAN, INF = math.nan, math.inf


def finding(value: float, low: float, high: float, at_least: bool = False) -> Finding:
    scaled = (x * DEG_PER_H for x in (value, low, high))
    return Finding("bias stability", *[next(scaled), "deg/h", *scaled], at_least=at_least)


@pytest.mark.parametrize(
    ("value", "low", "high", "word"),
    [
        (0.5, 0.4, 0.9, "meets"),
        (-0.5, -0.9, -0.4, "meets"),
        (0.0, -0.9, 0.9, "meets"),
        (0.0, -1.1, 0.1, "not decided"),
        (0.9, 0.8, 1.1, "not decided"),
        (1.1, 0.9, 1.3, "not decided"),
        (1.2, 1.1, 1.3, "fails"),
        (-1.2, -1.3, -1.1, "fails"),
        (1.2, 1.1, INF, "fails"),
        (0.5, NAN, NAN, "not decided"),
        (0.5, 0.4, NAN, "not decided"),
        (NAN, NAN, NAN, "not measured"),
    ],
)
def test_at_most(value: float, low: float, high: float, word: str) -> None:
    assert Judgement(finding(value, low, high), 1.0).word == word


@pytest.mark.parametrize(
    ("value", "low", "high", "word"),
    [
        (1.2, 1.1, 1.3, "meets"),
        (1.2, 1.1, INF, "meets"),
        (-1.2, -1.3, -1.1, "meets"),
        (1.2, 0.9, 1.3, "not decided"),
        (0.0, -1.1, 1.1, "not decided"),
        (0.5, 0.4, 0.9, "fails"),
        (0.5, NAN, NAN, "not decided"),
    ],
)
def test_at_least(value: float, low: float, high: float, word: str) -> None:
    assert Judgement(finding(value, low, high, at_least=True), 1.0).word == word


def test_sentence_has_value_interval_limit_and_word() -> None:
    expected = "bias_stability_deg_per_h 0.50 (0.40 to 0.90), at most 1: meets"
    assert str(Judgement(finding(0.5, 0.4, 0.9), 1.0)) == expected
    expected = "bias_stability_deg_per_h 0.5, at most 1: not decided"
    assert str(Judgement(finding(0.5, NAN, NAN), 1.0)) == expected


def test_only_findings_that_are_limited_are_judged() -> None:
    outcome = Outcome((finding(0.5, 0.4, 0.9), Finding("bias", 1.0, "deg/h")), "")
    limits = {"bias_stability_deg_per_h": 1.0, "range_deg_per_s": 300.0}
    assert [j.finding.name for j in judge_findings(outcome, limits)] == ["bias stability"]
    (sentence,) = describe_unmatched_limits([outcome], limits)
    assert sentence.startswith("range_deg_per_s: not judged")
    (sentence,) = describe_unmatched_limits([outcome], {"bias_stabilty_deg_h": 1.0})
    assert sentence.endswith("the closest is bias_stability_deg_per_h")


def test_two_findings_of_one_key_are_a_mistake() -> None:
    twice = (Finding("bias, at 8 x 22.5 deg", 1.0, "deg/h"),) * 2
    assert twice[0].key == "bias_at_8_x_22_5_deg_deg_per_h"
    with pytest.raises(ValueError, match="findings of one name"):
        Outcome(twice, "")
