"""The lead case in words: distances by the usual rule, and what is flown."""

import numpy as np
import pytest

from ins_eval.study.report.distances import format_distance, format_range
from ins_eval.study.report.lead_case import read_lead_case
from tests.ins_eval.study.report.synthetic import LEAD


def test_sentences_are_of_the_promises_and_the_flights() -> None:
    """0.0009 and 0.1 deg/h promise 0.09 and 10 nmi in an hour; flown are 2, 5 and 10 nmi."""
    case = read_lead_case({"lead": LEAD})
    assert case
    assert case.promised_fixed == pytest.approx(0.09 * 1852)
    assert case.promised_circumference == pytest.approx(10 * 1852)
    first, second, third = case.sentences
    assert (
        "is 5 nmi (9.3 km) off, the median of 3 flights from 2 to 10 nmi (3.7 to 19 km); the test "
        "at a fixed position promises 0.09 nmi" in case.headline
    )
    assert "the test over the full circumference 10 nmi (19 km)." in case.headline
    assert "0.0009 deg/h at a fixed position, which promises 0.09 nmi (0.17 km)" in first
    assert "promises 10 nmi (19 km)" in second
    assert (
        "err by 5 nmi (9.3 km), the median of flights from 2 to 10 nmi (3.7 to 19 km): 56 " in third
    )
    assert third.endswith("the circumference promises 2 times as much.")
    assert case.drawing.count('class="flight"') == 3


def test_the_medians_interval_is_of_order_statistics() -> None:
    """Of ten flights the second and the ninth (97.9 %); of three there is none."""
    flights = [[each] for each in np.arange(1.0, 11.0) * 1852]
    case = read_lead_case({"lead": LEAD | {"time_s": [3600.0], "flown_m": flights}})
    assert case
    assert case.median_interval == (2 * 1852, 9 * 1852)
    assert "the median (95 %: 2 to 9 nmi (3.7 to 17 km)) of flights" in case.sentences[2]
    few = read_lead_case({"lead": LEAD})
    assert few
    assert few.median_interval is None


def test_a_study_without_one() -> None:
    assert read_lead_case({"lead": {}}) is read_lead_case({}) is None
    assert format_distance(1852.0) == "1 nmi (1.9 km)"
    assert format_distance(185200.0) == "100 nmi (190 km)"
    assert format_distance(1.25 * 1852) == "1.3 nmi (2.3 km)"
    assert format_range(185.2, 1852.0) == "0.1 to 1 nmi (0.19 to 1.9 km)"
