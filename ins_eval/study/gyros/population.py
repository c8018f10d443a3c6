"""Populations of gyros: distributions over the mechanisms of a device.

The size of a gyro's bias map is log-uniform. Each mechanism that makes a bias map has a share of
that size, times a normal deviate, or a normal vector where the mechanism has an axis. The closed
forms that turn a bias into a parameter are those of `pyhrg.theory`, so that shares are comparable;
the resulting map is measured by simulation of the FMU. A share of each mechanism's deviate is the
same in all gyros of one maker. All numbers are chosen.

    mechanism                                   share of the bias map
    damping anisotropy                          0.6, any axis
    pick-off gain and non-orthogonality         0.4, as a vector
    drive gain and non-orthogonality            0.4, as a vector
    frequency split with phase error            0.4; split 0.1 to 1 mHz, any axis
    frequency split with residual quadrature    0.3
    demodulation offset (second harmonic)       0.05
    pick-off cubic (eighth, scale factor)       0.2 times 0.4

    not of the map, or not by share             distribution
    decay time                                  300 to 600 s
    drive frame, Bryan factor                   0.2 mrad, 20 ppm (1 sigma)
    differential phase, feedthrough             0.05 mrad, 0.2 ms (1 sigma)
    Duffing shift                               1e-8 of the frequency (1 sigma)
    loop delay                                  0 to 0.5 ms
    decay time and damping per kelvin           -0.3 +- 0.2 %, 0 +- 0.3 %
    pick-off gain, phase per kelvin             0.1 % of the gain, 1 % of the phase (1 sigma)
    frequency per kelvin                        85 +- 2 ppm
    power-on angle                              any; 0.5 deg from one power-on to the next (1 sigma)
    bias per specific force on the input axis   4e-4 deg/h a g (1 sigma)
    pick-off gain per specific force across it  that makes as much bias (1 sigma)
    bias per rate of the case's temperature     1e-4 deg/h for each kelvin in 600 s (1 sigma)
    power-on: damping, pick-offs, drives        0.5 % of the mechanism (1 sigma)
    angle random walk                           1e-4 to 1e-3 deg/sqrt(h), log-uniform
    bias instability                            5e-4 to 5e-3 deg/h, log-uniform
    rate random walk                            5e-4 to 5e-3 deg/h in an hour, log-uniform
    angle white noise                           0.01 to 0.05 arcsec, log-uniform

    where `rarer` is 1
    cubic softening by eight electrodes         0.3 of the frequency split (1 sigma)
    pick-offs read in turn                      5 us (1 sigma)
    flicker of the damping anisotropy           1e-5 to 1e-3 of it, log-uniform
    flicker of pick-off gain and phase          1e-7 to 1e-6, log-uniform, each

Sensitivities to specific force and to the rate of temperature are residuals of a compensation: raw
ones are 1e-3 to 2e-2 deg/h per g or per kelvin. With an angle random walk of 3e-4 deg/sqrt(h) a
tumble test of an hour measures them within 4e-4 deg/h per g; a ramp of an hour at a kelvin per
minute measures them within 3e-5 deg/h per kelvin, without hysteresis.
"""

import math
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ins_eval.mission_model.missions import WARM_UP
from pyhrg.common.errors import HrgError
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

MAKER = 0
"""Seed of the maker's own deviates: any number, the same for all gyros. Chosen."""


class MakersGenerator(np.random.Generator):
    """A gyro's generator whose normal deviates correlate with those of all other gyros.

    Draws of the same order in different gyros have the correlation `common`; the distribution of
    each is as before. Uniform draws are the gyro's own.
    """

    def __init__(self, own: np.random.Generator, common: float) -> None:
        """Take over a gyro's generator; `common` is a share of the variance, 0 to 1."""
        super().__init__(own.bit_generator)
        self._maker = np.random.default_rng(MAKER)
        self._shares = math.sqrt(common), math.sqrt(1 - common)

    def normal(self, loc: Any = 0.0, scale: Any = 1.0, size: Any = None) -> Any:
        """Normal deviates, as `numpy.random.Generator.normal`."""
        maker, own = self._maker.standard_normal(size), super().standard_normal(size)
        return loc + scale * (self._shares[0] * maker + self._shares[1] * own)


Generator = np.random.Generator


@dataclass(frozen=True)
class Population:
    """A distribution of gyros.

    Attributes:
        smallest, largest: bounds of the size of their bias maps as they are built, rad/s.
        common: correlation of each normal deviate from gyro to gyro, 0 to 1: gyros of one maker
            have maps of one shape. Uniform and log-uniform draws are each gyro's own.
        rarer: size of mechanisms that not every gyro has (33, 34 and 38), over the one above; 0:
            none. They are drawn by a generator of their own and have no part that is `common`, so
            that whatever else is drawn is the same with and without them.
    """

    smallest: float
    largest: float
    common: float = field(default=0.0, kw_only=True)
    rarer: float = field(default=0.0, kw_only=True)

    def __post_init__(self) -> None:
        if not 0 < self.smallest <= self.largest < math.inf:
            found = f"{self.smallest / DEG_PER_H:g} to {self.largest / DEG_PER_H:g} deg/h"
            raise HrgError(f"bias maps of {found}: expected above 0, the smaller first")

    def draw(self, generator: Generator) -> Device:
        """A gyro as it is built, before the maker's calibration."""
        (of_rarer,) = generator.spawn(1)
        size = _draw_log_uniform(generator, self.smallest, self.largest)
        if self.common:
            generator = MakersGenerator(generator, self.common)
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
            _add_resonator,
            _add_electrodes,
            _add_electronics,
            _add_temperature,
            _add_sensitivity,
            _add_noise,
        ):
            device = mechanisms(device, size, generator)
        if self.rarer:
            device = _add_rarer(device, self.rarer, of_rarer)
        return replace(device, turn_on_scatter=_compute_scatter(device))


