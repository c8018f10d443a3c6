"""Scale factor over temperature, from the spins of a temperature test."""

from collections.abc import Sequence

import numpy as np

from pyhrg.bench.bias.thermal.thermometer import Thermometer
from pyhrg.bench.estimation.harmonics import MEAN, fit
from pyhrg.bench.estimation.spread import estimate_spread
from pyhrg.bench.outcome import BenchError, Finding, estimate_pooled_deviation
from pyhrg.bench.readings.spins import compute_scale_factor_error, find_spins, pair_spins
from pyhrg.common.arrays import Array
from pyhrg.common.units import ZERO_CELSIUS
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

SAME = 3.0
"""Smallest difference between the temperatures of two groups of pairs, K."""
PER_KELVIN = "scale factor per kelvin"
STABILITY = "scale factor stability over temperature"
REPEATABILITY = "scale factor repeatability over temperature"


def estimate_scale_factor(
    campaign: Campaign, logs: Sequence[Log], thermometers: Sequence[Thermometer]
) -> tuple[tuple[Finding, ...], tuple[str, ...]]:
    """Temperature coefficient of the scale factor, its standard deviations over soaks and within
    them, and warnings where the records don't give them."""
    reference = campaign.nominal.get("reference_temperature_degC", 25.0) + ZERO_CELSIUS
    try:
        measured = [
            _read_pairs(log, meter, campaign.site.vertical_rate)
            for log, meter in zip(logs, thermometers, strict=True)
        ]
    except BenchError as error:
        text = f"no scale factor over temperature: {error}"
        missing = [(PER_KELVIN, "ppm/K"), (STABILITY, "ppm"), (REPEATABILITY, "ppm")]
        return tuple(Finding(name, np.nan, unit, note=text) for name, unit in missing), (text,)
    warm, errors = (np.concatenate(column) for column in zip(*measured, strict=True))
    return _make_findings(warm - reference, errors), ()


def _read_pairs(log: Log, meter: Thermometer, vertical_rate: float) -> tuple[Array, Array]:
    """Temperature of the resonator, K, and scale-factor error of each pair of spins."""
    pairs = pair_spins(find_spins(log, vertical_rate), log.source)
    warm = [np.mean(meter.temperature[a.first : b.last + 1]) for a, b in pairs]
    return np.array(warm), np.array([compute_scale_factor_error(pair) for pair in pairs])


def _make_findings(warm: Array, errors: Array) -> tuple[Finding, ...]:
    group = np.cumsum(np.diff(np.sort(warm), prepend=-np.inf) > SAME)[np.argsort(np.argsort(warm))]
    groups = [errors[group == g] for g in np.unique(group)]
    within = np.concatenate([g - np.mean(g) for g in groups])
    freedom = len(errors) - len(groups)
    noise = float(np.sqrt(within @ within / freedom)) if freedom else np.nan
    means = [float(np.mean(g)) for g in groups]
    each = noise / np.sqrt(len(errors) / len(groups))
    over = estimate_spread(STABILITY, means, each, freedom, "ppm", f"{len(groups)} soaks")
    repeated = estimate_pooled_deviation(REPEATABILITY, groups, "ppm", "pairs of spins at one soak")
    return (_estimate_slope(warm, errors), over, repeated)


def _estimate_slope(warm: Array, errors: Array) -> Finding:
    columns = {MEAN: np.ones_like(warm), PER_KELVIN: warm}
    if len(np.unique(np.round(warm))) < 2 or len(warm) < 3:
        return Finding(PER_KELVIN, np.nan, "ppm/K", note="one temperature, or two pairs of spins")
    return fit(columns, errors).finding(PER_KELVIN, PER_KELVIN, "ppm/K", note="straight line")
