"""Which bench test predicts the flown error, judged by the ratio of flown to predicted error."""

from dataclasses import dataclass

ACCURATE_FACTOR = 2.0
"""A prediction is accurate when the whole interval of flown over predicted is within this factor of
1. It is too optimistic or too pessimistic when the whole interval is outside. It is consistent when
only the value is within, and undecided otherwise. Chosen."""

JUDGEMENTS = {
    "true": f"predicts the error within a factor of {ACCURATE_FACTOR:g}",
    "consistent": f"is consistent with the flights within a factor of {ACCURATE_FACTOR:g}",
    "too good": "is too optimistic",
    "too bad": "is too pessimistic",
    "undecided": "cannot be judged with this many triads",
}
"""Sentences by the keys of validation.json."""


@dataclass(frozen=True)
class Ratio:
    """Median of flown over predicted horizontal error, with its 95 % interval."""

    value: float
    low: float
    high: float

    @property
    def judgement(self) -> str:
        """The key of `JUDGEMENTS` for this ratio."""
        if self.low > ACCURATE_FACTOR:
            return "too good"
        if self.high < 1 / ACCURATE_FACTOR:
            return "too bad"
        if self.low >= 1 / ACCURATE_FACTOR and self.high <= ACCURATE_FACTOR:
            return "true"
        within = 1 / ACCURATE_FACTOR <= self.value <= ACCURATE_FACTOR
        return "consistent" if within else "undecided"

    @property
    def sentence(self) -> str:
        """The judgement in words, without its subject."""
        return JUDGEMENTS[self.judgement]

    def __str__(self) -> str:
        return f"{self.value:.3g} (95 %: {self.low:.3g} to {self.high:.3g})"


def compare_tests(fixed: Ratio, circumference: Ratio) -> str:
    """The comparison of the two bench tests in words: a headline, and a line for each test."""
    return (
        f"{_make_headline(fixed, circumference)}\n"
        f"The full circumference {circumference.sentence}: flown over predicted is "
        f"{circumference}.\n"
        f"The fixed position {fixed.sentence}: flown over predicted is {fixed}."
    )


def _make_headline(fixed: Ratio, circumference: Ratio) -> str:
    quotient = fixed.value / circumference.value
    factor = max(quotient, 1 / quotient)
    if factor <= ACCURATE_FACTOR:
        return f"The two tests agree: their predictions differ by a factor of {factor:.2f}."
    tests = (("full-circumference", circumference), ("fixed-position", fixed))
    accurate = [name for name, r in tests if r.judgement == "true"]
    consistent = [name for name, r in tests if r.judgement == "consistent"]
    wrong = [name for name, r in tests if r.judgement in ("too good", "too bad")]
    if len(wrong) == 2:
        return "Neither test predicts the error."
    if accurate and wrong:
        return f"The {accurate[0]} test predicts the error; the {wrong[0]} test does not."
    if consistent and wrong:
        return (
            f"The {consistent[0]} test is consistent with the flights; the {wrong[0]} test is not. "
            "More triads would narrow the interval."
        )
    return "The tests differ, and this many triads do not decide between them."
