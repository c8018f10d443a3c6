"""What comes of flights."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ins_eval.alignment.result import Alignment
from ins_eval.error_model.budget.adjoint import Weights
from ins_eval.flights.plan import Plan

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Budget:
    """Of run 1; shares: as `error_model.budget.budget` gives it; weights: that they rest on."""

    shares: xr.Dataset
    weights: Weights


@dataclass(frozen=True)
class Flown:
    """Flights of a plan, compared with the truth if it is known.

    start: (3,) position at time 0: latitude, longitude, rad, height, m; alignments: of each run,
    none if they start from the truth; dataset: as `results.flights` gives it: `against` a truth,
    `own_error` and `sigmas` of simulations, `navigated` alone if there is no truth.
    """

    plan: Plan
    trajectory: str
    imu: str
    start: Array
    alignments: Sequence[Alignment]
    dataset: xr.Dataset
    budget: Budget | None = None

    @property
    def title(self) -> str:
        """Trajectory, length, IMU, rate and height."""
        plan = self.plan
        minutes = plan.duration / 60
        length = f"{minutes / 60:.4g} h" if minutes >= 60 else f"{minutes:.4g} min"
        rate = f"{1 / plan.interval:.4g} Hz"
        return f"{self.trajectory}, {length}, {self.imu} at {rate}, height {plan.height}"
