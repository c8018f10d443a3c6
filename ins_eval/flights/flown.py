"""Flights of a plan: attitudes, positions, and whose the errors are."""

from collections.abc import Sequence
from dataclasses import dataclass

import pandas as pd
import xarray as xr

from ins_eval.alignment.result import Alignment
from ins_eval.error_model.budget.adjoint import Weights
from ins_eval.error_model.budget.sigma_budget import INITIAL
from ins_eval.flights.plan import Plan
from pyhrg.common.arrays import Array

COLUMNS = ("effect", "axis", "north_contribution_m", "east_contribution_m")


@dataclass(frozen=True)
class Budget:
    """Error budget of run 1.

    shares: contributions to the final error, as `error_model.budget` gives them; weights: the
    adjoint weights that they rest on.
    """

    shares: xr.Dataset
    weights: Weights

    @property
    def table(self) -> pd.DataFrame:
        """Contributions by effect and axis, which sum to the linear model's error; zeros left
        out."""
        contribution = self.shares["contribution"].sum("time")
        rows = [
            (str(effect), str(axis), *map(float, contribution.sel(effect=effect, axis=axis)))
            for effect in contribution["effect"].values
            for axis in contribution["axis"].values
        ]
        rows.append((INITIAL, "", *map(float, self.shares["initial"].sum("state").values)))
        return pd.DataFrame([row for row in rows if any(row[2:])], columns=list(COLUMNS))


@dataclass(frozen=True)
class FlightData:
    """Flights of a plan, compared with the truth if it is known.

    start: (3,) position at time 0: latitude, longitude (rad), height (m); alignments: one a run,
    none if the runs start from the truth; dataset: navigated states by run and time; where a truth
    is known, true states and errors; the linear model's one-sigma; for simulated IMUs, the
    navigator's own error; sigma_budget: of a log, the final one-sigma by effect and axis
    (`compute_sigma_budget`).
    """

    plan: Plan
    trajectory: str
    imu: str
    start: Array
    alignments: Sequence[Alignment]
    dataset: xr.Dataset
    budget: Budget | None = None
    sigma_budget: pd.DataFrame | None = None

    @property
    def title(self) -> str:
        """Trajectory, length, IMU, rate and height."""
        plan = self.plan
        minutes = plan.duration / 60
        length = f"{minutes / 60:.4g} h" if minutes >= 60 else f"{minutes:.4g} min"
        rate = f"{1 / plan.interval:.4g} Hz"
        return f"{self.trajectory}, {length}, {self.imu} at {rate}, height {plan.height}"
