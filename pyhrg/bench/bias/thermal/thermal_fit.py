"""Least-squares fit of the bias as a function of the resonator's temperature, the rate of change of
the case's temperature, and the pattern angle. The resonator's temperature lags behind the case's;
the loop frequency shows the lag.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

from pyhrg.bench.bias.thermal_programme import SETTLE
from pyhrg.bench.estimation.harmonics import MEAN, Fit, fit
from pyhrg.bench.estimation.terms import PatternBasis, choose_pattern_basis, select_separable
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import require_tests
from pyhrg.bench.readings.first_order_lag import follow_with_lag
from pyhrg.bench.readings.segments import WARM_UP, Points, join_points, read_points
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.units import MINUTE, ZERO_CELSIUS
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

LAG_BOUNDS = (20.0, 7200.0)
"""Range in which the thermal lag is searched, s."""
EXPLAINED_SHARE = 0.999
"""Smallest share (chosen) of the loop frequency's variance that the temperature must explain, for
the frequency to be used as a thermometer."""


@dataclass(frozen=True)
class Thermometer:
    """Temperature of the resonator in a log.

    Attributes:
        temperature: (n,) at the ends of the rows, K.
        lag: time constant behind the case, s; NaN where the record doesn't show it.
        frequency_per_kelvin: change of the loop frequency, rad/s/K; NaN where `lag` is.
        note: what the lag is taken from.
    """

    temperature: Array
    lag: float
    frequency_per_kelvin: float
    note: str


def estimate_temperature(log: Log, nominal_lag: float | None = None) -> Thermometer:
    """Estimate the resonator's temperature. It follows the case's temperature with a first-order
    lag, and equals it at power-on.

    The nominal lag, s, is used where the loop frequency does not follow the temperature.
    """
    log.require("temperature", "frequency_offset")

    def misfit(lag: float) -> float:
        return _fit_frequency(log, lag)[1]

    best = optimize.minimize_scalar(misfit, bounds=LAG_BOUNDS, method="bounded")
    slope, unexplained = _fit_frequency(log, float(best.x))
    if unexplained < 1 - EXPLAINED_SHARE:
        lag = float(best.x)
        return Thermometer(compute_lagged(log, lag), lag, slope, "by the loop frequency")
    if nominal_lag:
        note = "not visible: loop frequency doesn't follow the temperature; the nominal lag is used"
        return Thermometer(compute_lagged(log, nominal_lag), np.nan, np.nan, note)
    note = "unknown: the case's temperature is used for the resonator's"
    return Thermometer(fill_gaps(log.temperature), np.nan, np.nan, note)


def compute_lagged(log: Log, lag: float) -> Array:
    """(n,) temperature, K, that follows the case's, linear within a row, with a lag, s."""
    return follow_with_lag(fill_gaps(log.temperature), log.interval, lag)


def _fit_frequency(log: Log, lag: float) -> tuple[float, float]:
    """Slope of the loop frequency against the lagged temperature, and the unexplained share of its
    variance."""
    ends = compute_lagged(log, lag)
    means = (ends + np.concatenate((ends[:1], ends[:-1]))) / 2
    good = np.isfinite(log.frequency_offset)
    x, y = means[good], log.frequency_offset[good]
    x, y = x - np.mean(x), y - np.mean(y)
    if not np.any(x) or not np.any(y):
        return np.nan, 1.0
    slope = float(x @ y / (x @ x))
    return slope, float(np.sum((y - slope * x) ** 2) / np.sum(y**2))


def fill_gaps(values: Array) -> Array:
    """Values (n,) with gaps filled by linear interpolation."""
    known = np.isfinite(values)
    rows = np.arange(len(values))
    return np.asarray(np.interp(rows, rows[known], values[known]))


KIND = "thermal"
SOAK_RATE = 0.05 / MINUTE
"""Largest rate of the case's temperature in a soak, K/s."""
SOAK_DISTANCE = 0.3
"""Largest difference of the resonator's temperature from the case's in a soak, K."""
SOAK_SPACING = 3.0
"""Smallest difference between the temperatures of two soaks, K."""
SMALLEST_RANGE = 10.0
"""Smallest range of the resonator's temperature that the test takes, K."""
PER_KELVIN, PER_RATE = "bias per kelvin", "temperature-rate bias"


@dataclass(frozen=True)
class Soak:
    """Bias at one temperature.

    Attributes:
        mean: rad/s, over the circumference where `whole` is true, else over the data points.
        deviation: standard error of the mean, rad/s.
        freedom: degrees of freedom of `deviation`.
        n: number of data points.
    """

    mean: float
    deviation: float
    freedom: int
    n: int
    whole: bool


