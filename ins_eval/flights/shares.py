"""Shares in the final error, by effect and axis."""

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ins_eval.flights.flown import Budget

ALIGNMENT = "alignment beyond its sensors' means"


@dataclass(frozen=True)
class Share:
    """north, east: contribution to the final position error, m."""

    effect: str
    axis: str
    north: float
    east: float

    def document(self) -> dict[str, str | float]:
        """The share as numbers with units in their names."""
        return {
            "effect": self.effect,
            "axis": self.axis,
            "north_contribution_m": self.north,
            "east_contribution_m": self.east,
        }


def list_shares(budget: Budget | None) -> list[Share]:
    """Shares that sum to the linear model's error; zero shares are left out."""
    if budget is None:
        return []
    contribution = budget.shares["contribution"].sum("time")
    found = [
        Share(str(effect), str(axis), *map(float, contribution.sel(effect=effect, axis=axis)))
        for effect in contribution["effect"].values
        for axis in contribution["axis"].values
    ]
    initial = budget.shares["initial"].sum("state").values
    found.append(Share(ALIGNMENT, "", *map(float, initial)))
    return [share for share in found if np.hypot(share.north, share.east) > 0]


def write_shares(found: list[Share], path: Path) -> None:
    """Write shares as CSV."""
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(Share("", "", 0.0, 0.0).document()), lineterminator="\n")
        writer.writeheader()
        writer.writerows(share.document() for share in found)
