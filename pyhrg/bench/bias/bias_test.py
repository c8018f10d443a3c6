"""Bias stability and repeatability over runs, as the paper defines them (4.1)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.outcome import Finding, estimate_deviation, estimate_mean
from pyhrg.bench.readings.segments import Points
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG_PER_H

RUNS = 7
"""Number of power-ons of a test (paper 4.1, item 4)."""


@dataclass(frozen=True)
class BiasTest:
    """Runs of a bias test, with the power cycled between them.

    runs: data points of each run, means over 100 s.
    """

    runs: Sequence[Points]

    @property
    def means(self) -> list[float]:
        """Bias of each run, rad/s (paper 4.1, item 5)."""
        return [float(np.mean(run.rate)) for run in self.runs]

    @property
    def deviations(self) -> list[float]:
        """Standard deviation of each run's points, rad/s, n - 1 (paper 4.1, item 4)."""
        return [float(np.std(run.rate, ddof=1)) for run in self.runs]

    @property
    def bias(self) -> float:
        """Mean over the runs, rad/s."""
        return float(np.mean(self.means))

    @property
    def stability(self) -> float:
        """Bias stability, rad/s: mean over runs of the runs' standard deviations."""
        return float(np.mean(self.deviations))

    @property
    def repeatability(self) -> float:
        """Bias repeatability, rad/s: standard deviation over runs of the runs' means, n - 1."""
        return float(np.std(self.means, ddof=1))

    def findings(self) -> tuple[Finding, ...]:
        """Bias, stability and repeatability with intervals over runs."""
        return (
            estimate_mean("bias", self.means, "deg/h"),
            estimate_mean("bias stability", self.deviations, "deg/h"),
            estimate_deviation("bias repeatability", self.means, "deg/h"),
        )

    def table(self) -> Table:
        """Runs in the layout of the paper's Table 2."""
        figures = np.array([self.means, self.deviations]).T / DEG_PER_H
        rows = ((str(run), f"{m:.5f}", f"{d:.5f}") for run, (m, d) in enumerate(figures, 1))
        return Table("Runs, deg/h", ("run", "mean", "std. dev."), tuple(rows))
