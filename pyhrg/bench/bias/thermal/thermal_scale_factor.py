"""Scale factor over temperature, from the spins of a temperature test."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.bias.thermal.thermal_fit import Thermometer
from pyhrg.bench.estimation.harmonics import MEAN, fit
from pyhrg.bench.estimation.sizes import estimate_spread
from pyhrg.bench.outcome import BenchError, Finding, estimate_pooled_deviation
from pyhrg.bench.readings import turns
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.units import ZERO_CELSIUS
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

SAME = 3.0
"""Smallest difference between the temperatures of two groups of pairs, K."""
PER_KELVIN = "scale factor per kelvin"
STABILITY = "scale factor stability over temperature"
MEAN_STABILITY = "scale factor over temperature"
REPEATABILITY = "scale factor repeatability over temperature"
PHASES = np.exp(2j * np.pi / 3 * np.arange(3))
"""Phases of the fourth harmonic at which the scale factor is taken: the fewest evenly spaced ones
whose standard deviation is the harmonic's over the circumference."""


def estimate_scale_factor(
    campaign: Campaign, logs: Sequence[Log], thermometers: Sequence[Thermometer]
) -> tuple[tuple[Finding, ...], tuple[str, ...]]:
    """Temperature coefficient of the scale factor; its standard deviations over the circumference
    and soaks, of its mean over soaks, and within soaks; and warnings where the records don't give
    them."""
    reference = campaign.nominal.get("reference_temperature_degC", 25.0) + ZERO_CELSIUS
    try:
        measured = [
            _read_pairs(log, meter, campaign.site.vertical_rate)
            for log, meter in zip(logs, thermometers, strict=True)
        ]
    except BenchError as error:
        text = f"no scale factor over temperature: {error}"
        missing = [(PER_KELVIN, "ppm/K")]
        missing += [(name, "ppm") for name in (STABILITY, MEAN_STABILITY, REPEATABILITY)]
        return tuple(Finding(name, np.nan, unit, note=text) for name, unit in missing), (text,)
    warm, errors, harmonics = (np.concatenate(column) for column in zip(*measured, strict=True))
    return make_findings(warm - reference, errors, harmonics), ()


def _read_pairs(
    log: Log, meter: Thermometer, vertical_rate: float
) -> tuple[Array, Array, NDArray[np.complex128]]:
    """Temperature of the resonator, K, scale-factor error of each pair of spins, its harmonic."""
    pairs = turns.pair_spins(turns.find_spins(log, vertical_rate), log.source)
    warm = [np.mean(meter.temperature[a.first : b.last + 1]) for a, b in pairs]
    errors = [turns.compute_scale_factor_error(pair) for pair in pairs]
    harmonics = [turns.compute_scale_factor_harmonic(pair) for pair in pairs]
    return np.array(warm), np.array(errors), np.array(harmonics)


def make_findings(
    warm: Array, errors: Array, harmonics: NDArray[np.complex128]
) -> tuple[Finding, ...]:
    """Findings of n pairs of spins: temperatures above the reference, K, scale-factor errors and
    their fourth harmonics, (n,) each."""
    group = np.cumsum(np.diff(np.sort(warm), prepend=-np.inf) > SAME)[np.argsort(np.argsort(warm))]
    soaks = [group == g for g in np.unique(group)]
    freedom, pairs = len(errors) - len(soaks), len(errors) / len(soaks)
    mean_noise, harmonic_noise = (_pool(values, soaks) for values in (errors, harmonics))
    # variance of a soak's three values along the direction in which it is largest
    noise = np.sqrt(np.maximum(3 * mean_noise**2, 0.75 * harmonic_noise**2) / pairs)
    means = np.array([np.mean(errors[soak]) for soak in soaks])
    waves = np.array([np.mean(harmonics[soak]) for soak in soaks])
    around = (means[:, None] + (waves[:, None] * PHASES).real).ravel()
    over = f"over the circumference (fourth harmonic) and {len(soaks)} soaks"
    mean = f"mean over the circumference, {len(soaks)} soaks"
    return (
        _estimate_slope(warm, errors),
        estimate_spread(STABILITY, around, float(noise), freedom, "ppm", over),
        estimate_spread(MEAN_STABILITY, means, mean_noise / np.sqrt(pairs), freedom, "ppm", mean),
        estimate_pooled_deviation(
            REPEATABILITY, [errors[soak] for soak in soaks], "ppm", "pairs of spins at one soak"
        ),
    )


def _pool(values: NDArray[Any], soaks: Sequence[Mask]) -> float:
    """Scatter of values (n,), real or complex, within soaks (n,); NaN for one value a soak."""
    freedom = len(values) - len(soaks)
    square = sum(float(np.sum(np.abs(values[s] - np.mean(values[s])) ** 2)) for s in soaks)
    return float(np.sqrt(square / freedom)) if freedom else np.nan


def _estimate_slope(warm: Array, errors: Array) -> Finding:
    columns = {MEAN: np.ones_like(warm), PER_KELVIN: warm}
    if len(np.unique(np.round(warm))) < 2 or len(warm) < 3:
        return Finding(PER_KELVIN, np.nan, "ppm/K", note="one temperature, or two pairs of spins")
    return fit(columns, errors).finding(PER_KELVIN, PER_KELVIN, "ppm/K", note="straight line")
