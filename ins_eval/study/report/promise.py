"""Which bench test told the truth, with ratios and their intervals, in words."""

from dataclasses import dataclass

TRUTHFUL = 2.0
"""A promise is kept when flown over promised lies, with its whole interval, within this factor of
1; broken when the whole interval lies outside; consistent when the figure lies within and the
interval reaches out; undecided otherwise."""

WORDS = {
    "true": f"told the truth within a factor of {TRUTHFUL:g}",
    "consistent": f"is consistent with the truth within a factor of {TRUTHFUL:g}",
    "too good": "is too optimistic",
    "too bad": "is too pessimistic",
    "undecided": "is not decided by this many triads",
}


@dataclass(frozen=True)
class Ratio:
    """Median of flown over promised radial error, with its 95 % interval."""

    value: float
    low: float
    high: float

    @property
    def word(self) -> str:
        """How well the promise was kept: a key of `WORDS`."""
        if self.low > TRUTHFUL:
            return "too good"
        if self.high < 1 / TRUTHFUL:
            return "too bad"
        if self.low >= 1 / TRUTHFUL and self.high <= TRUTHFUL:
            return "true"
        return "consistent" if 1 / TRUTHFUL <= self.value <= TRUTHFUL else "undecided"

    def __str__(self) -> str:
        return f"{self.value:.3g} (95 %: {self.low:.3g} to {self.high:.3g})"


def verdict(fixed: Ratio, circumference: Ratio) -> str:
    """The comparison in words."""
    return (
        f"{_headline(fixed, circumference)}\n"
        f"Full circumference {WORDS[circumference.word]}: flown over promised is {circumference}.\n"
        f"Fixed position {WORDS[fixed.word]}: flown over promised is {fixed}."
    )


def _headline(fixed: Ratio, circumference: Ratio) -> str:
    between = fixed.value / circumference.value
    factor = max(between, 1 / between)
    if factor <= TRUTHFUL:
        return f"The two tests agree: their promises differ by a factor of {factor:.2f}."
    tests = (("full-circumference", circumference), ("fixed-position", fixed))
    kept = [name for name, r in tests if r.word == "true"]
    open_ = [name for name, r in tests if r.word == "consistent"]
    broken = [name for name, r in tests if r.word in ("too good", "too bad")]
    if len(broken) == 2:
        return "Neither test told the truth."
    if kept and broken:
        return f"The {kept[0]} test told the truth; the {broken[0]} test did not."
    if open_ and broken:
        return (
            f"The {open_[0]} test is consistent with the truth; the {broken[0]} test is not. "
            "More triads would tell how close."
        )
    return "The tests differ, and this many triads do not decide between them."
