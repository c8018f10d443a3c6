"""Promises kept and broken, in words."""

import pytest

from ins_eval.study.report.ratio_verdict import Ratio, compare_tests

RATIOS = {
    "true": Ratio(1.1, 0.8, 1.4),
    "consistent": Ratio(0.8, 0.45, 1.3),
    "too good": Ratio(100, 80, 120),
    "too bad": Ratio(0.1, 0.08, 0.13),
    "undecided": Ratio(4.4, 1.8, 9.0),
}


@pytest.mark.parametrize("fixed", RATIOS)
@pytest.mark.parametrize("circumference", RATIOS)
def test_headline_and_lines_agree(fixed: str, circumference: str) -> None:
    """The headline says of a test what its own line says, and nothing that its line does not."""
    assert {name: r.judgement for name, r in RATIOS.items()} == {name: name for name in RATIOS}
    headline = compare_tests(RATIOS[fixed], RATIOS[circumference]).splitlines()[0]
    for test, word in (("full-circumference", circumference), ("fixed-position", fixed)):
        if f"{test} test predicts the error" in headline:
            assert word == "true"
        if f"{test} test is consistent" in headline:
            assert word == "consistent"
        if f"{test} test does not" in headline or f"{test} test is not" in headline:
            assert word in ("too good", "too bad")
    if "Neither" in headline:
        assert {fixed, circumference} <= {"too good", "too bad"}


def test_verdict_of_the_paper() -> None:
    text = compare_tests(RATIOS["too good"], RATIOS["true"])
    assert text.startswith("The full-circumference test predicts the error; the fixed-position")
    agreeing = compare_tests(Ratio(1.2, 0.9, 1.5), Ratio(1.0, 0.8, 1.3))
    assert agreeing.startswith("The two tests agree")


@pytest.mark.parametrize(
    ("ratio", "word"),
    [
        (Ratio(3.0, 2.1, 4.0), "too good"),
        (Ratio(0.3, 0.2, 0.4), "too bad"),
        (Ratio(1.5, 0.8, 2.5), "consistent"),
        (Ratio(1.2, 0.6, 1.9), "true"),
        (Ratio(2.4, 1.8, 3.0), "undecided"),
    ],
)
def test_ratio_in_a_word(ratio: Ratio, word: str) -> None:
    assert ratio.judgement == word
