"""Which bench test told the truth, with ratios and their intervals, in words."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.metrics import median_interval

TRUTHFUL = 2.0
"""A promise is kept when flown over promised lies within this factor; it is broken when the whole
interval lies outside."""


@dataclass(frozen=True)
class Ratio:
    """Median flown over promised radial error, with its 95 % interval from order statistics.

    The promise counts as given: its own scatter over repeated benches is not in the interval.
    """

    value: float
    low: float
    high: float

    @property
    def word(self) -> str:
        """How well the promise was kept."""
        if self.low > TRUTHFUL:
            return "too good"
        if self.high < 1 / TRUTHFUL:
            return "too bad"
        if 1 / TRUTHFUL <= self.value <= TRUTHFUL:
            return "true"
        return "undecided"

    def __str__(self) -> str:
        return f"{self.value:.3g} (95 %: {self.low:.3g} to {self.high:.3g})"


def ratio(flown: NDArray[np.float64], promised: float) -> Ratio:
    """Of radial errors (n,) to the median that was promised."""
    low, high = median_interval(flown)
    return Ratio(float(np.median(flown)) / promised, low / promised, high / promised)


def verdict(fixed: Ratio, circumference: Ratio) -> str:
    """The comparison in words."""
    words = {
        "true": f"told the truth within a factor of {TRUTHFUL:g}",
        "too good": "promised too much",
        "too bad": "promised too little",
        "undecided": "is not decided by this many triads",
    }
    between = fixed.value / circumference.value
    factor = max(between, 1 / between)
    if factor <= TRUTHFUL:
        head = (
            f"The two tests agree: their promises differ by a factor of {factor:.2f}, "
            "so the pattern angle makes no difference to this gyro."
        )
    elif circumference.word == "true" and fixed.word == "too good":
        head = "The full-circumference test told the truth; the fixed-position test did not."
    elif fixed.word == "true":
        head = "The fixed-position test told the truth; the full-circumference test did not."
    else:
        head = "Neither test can be said to have told the truth."
    return (
        f"{head}\n"
        f"Full circumference {words[circumference.word]}: flown over promised is {circumference}.\n"
        f"Fixed position {words[fixed.word]}: flown over promised is {fixed}."
    )
