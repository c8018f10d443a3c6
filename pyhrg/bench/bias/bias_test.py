"""Bias stability and repeatability over runs, as the paper defines them (4.1)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd

from pyhrg.bench.outcome import Finding, estimate_deviation, estimate_mean
from pyhrg.bench.readings.segments import Points
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG, DEG_PER_H

RUNS = 7
"""Number of power-ons of a test (paper 4.1, item 4)."""
POINT_UNITS = {
    "run": "1",
    "position": "1",
    "time_s": "s",
    "pattern_angle_deg": "deg",
    "table_angle_deg": "deg",
    "bias_deg_per_h": "deg/h",
    "sigma_deg_per_h": "deg/h",
}
"""Units of the columns of a table of data points."""


@dataclass(frozen=True)
class BiasTest:
    """Runs of a bias test, with the power cycled between them.

    Attributes:
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

    def tabulate_points(self, within: Finding) -> pd.DataFrame:
        """The data points, 100 s means, with the columns of `POINT_UNITS`. The bias is the mean
        output rate less Earth's, its one-sigma the standard deviation within positions."""
        parts = [
            pd.DataFrame(
                {
                    "run": number,
                    "position": run.dwell - run.dwell[0] + 1,
                    "time_s": run.time,
                    "pattern_angle_deg": run.pattern_angle % np.pi / DEG,
                    "table_angle_deg": run.table_angle / DEG,
                    "bias_deg_per_h": run.rate / DEG_PER_H,
                }
            )
            for number, run in enumerate(self.runs, 1)
        ]
        frame = pd.concat(parts, ignore_index=True).assign(sigma_deg_per_h=within.value)
        frame.attrs["units"] = dict(POINT_UNITS)
        return frame

    def table(self) -> Table:
        """Runs in the layout of the paper's Table 2."""
        figures = np.array([self.means, self.deviations]).T / DEG_PER_H
        rows = ((str(run), f"{m:.5f}", f"{d:.5f}") for run, (m, d) in enumerate(figures, 1))
        return Table("Runs, deg/h", ("run", "mean", "std. dev."), tuple(rows))
