"""Whose the errors of a flight are: its budget."""

from dataclasses import dataclass

import pandas as pd
import xarray as xr

from ins_eval.error_model.budget.adjoint import Weights
from ins_eval.error_model.budget.sigma_budget import INITIAL

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
