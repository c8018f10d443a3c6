"""Bias against the resonator's temperature, the rate of the case's, and the pattern angle."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.bias.thermal.thermometer import Thermometer, filled, thermometer
from pyhrg.bench.bias.thermal_programme import SETTLE
from pyhrg.bench.estimation.harmonics import MEAN, Fit, fit
from pyhrg.bench.estimation.terms import PatternBasis, distinguishable, pattern_basis
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import tests_of
from pyhrg.bench.readings.dwells import Points, joined, points
from pyhrg.bench.readings.segments import WARM_UP
from pyhrg.common.units import MINUTE, ZERO_CELSIUS
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

Array = NDArray[np.float64]

KIND = "thermal"
STEADY = 0.05 / MINUTE
"""Soak: the case's temperature changes by less, K/s, and the resonator's is within `NEAR` of it."""
NEAR = 0.3
SAME = 3.0
"""Soaks closer than this are one temperature, K."""
LEAST_RANGE = 10.0
"""K."""
PER_KELVIN, PER_RATE = "bias per kelvin", "temperature-rate bias"


@dataclass(frozen=True)
class Soak:
    """Bias at one temperature, rad/s.

    mean: over the circumference where `whole`, else over where the pattern was.
    deviation: of the mean, by noise; freedom: degrees of freedom that it is known with.
    n: data points.
    """

    mean: float
    deviation: float
    freedom: int
    n: int
    whole: bool


@dataclass(frozen=True)
class Thermal:
    """Data points of all power-ons, and the fit.

    temperature: (n,) of the resonator above the reference, K.
    rate, warming: (n,) rate of the case's temperature, and of the resonator's, K/s.
    soak: (n,) temperature of the soak that the point belongs to, degC; NaN on a ramp.
    run: (n,) number of the power-on.
    """

    points: Points
    temperature: Array
    rate: Array
    warming: Array
    soak: Array
    run: NDArray[np.int64]
    thermometers: tuple[Thermometer, ...]
    basis: PatternBasis
    fitted: Fit
    refused: dict[str, str]

    @property
    def noise(self) -> float:
        """Standard deviation of a data point's noise, rad/s: of the fit's residual."""
        residual = self.fitted.residual
        return float(np.sqrt(residual @ residual / self.fitted.freedom))

    def of_pattern(self) -> Array:
        """(n,) part of the fit that depends on the pattern angle, rad/s."""
        columns = _columns(self.basis, self.temperature, self.rate, self.warming)
        turning = [n for n in self.fitted.names if n.endswith(tuple(self.basis.columns))]
        parts = [self.fitted.value(name) * columns[name] for name in turning]
        return np.asarray(np.sum(parts, axis=0) + np.zeros(len(self.points)))

    def soaks(self, run: int | None = None) -> dict[float, Soak]:
        """By temperature, degC, of one power-on or all."""
        mine = np.isfinite(self.soak) & ((self.run == run) | (run is None))
        levels = np.unique(self.soak[mine])
        return {float(t): _soak(self.points.part(mine & (self.soak == t))) for t in levels}


def _soak(found: Points) -> Soak:
    basis = pattern_basis(found.pattern_angle)
    if basis.angle is not None or len(found) < 6:
        deviation = np.std(found.rate, ddof=1) / np.sqrt(len(found)) if len(found) > 1 else np.nan
        return Soak(float(np.mean(found.rate)), float(deviation), len(found) - 1, len(found), False)
    fitted = fit({MEAN: np.ones(len(found)), **basis.columns}, found.rate)
    return Soak(fitted.value(MEAN), fitted.deviation(MEAN), fitted.freedom, len(found), True)


def measured(campaign: Campaign) -> Thermal:
    """Fit all thermal tests together.

    Raises:
        BenchError: the resonator's temperature changes by less than 10 K.
    """
    believed = campaign.nominal.get("thermal_lag_s")
    reference = campaign.nominal.get("reference_temperature_degC", 25.0) + ZERO_CELSIUS
    logs = [test.log for test in tests_of(campaign, KIND)]
    parts = [points(log, campaign.site.latitude, SETTLE, warm_up=WARM_UP) for log in logs]
    meters = tuple(thermometer(log, believed) for log in logs)
    warm, rates, warming, case = (
        np.concatenate(c) for c in zip(*map(_heat, logs, meters, parts), strict=True)
    )
    if np.ptp(warm) < LEAST_RANGE:
        names = ", ".join(log.source for log in logs)
        raise BenchError(
            f"{names}: the resonator's temperature changes by {np.ptp(warm):.3g} K; "
            f"the test needs at least {LEAST_RANGE:g} K"
        )
    found = joined(parts)
    steady = (np.abs(rates) < STEADY) & (np.abs(warm - case) < NEAR)
    basis = pattern_basis(found.pattern_angle)
    wanted = _columns(basis, warm - reference, rates, warming)
    columns, refused = distinguishable(wanted)
    run = np.repeat(np.arange(len(parts)), [len(p) for p in parts])
    soak = _soaks(case - ZERO_CELSIUS, steady)
    fitted = fit(columns, found.rate)
    return Thermal(
        found, warm - reference, rates, warming, soak, run, meters, basis, fitted, refused
    )


def _heat(log: Log, meter: Thermometer, part: Points) -> tuple[Array, ...]:
    """Of each point: resonator's temperature, case's rate, resonator's rate, case's temperature."""
    case = filled(log.temperature)
    rows = list(zip(part.first, part.last, strict=True))
    warm, mean = (
        np.array([np.mean(values[a : b + 1]) for a, b in rows])
        for values in (meter.temperature, case)
    )
    rate, warming = (
        np.asarray((values[part.last] - values[part.first]) / part.duration)
        for values in (case, meter.temperature)
    )
    return warm, rate, warming, mean


def _columns(basis: PatternBasis, warm: Array, rate: Array, warming: Array) -> dict[str, Array]:
    """Terms of the fit: map, temperature, its rate, and how the map changes with temperature.

    Pick-off gains that change while the resonator warms turn the detected angle: a bias that goes
    with the resonator's rate and a fourth harmonic, at one pattern angle a constant.
    """
    columns = {MEAN: np.ones_like(warm), **basis.columns, PER_KELVIN: warm, PER_RATE: rate}
    columns |= {f"{PER_KELVIN} {name}": warm * c for name, c in basis.columns.items()}
    columns["bias per kelvin squared"] = warm**2
    columns[f"{PER_RATE} per kelvin"] = rate * warm
    local = {} if basis.angle is None else {"at rest": np.ones_like(warm)}
    columns |= {f"warming {name}": warming * c for name, c in (local | basis.columns).items()}
    return columns | {f"per kelvin squared {n}": warm**2 * c for n, c in basis.columns.items()}


def _soaks(case: Array, steady: NDArray[np.bool_]) -> Array:
    """(n,) mean temperature of the points' soak, NaN where there is none."""
    order = np.argsort(case[steady])
    jumps = np.diff(case[steady][order], prepend=-np.inf) > SAME
    group = np.empty(len(order), dtype=int)
    group[order] = np.cumsum(jumps)
    soak = np.full(len(case), np.nan)
    means = {g: round(float(np.mean(case[steady][group == g])), 1) for g in np.unique(group)}
    soak[steady] = [means[g] for g in group]
    return soak
