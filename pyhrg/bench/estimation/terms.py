"""Choice of the terms of a linear model that the records can separate."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.estimation.harmonics import (
    LARGEST_INFLATION,
    MEAN,
    compute_inflations,
    make_columns,
)
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG

SCATTER_POINTS = 2
"""Data points that a fit must have beyond the number of its terms, so that the scatter shows."""
LARGEST_FITTED_INFLATION = 1000.0
"""Largest variance inflation factor (chosen) of a term that is fitted. A smaller inflation only
widens intervals, while a term left out would bias the others."""
CURVATURE_SPAN = 3 * DEG
"""Range of pattern angle, rad, above which the bias map is fitted with its curvature. Below it, a
straight line deviates from the map by less than 0.06 % of the map's amplitude."""


@dataclass(frozen=True)
class PatternBasis:
    """Basis functions for the bias against the pattern angle: a fourth harmonic.

    Attributes:
        columns: (n,) each, beside the constant one.
        angle: pattern angle, rad, at which the constant is the bias; None where the constant is the
            mean over the circumference.
    """

    columns: dict[str, Array]
    angle: float | None

    @property
    def place(self) -> str:
        """Pattern angle that the figures are for, in words."""
        if self.angle is None:
            return "mean over the circumference"
        return f"at a pattern angle of {self.angle / DEG:.1f} deg"


def choose_pattern_basis(pattern_angle: Array) -> PatternBasis:
    """Basis for the bias at pattern angles (n,), rad.

    Where the angles cover a period of the fourth harmonic, the functions are cos 4th and sin 4th.
    Elsewhere they are sin 4(th - c) and 1 - cos 4(th - c) about the mean angle c. With a constant
    they span the same fourth harmonic, and the constant is the bias at c, which even a pattern that
    hardly moves determines.
    """
    columns = make_columns(pattern_angle, pattern_angle, (4,), tilt=False)
    if max(compute_inflations(columns).values()) <= LARGEST_INFLATION:
        return PatternBasis({name: columns[name] for name in columns if name != MEAN}, None)
    centre = float(np.mean(pattern_angle))
    off = 4 * (pattern_angle - centre)
    local = {"slope": np.sin(off)}
    if np.ptp(pattern_angle) > CURVATURE_SPAN:
        local["curvature"] = 1 - np.cos(off)
    return PatternBasis(local, centre)


def select_separable(columns: Mapping[str, Array]) -> tuple[dict[str, Array], dict[str, str]]:
    """Columns (n,) that can be fitted together; each is added, in order, while all stay separable.

    Returns those that were added, and by name a sentence on each of the others.
    """
    accepted: dict[str, Array] = {}
    refused: dict[str, str] = {}
    for name, column in columns.items():
        trial = {**accepted, name: column}
        worst = _compute_largest_inflation(trial)
        if len(trial) + SCATTER_POINTS > len(column):
            refused[name] = f"{len(column)} data points are too few to fit {name} as well"
        elif worst <= LARGEST_FITTED_INFLATION:
            accepted[name] = column
        elif np.ptp(column) == 0.0:
            refused[name] = f"{name} has no value: the records don't vary what it depends on"
        else:
            factor = f"{worst:.3g} times" if np.isfinite(worst) else "infinitely"
            refused[name] = (
                f"the records can't separate {name} from the other terms: variance inflated "
                f"{factor}, at most {LARGEST_FITTED_INFLATION:g} is accepted"
            )
    return accepted, refused


def _compute_largest_inflation(columns: Mapping[str, Array]) -> float:
    """Largest variance inflation factor (centred) of the columns but the mean."""
    names = [name for name in columns if name != MEAN]
    if not names:
        return 1.0
    matrix = np.column_stack([columns[name] - np.mean(columns[name]) for name in names])
    norms = np.linalg.norm(matrix, axis=0)
    sizes = np.array([np.linalg.norm(columns[name]) for name in names])
    if np.any(norms <= 1e-9 * sizes):
        return np.inf
    correlation = (matrix / norms).T @ (matrix / norms)
    if np.linalg.cond(correlation) > 1e9:
        return np.inf
    return float(np.max(np.diag(np.linalg.inv(correlation))))
