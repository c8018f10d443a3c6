"""Bias and scale factor over three temperatures and the ramps between them."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import (
    FAST,
    Intervals,
    against,
    pair_noise,
    quiet,
    rate_noise,
)
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.thermal import full_temperature
from pyhrg.bench.bias.thermal.thermal_fit import Thermal, fit_temperature
from pyhrg.bench.bias.thermal.thermal_scale_factor import MEAN_STABILITY, REPEATABILITY
from pyhrg.bench.bias.thermal_programme import make_programme
from pyhrg.bench.estimation.terms import choose_pattern_basis
from pyhrg.bench.readings.turns import compute_scale_factor_error, find_spins, pair_spins
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H, MINUTE
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"
SOAKS = (0.0, 25.0, 50.0)
ROW = 4.0
"""s: fewer rows, a cheaper repeat."""
BRYAN = "resonator.material.bryanFactorPerKelvin"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Two power-ons."""
    device = warm(np.random.default_rng(seed))
    bench = Bench(fmu, device, seed, step=1.0)
    course = make_programme(bench, SOAKS, ROW)
    tests = bench.run([PowerOn(f"thermal_{n}", full_temperature.KIND, course) for n in (1, 2)])
    outcome = full_temperature.evaluate(bench.campaign(tests))
    without = replace(bench, device=quiet(device))
    mean = without.campaign([without.log(PowerOn(t.id, t.kind, course)) for t in tests])
    return against(outcome, {**truths(device), **of_bias(device, mean), **of_scale(device, mean)})


def warm(generator: np.random.Generator) -> Device:
    """A gyro whose parameters change with temperature."""
    change = generator.standard_normal(6)
    return replace(
        TYPICAL.another(generator),
        decay_time_per_kelvin=-1e-3 * abs(change[0]),
        damping_anisotropy_per_kelvin=1e-3 * change[1],
        phase_per_kelvin=1e-6 * change[2],
        pickoff_gain_per_kelvin=1e-7 * change[3],
        bias_per_temperature_rate=3e-3 * DEG_PER_H * MINUTE * change[4],
        frequency_per_kelvin=85e-6,
        model={**FAST, BRYAN: 5e-7 * change[5]},
    )


def at(device: Device, kelvin: float) -> Device:
    """The gyro at a temperature above the reference."""
    warmth = 1 + device.damping_anisotropy_per_kelvin * kelvin
    return replace(
        device,
        decay_time=device.decay_time * (1 + device.decay_time_per_kelvin * kelvin),
        damping_anisotropy=device.damping_anisotropy * warmth,
        phase_error=device.phase_error + device.phase_per_kelvin * kelvin,
        pickoff_gain_mismatch=device.pickoff_gain_mismatch
        + device.pickoff_gain_per_kelvin * kelvin,
    )


def truths(device: Device) -> dict[str, float]:
    """Derivatives of the closed forms at the reference temperature, Earth's rate included."""
    hot, cold = at(device, 1.0), at(device, -1.0)
    map_change = (theory.static_bias_phasor(hot) - theory.static_bias_phasor(cold)) / 2
    earth, soaks = device.site.vertical_rate, np.array(SOAKS) - 25.0
    scale = np.array([scale_factor_error(device, t) for t in soaks])
    per_kelvin = (theory.mean_bias(hot) - theory.mean_bias(cold)) / 2
    of_scale = (scale_factor_error(device, 1.0) - scale_factor_error(device, -1.0)) / 2
    return {
        "bias per kelvin": per_kelvin + of_scale * earth,
        "bias per kelvin cos4": map_change.real - device.pickoff_gain_per_kelvin * earth,
        "bias per kelvin sin4": map_change.imag,
        "temperature-rate bias": device.bias_per_temperature_rate,
        "scale factor per kelvin": float(np.polyfit(soaks, scale, 1)[0]),
    }


def scale_factor_error(device: Device, kelvin: float) -> float:
    """At a temperature above the reference."""
    tau = at(device, kelvin).decay_time
    hold = theory.hold_scale_factor_error(device.control_period, 0.0, tau)
    return device.model[BRYAN] * kelvin + hold


def of_bias(device: Device, mean: Campaign) -> dict[str, float]:
    """Deviations of the bias: of the tests without noise, and of the noise of each figure."""
    result = fit_temperature(mean)
    noise = np.array([rate_noise(device, seconds) for seconds in result.points.duration])
    levels = np.unique(result.soak[np.isfinite(result.soak)])
    alone = [[result.soaks(run)[level].mean for run in (0, 1)] for level in levels]
    once = np.mean([_soak_variance(result, noise, t, result.run == 0) for t in levels])
    both = np.mean([_soak_variance(result, noise, t, result.run >= 0) for t in levels])
    soaks = [soak.mean for soak in result.soaks().values()]
    rates = result.points.rate
    return {
        "bias stability over temperature": _root(np.var(rates, ddof=1), np.mean(noise**2)),
        "bias over temperature": _root(np.var(soaks, ddof=1), both),
        "bias repeatability over temperature": _root(np.mean(np.var(alone, 1, ddof=1)), once),
    }


def _soak_variance(result: Thermal, noise: Array, level: float, of_run: Array) -> float:
    """Of a soak's mean, which is that of a fit by pattern angle."""
    mine = (result.soak == level) & (of_run > 0)
    part = result.points.part(mine)
    columns = [np.ones(len(part)), *choose_pattern_basis(part.pattern_angle).columns.values()]
    weights = np.linalg.pinv(np.column_stack(columns))[0]
    return float(weights**2 @ noise[mine] ** 2)


def of_scale(device: Device, mean: Campaign) -> dict[str, float]:
    """Deviations of the scale factor, likewise; soaks in order, the same number of pairs each."""
    logs, earth = [test.log for test in mean.tests], device.site.vertical_rate
    errors = np.array(
        [
            [compute_scale_factor_error(p) for p in pair_spins(find_spins(log, earth), log.source)]
            for log in logs
        ]
    )
    soaks = errors.reshape(len(logs), len(SOAKS), -1).swapaxes(0, 1).reshape(len(SOAKS), -1)
    noise = pair_noise(device, logs[0]) ** 2
    within = np.mean(np.var(soaks, axis=1, ddof=1))
    over = np.var(np.mean(soaks, axis=1), ddof=1)
    return {
        MEAN_STABILITY: _root(over, noise / soaks.shape[1]),
        REPEATABILITY: _root(within, noise),
    }


def _root(*variances: float) -> float:
    return float(np.sqrt(sum(variances)))
