"""Scale factor over temperature, from the spins of a temperature test."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.bias.thermal.thermometer import Thermometer
from pyhrg.bench.estimation.harmonics import MEAN, fit
from pyhrg.bench.estimation.spread import spread_finding
from pyhrg.bench.outcome import BenchError, Finding, pooled_deviation_finding
from pyhrg.bench.readings.spins import pair_scale_factor, pairs, spins
from pyhrg.common.units import ZERO_CELSIUS
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

Array = NDArray[np.float64]

SAME = 3.0
"""Pairs closer than this are one temperature, K."""
PER_KELVIN = "scale factor per kelvin"
OVER = "scale factor stability over temperature"
REPEATED = "scale factor repeatability over temperature"


def scale_factor_findings(
    campaign: Campaign, logs: Sequence[Log], thermometers: Sequence[Thermometer]
) -> tuple[tuple[Finding, ...], tuple[str, ...]]:
    """Slope, deviation over temperatures and within them, and what could not be had."""
    reference = campaign.nominal.get("reference_temperature_degC", 25.0) + ZERO_CELSIUS
    try:
        measured = [
            _pairs(log, meter, campaign.site.vertical_rate)
            for log, meter in zip(logs, thermometers, strict=True)
        ]
    except BenchError as error:
        text = f"no scale factor over temperature: {error}"
        missing = [(PER_KELVIN, "ppm/K"), (OVER, "ppm"), (REPEATED, "ppm")]
        return tuple(Finding(name, np.nan, unit, note=text) for name, unit in missing), (text,)
    warm, errors = (np.concatenate(column) for column in zip(*measured, strict=True))
    return _findings(warm - reference, errors), ()


def _pairs(log: Log, meter: Thermometer, vertical_rate: float) -> tuple[Array, Array]:
    """Resonator's temperature and scale-factor error of each pair of spins."""
    found = pairs(spins(log, vertical_rate), log.source)
    warm = [np.mean(meter.temperature[one.first : other.last + 1]) for one, other in found]
    return np.array(warm), np.array([pair_scale_factor(pair) for pair in found])


def _findings(warm: Array, errors: Array) -> tuple[Finding, ...]:
    group = np.cumsum(np.diff(np.sort(warm), prepend=-np.inf) > SAME)[np.argsort(np.argsort(warm))]
    groups = [errors[group == g] for g in np.unique(group)]
    within = np.concatenate([g - np.mean(g) for g in groups])
    freedom = len(errors) - len(groups)
    noise = float(np.sqrt(within @ within / freedom)) if freedom else np.nan
    means = [float(np.mean(g)) for g in groups]
    each = noise / np.sqrt(len(errors) / len(groups))
    over = spread_finding(OVER, means, each, freedom, "ppm", f"{len(groups)} soaks")
    repeated = pooled_deviation_finding(REPEATED, groups, "ppm", "pairs of spins at one soak")
    return (_slope(warm, errors), over, repeated)


def _slope(warm: Array, errors: Array) -> Finding:
    columns = {MEAN: np.ones_like(warm), PER_KELVIN: warm}
    if len(np.unique(np.round(warm))) < 2 or len(warm) < 3:
        return Finding(PER_KELVIN, np.nan, "ppm/K", note="one temperature, or two pairs of spins")
    line = fit(columns, errors)
    value, (low, high) = line.value(PER_KELVIN), line.interval(PER_KELVIN)
    return Finding(PER_KELVIN, value, "ppm/K", low, high, len(warm), "straight line")
