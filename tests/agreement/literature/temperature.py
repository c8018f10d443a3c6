"""Bias over temperature: mode reversal, and compensation from the gyro's own channels."""

from collections.abc import Mapping

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H, MINUTE, ZERO_CELSIUS
from pyhrg.device.ready_devices import TYPICAL
from tests.agreement.paper.gyros import load_fmu, simulate_output_rate

COEFFICIENTS = {
    "resonator.material.decayTimePerKelvin": -0.005,
    "resonator.material.dampingAnisotropyPerKelvin": 0.005,
    "resonator.material.frequencyPerKelvin": 85e-6,
    "pickOff.gainPerKelvin": 5e-6,
    "pickOff.phasePerKelvin": 5e-5,
    "pickOff.gainPerGradient": 5e-6,
}
"""The middle of what the parameters' descriptions call typical."""
REBALANCE = {"controller.forceToRebalance": 1.0}
SWEEP = 20.0
"""Time in which the electronics turn the pattern by a whole period of the map, s."""
DITHER = {"controller.sweep.angle": 90 * DEG, "controller.sweep.sweepTime": SWEEP}
PUMP = {"controller.parametricShare": 1.0}
SOAKS = np.array([-40.0, -20.0, 0.0, 20.0, 40.0, 60.0]) + ZERO_CELSIUS
ANGLE = 10 * DEG
"""Power-on angle of the typical gyro."""
LOW, HIGH, RAMP = -20 + ZERO_CELSIUS, 60 + ZERO_CELSIUS, 1 / MINUTE
CHANNELS = ("gyroAngle", "frequencyOffset", "amplitudeForce", "quadratureForce")
SIZES = np.array([1.0, 100.0, 1e-3, 1e-3, 10.0])
"""Orders of magnitude of a constant, frequency, amplitude and quadrature force, and of the slope of
the frequency from mean to mean, SI: they make the fit well conditioned."""
STEP, MEAN = 0.1, 100.0
"""Step of the simulation and length of the means, s."""


def figures() -> dict[str, float]:
    """Ratios of the variation of the bias over temperature, before over after."""
    return {**_reverse_modes(), **_compensate()}


def _reverse_modes() -> dict[str, float]:
    """Largest less smallest bias over soaks of -40 to 60 degC: at one angle, averaged with the
    angle where antinode and node have changed places, and swept over all angles, without and
    with parametric drive."""
    gyro = {**TYPICAL.without_noise().fmu_parameters(), **COEFFICIENTS, **REBALANCE}
    gyro["resonator.environment.thermalLag"] = 1.0

    def simulate_bias(parameters: Mapping[str, float], angle: float) -> Array:
        return np.array(
            [
                simulate_output_rate(
                    parameters, angle, 0.0, 2 * SWEEP, 2 * SWEEP, "HRGSlow", caseTemperature=soak
                )
                for soak in SOAKS
            ]
        )

    here, there = simulate_bias(gyro, ANGLE), simulate_bias(gyro, ANGLE + 45 * DEG)
    single = float(np.ptp(here))
    return {
        "single_deg_h": single / DEG_PER_H,
        "reversed_ratio": single / float(np.ptp((here + there) / 2)),
        "swept_ratio": single / float(np.ptp(simulate_bias({**gyro, **DITHER}, ANGLE))),
        "pumped_ratio": single / float(np.ptp(simulate_bias({**gyro, **DITHER, **PUMP}, ANGLE))),
    }


def _compensate() -> dict[str, float]:
    """Two cycles of temperature at 1 K/min: a linear law of frequency, amplitude and quadrature
    force and the frequency's slope, fitted to the first, applied to the second."""
    first, second = (_record(seed) for seed in (1, 2))
    law, *_ = np.linalg.lstsq(first[1], first[0], rcond=None)
    memoryless, *_ = np.linalg.lstsq(first[1][:, :2], first[0], rcond=None)
    before = float(np.std(second[0], ddof=1))
    after = float(np.std(second[0] - second[1] @ law, ddof=1))
    looked_up = float(np.std(second[0] - second[1][:, :2] @ memoryless, ddof=1))
    return {
        "cycle_deg_h": before / DEG_PER_H,
        "frequency_ratio": before / looked_up,
        "channels_ratio": before / after,
    }


def _record(seed: int) -> tuple[Array, Array]:
    """(n,) means of the output rate over 100 s, rad/s, and (n, 5) what the law rests on."""
    gyro = {**TYPICAL.fmu_parameters(), **COEFFICIENTS, **REBALANCE}
    gyro["resonator.environment.startTemperature"] = LOW - TYPICAL.reference_temperature
    ramp = np.arange(0.0, (HIGH - LOW) / RAMP, STEP)
    case = np.concatenate([LOW + RAMP * ramp, HIGH - RAMP * ramp])
    rows = len(case) // round(MEAN / STEP)
    inputs = case[: rows * round(MEAN / STEP)].reshape(rows, -1)
    with load_fmu("HRGSlow").power_on(gyro, seed=seed, start_angle=ANGLE) as running:
        ends, _ = running.record({"caseTemperature": inputs}, {}, STEP, CHANNELS)
    angle, frequency, amplitude, quadrature = ends.T
    slope = np.gradient(frequency)[1:]
    columns = (np.ones(rows - 1), frequency[1:], amplitude[1:], quadrature[1:], slope)
    return np.diff(angle) / MEAN, np.stack(columns, 1) / SIZES
