"""Temperature of the resonator, which lags behind the case's; the loop frequency shows the lag."""

from dataclasses import dataclass

import numpy as np
from scipy import optimize, signal

from pyhrg.common.arrays import Array
from pyhrg.records import Log

LAG_BOUNDS = (20.0, 7200.0)
"""Range in which the thermal lag is searched, s."""
EXPLAINED_SHARE = 0.999
"""Smallest share (chosen) of the loop frequency's variance that the temperature must explain, for
the frequency to be used as a thermometer."""


@dataclass(frozen=True)
class Thermometer:
    """Temperature of the resonator in a log.

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
    """Temperature of the resonator: first-order lag, equal to the case's at power-on.

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
    case = fill_gaps(log.temperature)
    step = log.interval
    decay = np.exp(-step / lag)
    old, new = (1 - decay) * lag / step - decay, 1 - (1 - decay) * lag / step
    before = np.concatenate((case[:1], case[:-1]))
    driven = old * before + new * case
    return np.asarray(signal.lfilter([1.0], [1.0, -decay], driven, zi=[decay * case[0]])[0])


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
