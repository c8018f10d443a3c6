"""Sensitivity of the bias to specific force: B = B0(th) + D(th) a + a' G(th) a.

Tumble and centrifuge share this fit (IEEE Std 1431, g-sensitive drift; IEEE Std 529). Specific
force a changes the gaps and the axes of the shell, so that each coefficient has a constant part and
a fourth harmonic of the pattern angle th. Records at one pattern angle give their sum only.
"""

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.estimation.harmonics import MEAN, Fit, fit
from pyhrg.bench.estimation.terms import PatternBasis, choose_pattern_basis, select_separable
from pyhrg.bench.figures import COLOURS
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import require_tests
from pyhrg.bench.readings.segments import Points, join_points, read_points
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.records.campaign import Campaign

AXES = "xyz"
SETTLE = 20.0
"""Time in a position before its first data point, s."""
SIZE_TOLERANCE = 0.02
"""Largest relative range of the specific force's magnitude at which gravity alone acts."""


@dataclass(frozen=True)
class Sensitivity:
    """Fit of the bias by specific force and pattern angle.

    Attributes:
        points: the n data points.
        basis: dependence on the pattern angle.
        columns: (n,) each, of the fitted terms.
        refused: a sentence on each term that the records don't determine, by the term's name.
    """

    points: Points
    basis: PatternBasis
    columns: dict[str, Array]
    fitted: Fit
    refused: dict[str, str]

    def findings(self) -> tuple[Finding, ...]:
        """Bias and its sensitivities; NaN for a sensitivity that the records don't determine."""
        note = f"without specific force, {self.basis.place}"
        fitted = (
            self.fitted.finding(n, n, _choose_unit(n), note="" if "4" in n else self.basis.place)
            for n in self.columns
            if n.startswith("g ")
        )
        bias = self.fitted.finding(MEAN, "bias", "deg/h", note=note)
        return (bias, *fitted, *self.missing)

    @property
    def missing(self) -> list[Finding]:
        """The sensitivities, harmonics apart, that the records don't determine, and why."""
        return [
            Finding(name, np.nan, _choose_unit(name), note=text)
            for name, text in self.refused.items()
            if name.startswith("g ") and "4" not in name
        ]


def fit_sensitivity(campaign: Campaign, kind: str) -> Sensitivity:
    """Fit of all power-ons of a kind together."""
    logs = [test.log for test in require_tests(campaign, kind)]
    data = join_points([read_points(log, campaign.site, SETTLE) for log in logs])
    different = len(np.unique(np.round(data.acceleration), axis=0))
    if different < 3:
        names = ", ".join(log.source for log in logs)
        raise BenchError(f"{names}: {different} different specific forces; at least 3 are needed")
    basis = choose_pattern_basis(data.pattern_angle)
    force = make_force_columns(data.acceleration)
    wanted = {MEAN: np.ones(len(data)), **basis.columns, **force}
    if basis.angle is None:
        for name, column in force.items():
            wanted |= {f"{name} {p}": column * turn for p, turn in basis.columns.items()}
    columns, refused = select_separable(wanted)
    return Sensitivity(data, basis, columns, fit(columns, data.rate), refused)


def make_force_columns(acceleration: Array) -> dict[str, Array]:
    """Columns (n,) of linear and quadratic terms from specific forces (n, 3), m/s2.

    Under gravity alone the magnitude is constant, so that the mean of the three squares'
    coefficients can't be separated from the bias. The columns are then differences of squares.
    """
    linear = {f"g bias {axis}": column for axis, column in zip(AXES, acceleration.T, strict=True)}
    x, y, z = acceleration.T
    size = np.linalg.norm(acceleration, axis=1)
    if np.ptp(size) < SIZE_TOLERANCE * np.mean(size):
        squares = {"g squared zz over mean": z**2 - (x**2 + y**2) / 2}
        squares["g squared half xx less yy"] = x**2 - y**2
    else:
        squares = {"g squared xx": x**2, "g squared yy": y**2, "g squared zz": z**2}
    products = {"g squared xy": x * y, "g squared xz": x * z, "g squared yz": y * z}
    return linear | squares | products


def make_outcome(result: Sensitivity, title: str, verdict: str) -> Outcome:
    """Bias and its sensitivity to specific force."""
    warnings = [finding.note for finding in result.missing]
    if result.basis.angle is not None:
        warnings.append(
            "the pattern hardly moved: sensitivities are those at its angle, and their constant "
            "part can't be separated from their fourth harmonic"
        )
    return Outcome(
        findings=result.findings(),
        verdict=verdict,
        warnings=tuple(warnings),
        draw=lambda figure: draw(figure, result, title),
        values={"terms": result.fitted.terms},
    )


def draw(figure: Figure, result: Sensitivity, title: str) -> None:
    """Draw the bias against each axis's specific force, without the other terms of the fit."""
    panels = figure.subplots(1, 3, sharey=True)
    for axis, force, colour, panel in zip(
        AXES, result.points.acceleration.T / STANDARD_GRAVITY, COLOURS, panels, strict=False
    ):
        own = [n for n in (f"g bias {axis}", f"g squared {axis}{axis}") if n in result.columns]
        part = sum((result.fitted.value(n) * result.columns[n] for n in own), np.zeros(len(force)))
        panel.plot(force, (part + result.fitted.residual) / DEG_PER_H, ".", color=colour, ms=4)
        order = np.argsort(force)
        panel.plot(force[order], part[order] / DEG_PER_H, "k-", lw=1)
        panel.set_xlabel(f"specific force along {axis}, g")
        panel.grid(alpha=0.3)
    panels[0].set_ylabel("bias by this axis, deg/h (line: fit)")
    figure.suptitle(title)


def _choose_unit(name: str) -> str:
    return "deg/h/g^2" if name.startswith("g squared") else "deg/h/g"
