"""Bias under specific force, B = B0(th) + D(th) a + a' G(th) a, as far as the records tell.

What the tumble and the centrifuge share (IEEE Std 1431, g-sensitive drift; IEEE Std 529). th is the
pattern angle: specific force acts on gaps and axes of the shell, so that its bias has a constant
part and a fourth harmonic, each with its own coefficient. One pattern angle gives their sum there.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from pyhrg.bench.estimation.harmonics import MEAN, Fit, fit
from pyhrg.bench.estimation.terms import PatternBasis, distinguishable, pattern_basis
from pyhrg.bench.outcome import BenchError, Finding
from pyhrg.bench.procedure import exclusions_of, tests_of
from pyhrg.bench.readings.dwells import Points, joined, points
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.records.campaign import Campaign

Array = NDArray[np.float64]

AXES = "xyz"
SETTLE = 20.0
"""Time in a position before its first data point, s."""
STEADY = 0.02
"""Specific force of the same size to this share, throughout: gravity alone."""


@dataclass(frozen=True)
class Sensitivity:
    """Fit of bias against specific force and pattern angle.

    columns: of the fit, each (n,).
    refused: a sentence on each term that the records don't give, by name.
    """

    points: Points
    basis: PatternBasis
    columns: dict[str, Array]
    fitted: Fit
    refused: dict[str, str]

    def findings(self) -> tuple[Finding, ...]:
        """Every term but the bias map, NaN where it can't be had."""
        plain = [name for name in self.columns if name.startswith(("bias", "g "))]
        found = [self._finding(name) for name in plain]
        missing = [
            Finding(name, np.nan, _unit(name), note=text)
            for name, text in self.refused.items()
            if name.startswith("g ") and "cos4" not in name and "sin4" not in name
        ]
        mean = Finding(
            "bias",
            self.fitted.value(MEAN),
            "deg/h",
            *self.fitted.interval(MEAN),
            n=len(self.points),
            note=f"without specific force, {self.basis.place}",
        )
        return (mean, *found, *missing)

    def _finding(self, name: str) -> Finding:
        low, high = self.fitted.interval(name)
        n, note = len(self.points), "" if "4" in name else self.basis.place
        return Finding(name, self.fitted.value(name), _unit(name), low, high, n, note)


def measured(campaign: Campaign, kind: str) -> Sensitivity:
    """Fit all power-ons of a kind together.

    Raises:
        BenchError: fewer than three different specific forces, or too few data points.
    """
    logs = [test.log for test in tests_of(campaign, kind)]
    found = joined([points(log, campaign.site.latitude, SETTLE) for log in logs])
    different = len(np.unique(np.round(found.acceleration), axis=0))
    if different < 3:
        names = ", ".join(log.source for log in logs)
        raise BenchError(f"{names}: {different} different specific forces; at least 3 are needed")
    basis = pattern_basis(found.pattern_angle)
    force = force_columns(found.acceleration)
    wanted = {MEAN: np.ones(len(found)), **basis.columns, **force}
    if basis.angle is None:
        for name, column in force.items():
            wanted |= {f"{name} {p}": column * turn for p, turn in basis.columns.items()}
    columns, refused = distinguishable(wanted)
    return Sensitivity(found, basis, columns, fit(columns, found.rate), refused)


def force_columns(acceleration: Array) -> dict[str, Array]:
    """Linear and quadratic terms of (n, 3) specific forces, m/s2.

    Gravity alone has one size, so that the mean of the three squares' coefficients is part of the
    bias; what a tumble gives is how they differ.
    """
    linear = {f"g bias {axis}": column for axis, column in zip(AXES, acceleration.T, strict=True)}
    x, y, z = acceleration.T
    size = np.linalg.norm(acceleration, axis=1)
    if np.ptp(size) < STEADY * np.mean(size):
        squares = {"g squared zz over mean": z**2 - (x**2 + y**2) / 2}
        squares["g squared half xx less yy"] = x**2 - y**2
    else:
        squares = {"g squared xx": x**2, "g squared yy": y**2, "g squared zz": z**2}
    products = {"g squared xy": x * y, "g squared xz": x * z, "g squared yz": y * z}
    return linear | squares | products


def warnings(result: Sensitivity) -> tuple[str, ...]:
    """What the records don't give, one sentence each; fourth harmonics in one."""
    told = [s for name, s in result.refused.items() if "4" not in name and name.startswith("g ")]
    if result.basis.angle is not None:
        told.append(
            "the pattern hardly moved: sensitivities hold at its angle only, and what of them "
            "turns with the pattern can't be told from what does not"
        )
    return tuple(told)


def draw(figure: Figure, result: Sensitivity, title: str) -> None:
    """What each axis's specific force does to the bias, all else of the fit taken out."""
    panels = figure.subplots(1, 3, sharey=True)
    for axis, force, colour, panel in zip(
        AXES, result.points.acceleration.T, ("#0072B2", "#D55E00", "#009E73"), panels, strict=True
    ):
        own = [name for name in result.columns if _of_axis(name, axis)]
        part = sum((result.fitted.value(n) * result.columns[n] for n in own), np.zeros(len(force)))
        panel.plot(
            force / STANDARD_GRAVITY,
            (part + result.fitted.residual) / DEG_PER_H,
            ".",
            color=colour,
            ms=4,
        )
        order = np.argsort(force)
        panel.plot(force[order] / STANDARD_GRAVITY, part[order] / DEG_PER_H, "k-", lw=1)
        panel.set_xlabel(f"specific force along {axis}, g")
        panel.grid(alpha=0.3)
    panels[0].set_ylabel("bias by this axis, deg/h (line: fit)")
    figure.suptitle(title)


def _of_axis(name: str, axis: str) -> bool:
    """Terms of this axis alone that don't turn with the pattern."""
    return name in (f"g bias {axis}", f"g squared {axis}{axis}")


def _unit(name: str) -> str:
    return "deg/h/g^2" if name.startswith("g squared") else "deg/h/g"


def exclusions(campaign: Campaign, kinds: Sequence[str]) -> tuple[str, ...]:
    """Of the logs of these kinds."""
    return exclusions_of(tests_of(campaign, *kinds))
