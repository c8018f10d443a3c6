"""What a procedure returns: findings with intervals, a verdict, what was left out, a figure."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike
from scipy import stats

from pyhrg.common import units
from pyhrg.common.errors import HrgError
from pyhrg.common.pages.markup import Table

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
"""Units that findings are shown in: SI value = factor times shown value."""


class BenchError(HrgError):
    """The records can't give what was asked; says which, what was found and what is needed."""


@dataclass(frozen=True)
class Finding:
    """One figure of a test.

    name: the field's term, lower case ("bias stability").
    value: SI; NaN where the records can't give it, `note` says why.
    unit: to be shown in, one of `UNITS`.
    low, high: its 95 % interval, SI; NaN where there is none, `note` says why.
    n: sample size of the interval.
    at_least: a specification limits it from below, as a range or a bandwidth.
    """

    name: str
    value: float
    unit: str
    low: float = np.nan
    high: float = np.nan
    n: int = 0
    note: str = ""
    at_least: bool = False

    @property
    def shown(self) -> float:
        """Value in its unit."""
        return self.value / UNITS[self.unit]

    @property
    def interval_shown(self) -> tuple[float, float]:
        """95 % interval in its unit."""
        return self.low / UNITS[self.unit], self.high / UNITS[self.unit]

    @property
    def key(self) -> str:
        """Name with unit, as in a specification: bias_stability_deg_per_h."""
        unit = self.unit.replace("/sqrt(h)", "_sqrt_h").replace("/", "_per_")
        unit = unit.translate(str.maketrans("", "", "()^"))
        suffix = "" if self.unit == "1" else f"_{unit.replace('1_per_', 'per_')}"
        return re.sub(r"\W+", "_", self.name) + suffix


@dataclass(frozen=True)
class Outcome:
    """Result of a procedure.

    verdict: what the figures say, in a sentence or two.
    warnings: what the plan or the records can't see.
    exclusions: what was left out of the records, and why.
    draw: fills a figure; None where there is nothing to look at.
    values: what the procedure found beyond the findings, for programs (SI).
    """

    procedure: str
    findings: tuple[Finding, ...]
    verdict: str
    tables: tuple[Table, ...] = ()
    warnings: tuple[str, ...] = ()
    exclusions: tuple[str, ...] = ()
    draw: Callable[[Figure], None] | None = None
    values: dict[str, object] = field(default_factory=dict)

    def __post_init__(self) -> None:
        keys = [finding.key for finding in self.findings]
        twice = sorted({key for key in keys if keys.count(key) > 1})
        if twice:
            raise ValueError(f"{self.procedure}: findings of one name: {', '.join(twice)}")

    def finding(self, name: str) -> Finding:
        """By name."""
        for finding in self.findings:
            if finding.name == name:
                return finding
        raise KeyError(name)


def mean_finding(name: str, samples: ArrayLike, unit: str, note: str = "") -> Finding:
    """Mean of independent samples (n,) with Student's 95 % interval."""
    values = np.asarray(samples, dtype=float)
    value, n = float(np.mean(values)), len(values)
    if n < 2:
        return Finding(name, value, unit, n=n, note=note or "one sample: no interval")
    reach = float(stats.t.ppf(0.975, n - 1) * np.std(values, ddof=1) / np.sqrt(n))
    return Finding(name, value, unit, value - reach, value + reach, n, note)


def deviation_finding(name: str, samples: ArrayLike, unit: str, note: str = "") -> Finding:
    """Standard deviation (n - 1) of independent normal samples (n,), chi-square 95 % interval."""
    values = np.asarray(samples, dtype=float)
    n = len(values)
    if n < 2:
        return Finding(name, np.nan, unit, n=n, note=note or f"{n} of at least 2 samples")
    value = float(np.std(values, ddof=1))
    high, low = stats.chi2.ppf([0.025, 0.975], n - 1)
    factors = np.sqrt((n - 1) / np.array([low, high]))
    return Finding(name, value, unit, value * factors[0], value * factors[1], n, note)


def pooled_deviation_finding(
    name: str, groups: Sequence[ArrayLike], unit: str, note: str = ""
) -> Finding:
    """Standard deviation within groups of independent normal samples, chi-square 95 % interval;
    groups of one sample show none."""
    values = [np.asarray(group, dtype=float) for group in groups]
    values = [group for group in values if len(group) > 1]
    n = sum(len(group) for group in values)
    freedom = n - len(values)
    if not freedom:
        return Finding(name, np.nan, unit, note=note or "no group of at least 2 samples")
    squares = sum(float(np.sum((group - np.mean(group)) ** 2)) for group in values)
    high, low = (float(q) for q in stats.chi2.ppf([0.025, 0.975], freedom))
    least, value, most = (float(np.sqrt(squares / divisor)) for divisor in (low, freedom, high))
    return Finding(name, value, unit, least, most, n, note)