TRIMMED = Population(0.01 * DEG_PER_H, 0.1 * DEG_PER_H)
"""Gyros that are trimmed mechanically: their whole map flies, but for its mean."""
RAW = Population(0.3 * DEG_PER_H, 1.5 * DEG_PER_H)
"""Gyros whose whole map is calibrated: only the drift of the map flies."""
PHASE_LOOP = 400.0
"""Bandwidth of the phase loop, rad/s. It follows the frequency of a warming gyro, 0.1 rad/s^2, with
an error below 1e-6 rad."""
QUADRATURE_LOOP = 60.0
"""Bandwidth of the quadrature loop, rad/s. By its lag a frequency split of 1 mHz makes a
scale-factor error of 5e-9 (`pyhrg.theory`); 6 rad/s would make 5e-7, which is visible in a vehicle
that rolls."""
AMPLITUDE_LOOP = 30.0
"""Bandwidth of the amplitude loop, rad/s. Chosen."""
BIAS_PER_G = 4e-4 * DEG_PER_H
BIAS_PER_KELVIN = 1e-4 * DEG_PER_H
"""Standard deviations of the bias per g of specific force, and per kelvin by which the case warms
in `WARM_UP`, after compensation, rad/s."""
TURN_ON_REPEATABILITY = 0.005
"""Turn-on to turn-on repeatability of damping, pick-offs and drives: standard deviation as a share
of each. Chosen."""


def _add_resonator(device: Device, size: float, generator: Generator) -> Device:
    k = device.bryan_factor
    split = HZ * _draw_log_uniform(generator, 1e-4, 1e-3)
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


def _add_electrodes(device: Device, size: float, generator: Generator) -> Device:
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


def _add_electronics(device: Device, size: float, generator: Generator) -> Device:
    offset = 2 * device.bryan_factor * device.decay_time * size
    return replace(
        device,
        demodulation_offset=generator.normal(0.0, 0.05 * offset),
        differential_phase=generator.normal(0.0, 5e-5),
        loop_delay=generator.uniform(0.0, 5e-4),
    )


def _add_temperature(device: Device, size: float, generator: Generator) -> Device:
    gain = math.hypot(device.pickoff_gain_mismatch, device.pickoff_nonorthogonality)
    return replace(
        device,
        decay_time_per_kelvin=generator.normal(-3e-3, 2e-3),
        damping_anisotropy_per_kelvin=generator.normal(0.0, 3e-3),
        frequency_per_kelvin=generator.normal(85e-6, 2e-6),
        pickoff_gain_per_kelvin=generator.normal(0.0, 1e-3 * gain),
        phase_per_kelvin=generator.normal(0.0, 1e-2 * abs(device.phase_error)),
    )


def _add_sensitivity(device: Device, size: float, generator: Generator) -> Device:
    bias, gain = generator.normal(0.0, BIAS_PER_G, 2).tolist()
    gain_of_bias = 4 * device.bryan_factor * device.decay_time
    return replace(
        device,
        bias_per_acceleration=bias / STANDARD_GRAVITY,
        pickoff_gain_per_acceleration=gain_of_bias * gain / STANDARD_GRAVITY,
        bias_per_temperature_rate=generator.normal(0.0, BIAS_PER_KELVIN) * WARM_UP,
    )


def _add_noise(device: Device, size: float, generator: Generator) -> Device:
    per_root_hour = _draw_log_uniform(generator, 5e-4, 5e-3) * DEG_PER_H / math.sqrt(HOUR)
    return replace(
        device,
        angle_random_walk=_draw_log_uniform(generator, 1e-4, 1e-3) * DEG_PER_SQRT_H,
        bias_instability=_draw_log_uniform(generator, 5e-4, 5e-3) * DEG_PER_H,
        rate_random_walk=per_root_hour,
        angle_white_noise=_draw_log_uniform(generator, 0.01, 0.05) * ARCSEC,
    )


def _add_rarer(device: Device, share: float, generator: Generator) -> Device:
    return replace(
        device,
        electrostatic_cubic=generator.normal(0.0, 0.3 * share) * device.frequency_split,
        sampling_skew=generator.normal(0.0, 5e-6 * share),
        damping_anisotropy_flicker=share * _draw_log_uniform(generator, 1e-5, 1e-3),
        pickoff_gain_flicker=share * _draw_log_uniform(generator, 1e-7, 1e-6),
        phase_flicker=share * _draw_log_uniform(generator, 1e-7, 1e-6),
    )


def _compute_scatter(device: Device) -> dict[str, float]:
    """Standard deviations of the FMU's parameters between power-ons, by their names."""
    pickoff = math.hypot(device.pickoff_gain_mismatch, device.pickoff_nonorthogonality)
    drive = math.hypot(device.drive_gain_mismatch, device.drive_nonorthogonality)
    sizes = {
        "resonator.material.dampingAnisotropy": device.damping_anisotropy,
        "pickOff.gainMismatch": pickoff,
        "pickOff.nonOrthogonality": pickoff,
        "drive.gainMismatch": drive,
        "drive.nonOrthogonality": drive,
    }
    return {name: TURN_ON_REPEATABILITY * size for name, size in sizes.items()}


def _draw_log_uniform(generator: Generator, low: float, high: float) -> float:
    return math.exp(generator.uniform(math.log(low), math.log(high)))
