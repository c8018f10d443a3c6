"""Terms of a linear model: which of them the records can tell apart, and where on the pattern."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, MEAN, design, inflation
from pyhrg.common.units import DEG

Array = NDArray[np.float64]

SCATTER = 2
"""Data points beyond the terms, at least, to show the scatter."""
INSEPARABLE = 1000.0
"""A term whose variance the others inflate by more than this is not fitted. Less than that only
makes intervals wide; leaving the term out would make those of the others false."""
CURVED = 3 * DEG
"""A pattern that moves by more than this shows the curvature of its bias map, else the slope alone:
what is left out is less than 0.06 % of the map."""


@dataclass(frozen=True)
class PatternBasis:
    """How bias depends on the pattern angle: a fourth harmonic, as far as the records tell.

    columns: beside the mean, each (n,).
    angle: pattern angle that the mean holds at, rad; None where it is that of the circumference.
    """

    columns: dict[str, Array]
    angle: float | None

    @property
    def place(self) -> str:
        """Where figures hold, for a note."""
        if self.angle is None:
            return "mean over the circumference"
        return f"at a pattern angle of {self.angle / DEG:.1f} deg"


def pattern_basis(pattern_angle: Array) -> PatternBasis:
    """Fourth harmonic about zero where positions cover its period, else about the mean angle.

    sin 4(th - c) and 1 - cos 4(th - c) span, with a constant, the same fourth harmonic as sin 4th
    and cos 4th; the constant is then the bias at c, which a pattern that hardly moves does give.
    """
    columns = design(pattern_angle, pattern_angle, (4,), tilt=False)
    if max(inflation(columns).values()) <= LARGEST_INFLATION:
        return PatternBasis({name: columns[name] for name in columns if name != MEAN}, None)
    centre = float(np.mean(pattern_angle))
    off = 4 * (pattern_angle - centre)
    local = {"slope": np.sin(off)}
    if np.ptp(pattern_angle) > CURVED:
        local["curvature"] = 1 - np.cos(off)
    return PatternBasis(local, centre)


def distinguishable(columns: Mapping[str, Array]) -> tuple[dict[str, Array], dict[str, str]]:
    """Columns in order, each kept while all kept stay tellable from each other.

    Returns:
        Kept columns, and a sentence on each that is not.
    """
    kept: dict[str, Array] = {}
    refused: dict[str, str] = {}
    for name, column in columns.items():
        trial = {**kept, name: column}
        if len(trial) + SCATTER > len(column):
            refused[name] = f"{len(column)} data points are too few to fit {name} as well"
            continue
        worst = max(_inflations(trial).values())
        if np.isfinite(worst) and worst <= INSEPARABLE:
            kept[name] = column
        elif np.ptp(column) == 0.0:
            refused[name] = f"{name} can't be had: the records don't vary what it depends on"
        else:
            factor = f"{worst:.3g} times" if np.isfinite(worst) else "infinitely"
            refused[name] = (
                f"the records can't tell {name} from the other terms: variance inflated {factor}, "
                f"at most {INSEPARABLE:g} is accepted"
            )
    return kept, refused


def _inflations(columns: Mapping[str, Array]) -> dict[str, float]:
    """Factor by which the other columns inflate each one's variance, the mean's apart."""
    names = [name for name in columns if name != MEAN]
    if not names:
        return {MEAN: 1.0}
    matrix = np.column_stack([columns[name] - np.mean(columns[name]) for name in names])
    norms = np.linalg.norm(matrix, axis=0)
    sizes = np.array([np.linalg.norm(columns[name]) for name in names])
    if np.any(norms <= 1e-9 * sizes):
        return {MEAN: np.inf}
    correlation = (matrix / norms).T @ (matrix / norms)
    if np.linalg.cond(correlation) > 1e9:
        return {MEAN: np.inf}
    return dict(zip(names, np.diag(np.linalg.inv(correlation)), strict=True))
