"""Bias and scale factor over three temperatures and the ramps between them."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import FAST, Intervals, against
from pyhrg import theory
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias import full_temperature
from pyhrg.bench.bias.thermal_programme import programme
from pyhrg.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL
from pyhrg.units import DEG_PER_H, MINUTE

MODEL = "HRGSlow"
SOAKS = (0.0, 25.0, 50.0)
BRYAN = "resonator.material.bryanFactorPerKelvin"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Two power-ons."""
    device = warm(np.random.default_rng(seed))
    bench = Bench(fmu, device, seed, step=1.0)
    course = programme(bench, SOAKS)
    tests = bench.run([PowerOn(f"thermal_{n}", full_temperature.KIND, course) for n in (1, 2)])
    return against(full_temperature.evaluate(bench.campaign(tests)), truths(device))


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
        decay_time=device.decay_time * float(np.exp(device.decay_time_per_kelvin * kelvin)),
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
