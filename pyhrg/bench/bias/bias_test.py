"""Bias stability and repeatability over runs, as the paper defines them (4.1)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.outcome import Finding, estimate_deviation, estimate_mean
from pyhrg.bench.readings.segments import Segments
from pyhrg.common.arrays import Array
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H

RUNS = 7
"""Number of power-ons of a test (paper 4.1, item 4)."""


@dataclass(frozen=True)
class BiasRun:
    """One power-on.

    points: (n,) means over 100 s, rad/s, without Earth's rate.
    """

    points: Array

    @property
    def mean(self) -> float:
        """Bias of the run, rad/s (paper 4.1, item 5)."""
        return float(np.mean(self.points))

    @property
    def deviation(self) -> float:
        """Standard deviation of the run's points, rad/s, n - 1 (paper 4.1, item 4)."""
        return float(np.std(self.points, ddof=1))


@dataclass(frozen=True)
class BiasTest:
    """Runs of a bias test, with the power cycled between them."""

    runs: tuple[BiasRun, ...]

    @property
    def bias(self) -> float:
        """Mean over the runs, rad/s."""
        return float(np.mean([run.mean for run in self.runs]))

    @property
    def stability(self) -> float:
        """Bias stability, rad/s: mean over runs of the runs' standard deviations."""
        return float(np.mean([run.deviation for run in self.runs]))

    @property
    def repeatability(self) -> float:
        """Bias repeatability, rad/s: standard deviation over runs of the runs' means, n - 1."""
        return float(np.std([run.mean for run in self.runs], ddof=1))

    def findings(self) -> tuple[Finding, ...]:
        """Bias, stability and repeatability with intervals over runs."""
        return (
            estimate_mean("bias", [run.mean for run in self.runs], "deg/h"),
            estimate_mean("bias stability", [run.deviation for run in self.runs], "deg/h"),
            estimate_deviation("bias repeatability", [run.mean for run in self.runs], "deg/h"),
        )

    def table(self) -> Table:
        """Runs in the layout of the paper's Table 2."""
        rows = [
            (str(number), f"{run.mean / DEG_PER_H:.5f}", f"{run.deviation / DEG_PER_H:.5f}")
            for number, run in enumerate(self.runs, 1)
        ]
        return Table("Runs, deg/h", ("run", "mean", "std. dev."), tuple(rows))


def summarize_runs(runs: Sequence[Segments]) -> BiasTest:
    """Bias test from the data points of each run."""
    return BiasTest(tuple(BiasRun(segments.rate) for segments in runs))
