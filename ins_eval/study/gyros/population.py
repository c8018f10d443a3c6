"""What gyros there are: distributions over the mechanisms of a device.

Each mechanism that makes a bias map has its share of the gyro's size, which is log-uniform; its
own part is that times a normal deviate (a normal vector where it has an axis). The closed forms
that turn a bias into a parameter are those of the catalogue of mechanisms (`pyhrg.theory`), so
that shares are comparable; the map that results is read off the FMU.

    mechanism                                   share of the bias map
    damping anisotropy                          0.6, any axis
    pick-off gain and non-orthogonality         0.4, as a vector
    drive gain and non-orthogonality            0.4, as a vector
    frequency split with phase error            0.4; split 0.1 to 1 mHz, any axis
    frequency split with residual quadrature    0.3
    demodulation offset (second harmonic)       0.05
    pick-off cubic (eighth, scale factor)       0.2 of the pick-off's gain

    not of the map, or not by share             distribution
    decay time                                  300 to 600 s
    drive frame, Bryan factor                   0.2 mrad, 20 ppm (1 sigma)
    differential phase, feedthrough             0.05 mrad, 0.2 ms (1 sigma)
    Duffing shift                               1e-8 of the frequency (1 sigma)
    loop delay                                  0 to 0.5 ms
    decay time and damping per kelvin           -0.3 +- 0.2 %, 0 +- 0.3 %
    pick-off gain, phase per kelvin             0.1 % of the gain, 1 % of the phase (1 sigma)
    bias per specific force on the input axis   4e-4 deg/h a g (1 sigma)
    pick-off gain per specific force across it  that makes as much bias (1 sigma)
    bias per rate of the case's temperature     1e-4 deg/h for each kelvin in 600 s (1 sigma)
    power-on: damping, pick-offs, drives        0.5 % of the mechanism (1 sigma)
    angle random walk                           1e-4 to 1e-3 deg/sqrt(h), log-uniform
    bias instability                            5e-4 to 5e-3 deg/h, log-uniform
    rate random walk                            5e-4 to 5e-3 deg/h in an hour, log-uniform
    angle white noise                           0.01 to 0.05 arcsec, log-uniform

Sensitivities to specific force and to the rate of temperature are what compensation leaves: raw
ones are 1e-3 to 2e-2 deg/h, to a g or a kelvin. At 3e-4 deg/sqrt(h) an hour's tumble tells them
within 4e-4 deg/h a g; an hour's ramp of a kelvin a minute within 3e-5 deg/h a kelvin, hysteresis
apart.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.mission_model.missions import WARM_UP
from pyhrg.common.units import (
    ARCSEC,
    DEG,
    DEG_PER_H,
    DEG_PER_SQRT_H,
    HOUR,
    HZ,
    PPM,
    STANDARD_GRAVITY,
)
from pyhrg.device.device import Device

Generator = np.random.Generator


@dataclass(frozen=True)
class Population:
    """Gyros of a kind.

    smallest, largest: sizes of their bias maps as they are built, rad/s.
    """

    smallest: float
    largest: float

    def __post_init__(self) -> None:
        if not 0 < self.smallest <= self.largest < math.inf:
            found = f"{self.smallest / DEG_PER_H:g} to {self.largest / DEG_PER_H:g} deg/h"
            raise ValueError(f"bias maps of {found}: expected above 0, the smallest first")

    def draw(self, generator: Generator) -> Device:
        """A gyro as it is built, before calibration."""
        size = _log_uniform(generator, self.smallest, self.largest)
        device = Device(
            decay_time=generator.uniform(300.0, 600.0),
            thermal_lag=WARM_UP,
            phase_loop=PHASE_LOOP,
            quadrature_loop=QUADRATURE_LOOP,
            amplitude_loop=AMPLITUDE_LOOP,
            power_on_angle=generator.uniform(0.0, math.pi),
            power_on_scatter=0.5 * DEG,
        )
        for mechanisms in (
            _resonator,
            _electrodes,
            _electronics,
            _temperature,
            _sensitivity,
            _noise,
        ):
            device = mechanisms(device, size, generator)
        return replace(device, turn_on_scatter=_scatter(device))


TRIMMED = Population(0.01 * DEG_PER_H, 0.1 * DEG_PER_H)
"""Trimmed mechanically: what flies is the whole map, less its mean."""
RAW = Population(0.3 * DEG_PER_H, 1.5 * DEG_PER_H)
"""For calibration by the map: what flies is what the map drifts by."""
PHASE_LOOP = 400.0
"""rad/s: it lags behind the frequency of a gyro that warms, 0.1 rad/s^2, by less than 1e-6 rad."""
QUADRATURE_LOOP = 60.0
"""rad/s: by its lag a split of 1 mHz makes a scale factor of 5e-9 (`pyhrg.theory`); 6 rad/s would
make it 5e-7, which a gyro that rolls shows."""
AMPLITUDE_LOOP = 30.0
"""rad/s."""
PER_G = 4e-4 * DEG_PER_H
PER_KELVIN = 1e-4 * DEG_PER_H
"""Bias by specific force, and by the case's change of temperature in `WARM_UP`, that compensation
leaves, 1 sigma, rad/s."""
REPEATABILITY = 0.005
"""Of damping, pick-offs and drives, from one power-on to the next, as a share of each."""


def _resonator(device: Device, size: float, generator: Generator) -> Device:
    k = device.bryan_factor
    split = HZ * _log_uniform(generator, 1e-4, 1e-3)
    damping = complex(*generator.normal(0.0, 0.6 * size, 2))
    return replace(
        device,
        bryan_factor_error=generator.normal(0.0, 20 * PPM),
        damping_anisotropy=4 * k * abs(damping),
        damping_axis=math.atan2(damping.imag, damping.real) / 4,
        frequency_split=split,
        stiffness_axis=generator.uniform(0.0, math.pi / 2),
        phase_error=4 * k * generator.normal(0.0, 0.4 * size) / split,
        residual_quadrature=2 * k * generator.normal(0.0, 0.3 * size) / split,
        duffing=generator.normal(0.0, 1e-8) * device.frequency,
    )


def _electrodes(device: Device, size: float, generator: Generator) -> Device:
    scale = 4 * device.bryan_factor * device.decay_time * size
    pickoff, drive = generator.normal(0.0, 0.4 * scale, (2, 2)).tolist()
    return replace(
        device,
        pickoff_gain_mismatch=pickoff[0],
        pickoff_nonorthogonality=pickoff[1],
        pickoff_cubic=0.2 * generator.normal(0.0, 0.4 * scale),
        drive_gain_mismatch=drive[0],
        drive_nonorthogonality=drive[1],
        drive_frame_rotation=generator.normal(0.0, 2e-4),
        feedthrough=generator.normal(0.0, 2e-4),
    )


def _electronics(device: Device, size: float, generator: Generator) -> Device:
    offset = 2 * device.bryan_factor * device.decay_time * size
    return replace(
        device,
        demodulation_offset=generator.normal(0.0, 0.05 * offset),
        differential_phase=generator.normal(0.0, 5e-5),
        loop_delay=generator.uniform(0.0, 5e-4),
    )


def _temperature(device: Device, size: float, generator: Generator) -> Device:
    gain = math.hypot(device.pickoff_gain_mismatch, device.pickoff_nonorthogonality)
    return replace(
        device,
        decay_time_per_kelvin=generator.normal(-3e-3, 2e-3),
        damping_anisotropy_per_kelvin=generator.normal(0.0, 3e-3),
        frequency_per_kelvin=generator.normal(85e-6, 2e-6),
        pickoff_gain_per_kelvin=generator.normal(0.0, 1e-3 * gain),
        phase_per_kelvin=generator.normal(0.0, 1e-2 * abs(device.phase_error)),
    )


def _sensitivity(device: Device, size: float, generator: Generator) -> Device:
    bias, gain = generator.normal(0.0, PER_G, 2).tolist()
    gain_of_bias = 4 * device.bryan_factor * device.decay_time
    return replace(
        device,
        bias_per_acceleration=bias / STANDARD_GRAVITY,
        pickoff_gain_per_acceleration=gain_of_bias * gain / STANDARD_GRAVITY,
        bias_per_temperature_rate=generator.normal(0.0, PER_KELVIN) * WARM_UP,
    )


def _noise(device: Device, size: float, generator: Generator) -> Device:
    per_root_hour = _log_uniform(generator, 5e-4, 5e-3) * DEG_PER_H / math.sqrt(HOUR)
    return replace(
        device,
        angle_random_walk=_log_uniform(generator, 1e-4, 1e-3) * DEG_PER_SQRT_H,
        bias_instability=_log_uniform(generator, 5e-4, 5e-3) * DEG_PER_H,
        rate_random_walk=per_root_hour,
        pickoff_noise=_log_uniform(generator, 0.01, 0.05) * ARCSEC,
    )


def _scatter(device: Device) -> dict[str, float]:
    """Standard deviations of the FMU's parameters, by its names, from power-on to power-on."""
    pickoff = math.hypot(device.pickoff_gain_mismatch, device.pickoff_nonorthogonality)
    drive = math.hypot(device.drive_gain_mismatch, device.drive_nonorthogonality)
    sizes = {
        "resonator.material.dampingAnisotropy": device.damping_anisotropy,
        "pickOff.gainMismatch": pickoff,
        "pickOff.nonOrthogonality": pickoff,
        "drive.gainMismatch": drive,
        "drive.nonOrthogonality": drive,
    }
    return {name: REPEATABILITY * size for name, size in sizes.items()}


def _log_uniform(generator: Generator, low: float, high: float) -> float:
    return math.exp(generator.uniform(math.log(low), math.log(high)))