@dataclass(frozen=True)
class Thermal:
    """Data points of all power-ons, and the fit of the bias to them.

    Attributes:
        points: the n data points.
        temperature: (n,) temperature of the resonator above the reference temperature, K.
        rate, warming: (n,) rate of the case's and of the resonator's temperature, K/s.
        soak: (n,) temperature of the data point's soak, degC; NaN on a ramp.
        run: (n,) number of the data point's power-on.
        thermometers: temperature of the resonator in each power-on.
        basis: dependence on the pattern angle.
        refused: a sentence on each term that the records can't separate, by the term's name.
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
        """Standard deviation of a data point's noise, rad/s, from the residual of the fit."""
        residual = self.fitted.residual
        return float(np.sqrt(residual @ residual / self.fitted.freedom))

    def compute_map(self) -> Array:
        """(n,) part of the fitted bias that depends on the pattern angle, rad/s."""
        columns = _make_columns(self.basis, self.temperature, self.rate, self.warming)
        turning = [n for n in self.fitted.names if n.endswith(tuple(self.basis.columns))]
        parts = [self.fitted.value(name) * columns[name] for name in turning]
        return np.asarray(np.sum(parts, axis=0) + np.zeros(len(self.points)))

    def soaks(self, run: int | None = None) -> dict[float, Soak]:
        """Soaks by temperature, degC, of one power-on or of all."""
        chosen = np.isfinite(self.soak) & ((self.run == run) | (run is None))
        levels = np.unique(self.soak[chosen])
        masks = {float(level): chosen & (self.soak == level) for level in levels}
        return {level: _summarize_soak(self.points.part(mask)) for level, mask in masks.items()}


def _summarize_soak(points: Points) -> Soak:
    basis, n = choose_pattern_basis(points.pattern_angle), len(points)
    if basis.angle is not None or n < 6:
        deviation = np.std(points.rate, ddof=1) / np.sqrt(n) if n > 1 else np.nan
        return Soak(float(np.mean(points.rate)), float(deviation), n - 1, n, whole=False)
    fitted = fit({MEAN: np.ones(n), **basis.columns}, points.rate)
    return Soak(fitted.value(MEAN), fitted.deviation(MEAN), fitted.freedom, n, whole=True)


def fit_temperature(campaign: Campaign) -> Thermal:
    nominal_lag = campaign.nominal.get("thermal_lag_s")
    reference = campaign.nominal.get("reference_temperature_degC", 25.0) + ZERO_CELSIUS
    logs = [test.log for test in require_tests(campaign, KIND)]
    parts = [read_points(log, campaign.site, SETTLE, warm_up=WARM_UP) for log in logs]
    meters = tuple(estimate_temperature(log, nominal_lag) for log in logs)
    warm, rates, warming, case = (
        np.concatenate(c) for c in zip(*map(_read_temperatures, logs, meters, parts), strict=True)
    )
    if np.ptp(warm) < SMALLEST_RANGE:
        names = ", ".join(log.source for log in logs)
        raise BenchError(
            f"{names}: the resonator's temperature changes by {np.ptp(warm):.3g} K; "
            f"the test needs at least {SMALLEST_RANGE:g} K"
        )
    data = join_points(parts)
    steady = (np.abs(rates) < SOAK_RATE) & (np.abs(warm - case) < SOAK_DISTANCE)
    basis = choose_pattern_basis(data.pattern_angle)
    wanted = _make_columns(basis, warm - reference, rates, warming)
    columns, refused = select_separable(wanted)
    run = np.repeat(np.arange(len(parts)), [len(p) for p in parts])
    soak = _group_soaks(case - ZERO_CELSIUS, steady)
    fitted = fit(columns, data.rate)
    return Thermal(
        data, warm - reference, rates, warming, soak, run, meters, basis, fitted, refused
    )


def _read_temperatures(log: Log, meter: Thermometer, part: Points) -> tuple[Array, ...]:
    """For each data point: temperature of the resonator, K, rates of the case's and of the
    resonator's temperature, K/s, and temperature of the case, K."""
    rows, case = list(zip(part.first, part.last, strict=True)), fill_gaps(log.temperature)
    (warm, warming), (mean, rate) = (
        (
            np.array([np.mean(values[a : b + 1]) for a, b in rows]),
            np.asarray((values[part.last] - values[part.first]) / part.duration),
        )
        for values in (meter.temperature, case)
    )
    return warm, rate, warming, mean


def _make_columns(
    basis: PatternBasis, warm: Array, rate: Array, warming: Array
) -> dict[str, Array]:
    """Columns (n,) of the fit: bias map, temperature, its rate, and changes of the map with both.

    Pick-off gains that change while the resonator warms turn the detected angle. The bias from that
    is proportional to the rate of the resonator's temperature and to a fourth harmonic, which at
    one pattern angle is a constant.
    """
    columns = {MEAN: np.ones_like(warm), **basis.columns, PER_KELVIN: warm, PER_RATE: rate}
    columns |= {f"{PER_KELVIN} {name}": warm * c for name, c in basis.columns.items()}
    columns["bias per kelvin squared"] = warm**2
    columns[f"{PER_RATE} per kelvin"] = rate * warm
    local = {} if basis.angle is None else {"at rest": np.ones_like(warm)}
    columns |= {f"warming {name}": warming * c for name, c in (local | basis.columns).items()}
    return columns | {f"per kelvin squared {n}": warm**2 * c for n, c in basis.columns.items()}


def _group_soaks(case: Array, steady: Mask) -> Array:
    """(n,) mean temperature of each data point's soak, degC; NaN on a ramp."""
    order = np.argsort(case[steady])
    jumps = np.diff(case[steady][order], prepend=-np.inf) > SOAK_SPACING
    group = np.empty(len(order), dtype=int)
    group[order] = np.cumsum(jumps)
    soak = np.full(len(case), np.nan)
    means = {g: round(float(np.mean(case[steady][group == g])), 1) for g in np.unique(group)}
    soak[steady] = [means[g] for g in group]
    return soak
