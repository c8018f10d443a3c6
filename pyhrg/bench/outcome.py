"""Outcome of a test procedure: findings with intervals, a verdict, warnings, a figure."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike
from scipy import stats

from pyhrg.common import units
from pyhrg.common.errors import HrgError
from pyhrg.common.pages.markup import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure  # slow, and needed where figures are drawn alone

UNITS = {
    "deg/h": units.DEG_PER_H,
    "deg/s": units.DEG,
    "deg": units.DEG,
    "arcsec": units.ARCSEC,
    "deg/sqrt(h)": units.DEG_PER_SQRT_H,
    "deg/h/sqrt(h)": units.DEG_PER_H / np.sqrt(units.HOUR),
    "deg/h/g": units.DEG_PER_H / units.STANDARD_GRAVITY,
    "deg/h/g^2": units.DEG_PER_H / units.STANDARD_GRAVITY**2,
    "deg/h/K": units.DEG_PER_H,
    "deg/h/(K/min)": units.DEG_PER_H * units.MINUTE,
    "deg/h/year": units.DEG_PER_H / units.YEAR,
    "ppm/K": 1e-6,
    "ppm/year": 1e-6 / units.YEAR,
    "Hz/K": 2 * np.pi,
    "ppm": 1e-6,
    "mHz": 2e-3 * np.pi,
    "Hz": 2 * np.pi,
    "mrad": 1e-3,
    "s": 1.0,
    "1/s": 1.0,
    "1": 1.0,
}
"""Value of a finding's unit in SI, by its name."""


class BenchError(HrgError):
    """The records can't give a result; the message says which, what was found, what is needed."""


@dataclass(frozen=True)
class Finding:
    """One figure of a test; `value` and `interval` are in its unit.

    Attributes:
        name: standard term, in lower case ("bias stability").
        si_value: the figure, SI; NaN where the records can't give it, and `note` says why.
        unit: unit in which the figure is printed, a key of `UNITS`.
        si_low, si_high: bounds of the 95 % interval, SI; NaN where there is none, and `note` says
            why.
        n: size of the sample that the interval is computed from.
        note: a remark; why there is no figure or no interval.
        at_least: whether a specification limits the figure from below, such as a range or a
            bandwidth.
    """

    name: str
    si_value: float
    unit: str
    si_low: float = np.nan
    si_high: float = np.nan
    n: int = 0
    note: str = ""
    at_least: bool = False

    @property
    def value(self) -> float:
        """The figure, in the finding's unit."""
        return self.si_value / UNITS[self.unit]

    @property
    def interval(self) -> tuple[float, float]:
        """Bounds of the 95 % interval in the finding's unit."""
        return self.si_low / UNITS[self.unit], self.si_high / UNITS[self.unit]

    @property
    def key(self) -> str:
        """Name with unit, as result.json and a specification have it: bias_stability_deg_per_h."""
        unit = self.unit.replace("/sqrt(h)", "_sqrt_h").replace("/", "_per_")
        unit = unit.translate(str.maketrans("", "", "()^"))
        suffix = "" if self.unit == "1" else f"_{unit.replace('1_per_', 'per_')}"
        return re.sub(r"\W+", "_", self.name) + suffix


@dataclass(frozen=True)
class Outcome:
    """Outcome of a procedure for a campaign.

    Attributes:
        findings: figures, each with a key of its own.
        verdict: meaning of the findings, in a sentence or two.
        tables: details, ready to be printed.
        warnings: effects that the plan or the records can't show, a sentence each.
        exclusions: rows and logs that were not used, and why, a sentence each.
        draw: function that draws the test's figure into an empty one; None where the test has none.
        values: further results for programs, SI, by name.
        points: data points of the figure, units in `attrs["units"]`; empty where the test has none.
    """

    findings: tuple[Finding, ...]
    verdict: str
    tables: tuple[Table, ...] = ()
    warnings: tuple[str, ...] = ()
    exclusions: tuple[str, ...] = ()
    draw: "Callable[[Figure], None] | None" = None
    values: dict[str, object] = field(default_factory=dict)
    points: pd.DataFrame = field(default_factory=pd.DataFrame)

    def __post_init__(self) -> None:
        keys = [finding.key for finding in self.findings]
        twice = sorted({key for key in keys if keys.count(key) > 1})
        if twice:
            raise ValueError(f"findings of one name: {', '.join(twice)}")

    def finding(self, name: str) -> Finding:
        """The finding of this name."""
        for finding in self.findings:
            if finding.name == name:
                return finding
        raise KeyError(name)


def estimate_mean(name: str, samples: ArrayLike, unit: str, note: str = "") -> Finding:
    """Mean of independent normal samples (n,), SI, with Student's 95 % interval."""
    values = np.asarray(samples, dtype=float)
    value, n = float(np.mean(values)), len(values)
    if n < 2:
        return Finding(name, value, unit, n=n, note=note or "one sample: no interval")
    reach = float(stats.t.ppf(0.975, n - 1) * np.std(values, ddof=1) / np.sqrt(n))
    return Finding(name, value, unit, value - reach, value + reach, n, note)


def estimate_deviation(name: str, samples: ArrayLike, unit: str, note: str = "") -> Finding:
    """Standard deviation (n - 1) of independent normal samples (n,), SI, with its chi-square 95 %
    interval."""
    values = np.asarray(samples, dtype=float)
    n = len(values)
    if n < 2:
        return Finding(name, np.nan, unit, n=n, note=note or f"{n} of at least 2 samples")
    value = float(np.std(values, ddof=1))
    high, low = stats.chi2.ppf([0.025, 0.975], n - 1)
    factors = np.sqrt((n - 1) / np.array([low, high]))
    return Finding(name, value, unit, value * factors[0], value * factors[1], n, note)


def estimate_pooled_deviation(
    name: str, groups: Sequence[ArrayLike], unit: str, note: str = ""
) -> Finding:
    """Standard deviation within groups of independent normal samples, SI, pooled over the groups,
    with its chi-square 95 % interval; a group of one sample contributes nothing."""
    values = [np.asarray(group, dtype=float) for group in groups]
    values = [group for group in values if len(group) > 1]
    n = sum(len(group) for group in values)
    freedom = n - len(values)
    if not freedom:
        return Finding(name, np.nan, unit, note=note or "no group of at least 2 samples")
    squares = sum(float(np.sum((group - np.mean(group)) ** 2)) for group in values)
    high, low = (float(q) for q in stats.chi2.ppf([0.025, 0.975], freedom))
    lower, value, upper = (float(np.sqrt(squares / divisor)) for divisor in (low, freedom, high))
    return Finding(name, value, unit, lower, upper, n, note)
