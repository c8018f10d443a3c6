"""Temperature of the resonator from the case's: the loop frequency as thermometer finds the lag."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import optimize, signal

from pyhrg.records import Log

Array = NDArray[np.float64]

LAGS = (20.0, 7200.0)
"""Thermal lags that are looked for, s."""
SEEN = 0.999
"""Share of the frequency's variance that temperature explains where it is a thermometer."""


@dataclass(frozen=True)
class Thermometer:
    """Temperature of the resonator in a log.

    temperature: (n,) at the rows' ends, K.
    lag: behind the case, s; NaN where nothing shows it.
    frequency_per_kelvin: of the loop, rad/s/K; NaN likewise.
    note: where the lag is from.
    """

    temperature: Array
    lag: float
    frequency_per_kelvin: float
    note: str


def thermometer(log: Log, believed_lag: float | None = None) -> Thermometer:
    """Resonator's temperature of a first-order lag, equal to the case's at power-on.

    Args:
        log: one power-on, the case's temperature changes.
        believed_lag: taken where the loop frequency does not follow the temperature, s.
    """
    log.require("temperature", "frequency_offset")

    def misfit(lag: float) -> float:
        return _fit(log, lag)[1]

    best = optimize.minimize_scalar(misfit, bounds=LAGS, method="bounded")
    slope, unexplained = _fit(log, float(best.x))
    if unexplained < 1 - SEEN:
        lag = float(best.x)
        return Thermometer(lagged(log, lag), lag, slope, "by the loop frequency")
    if believed_lag:
        note = (
            "not seen: the loop frequency doesn't follow the temperature; the nominal lag is taken"
        )
        return Thermometer(lagged(log, believed_lag), np.nan, np.nan, note)
    note = "not known: the case's temperature is taken for the resonator's"
    return Thermometer(filled(log.temperature), np.nan, np.nan, note)


def lagged(log: Log, lag: float) -> Array:
    """(n,) temperature of a body that follows the case, linear within a row, with a lag, K."""
    case = filled(log.temperature)
    step = log.interval
    decay = np.exp(-step / lag)
    old, new = (1 - decay) * lag / step - decay, 1 - (1 - decay) * lag / step
    before = np.concatenate((case[:1], case[:-1]))
    driven = old * before + new * case
    return np.asarray(signal.lfilter([1.0], [1.0, -decay], driven, zi=[decay * case[0]])[0])


def _fit(log: Log, lag: float) -> tuple[float, float]:
    """Slope of frequency over lagged temperature, and the share of variance that is left."""
    ends = lagged(log, lag)
    means = (ends + np.concatenate((ends[:1], ends[:-1]))) / 2
    good = np.isfinite(log.frequency_offset)
    x, y = means[good], log.frequency_offset[good]
    x, y = x - np.mean(x), y - np.mean(y)
    if not np.any(x) or not np.any(y):
        return np.nan, 1.0
    slope = float(x @ y / (x @ x))
    return slope, float(np.sum((y - slope * x) ** 2) / np.sum(y**2))


def filled(values: Array) -> Array:
    """Linear through gaps."""
    known = np.isfinite(values)
    rows = np.arange(len(values))
    return np.asarray(np.interp(rows, rows[known], values[known]))
