"""Logs of gyros that drifted since their calibration, from the FMU at 1 kHz with its noise."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import (
    ARCSEC,
    DEG,
    DEG_PER_H,
    DEG_PER_SQRT_H,
    STANDARD_GRAVITY,
    YEAR,
)
from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD, GyroFmu
from pyhrg.records.columns import COLUMNS
from pyhrg.records.log import Log
from pyhrg.witness.information import factor_covariance
from pyhrg.witness.mechanisms import COUNT
from pyhrg.witness.prior import Prior, make_drift_prior

INTERVAL = 0.1
"""Length of a row, s. Forces are means of every control period in it: pick-off noise is then small,
because the loops differentiate it."""
RISE = 8.0
"""Rise of the case's temperature, K, with a time constant of 300 s."""
FORCES = ("amplitudeForce", "quadratureForce", "frequencyOffset")

GYRO = Device(
    decay_time=420.0,
    decay_time_per_kelvin=-3e-3,
    damping_anisotropy=2e-6,
    damping_axis=0.3,
    damping_anisotropy_per_kelvin=2e-3,
    pickoff_gain_mismatch=3e-4,
    pickoff_nonorthogonality=-4e-4,
    pickoff_gain_per_kelvin=3e-7,
    drive_gain_mismatch=-5e-4,
    drive_nonorthogonality=3e-4,
    drive_frame_rotation=2e-4,
    frequency_per_kelvin=85e-6,
    frequency_split=2e-3,
    stiffness_axis=1.1,
    phase_error=4e-4,
    phase_per_kelvin=3e-6,
    residual_quadrature=1e-4,
    amplitude_loop=30.0,
    quadrature_loop=60.0,
    phase_loop=400.0,
    angle_random_walk=3e-4 * DEG_PER_SQRT_H,
    angle_white_noise=0.02 * ARCSEC,
    bias_instability=1e-3 * DEG_PER_H,
    turn_on_scatter={
        "resonator.material.dampingAnisotropy": 1e-8,
        "pickOff.gainMismatch": 2.5e-6,
        "pickOff.nonOrthogonality": 2.5e-6,
        "drive.gainMismatch": 3e-6,
        "drive.nonOrthogonality": 3e-6,
    },
)
"""A gyro like those of the study whose maps are calibrated: a map of 0.6 deg/h."""
UNMEASURED = {
    "temperature_rate_bias": 0.06 * DEG_PER_H,
    "specific_force_bias": 4e-4 * DEG_PER_H / STANDARD_GRAVITY,
}
PRIOR = make_drift_prior(GYRO, YEAR / 2, 0.02, 0.05, **UNMEASURED)
LINEAR_PRIOR = make_drift_prior(GYRO, YEAR / 2, 0.02, 0.05, **UNMEASURED, cubic=0.0)
"""The same, with pick-offs whose cubic term is known."""


def draw_changes(prior: Prior, generator: np.random.Generator) -> Array:
    return prior.mean + factor_covariance(prior.covariance) @ generator.standard_normal(COUNT)


def weave(time: Array) -> Array:
    """Rate of a vehicle that turns to both sides, rad/s: up to 8 deg/s, 100 deg of heading."""
    return DEG * (6 * np.sin(2 * math.pi * time / 90) + 2 * np.sin(2 * math.pi * time / 37))


def rotate_virtually(time: Array) -> Array:
    """Virtual rotation of a self-test, rad/s: a minute each way in the first two minutes."""
    return np.where(time < 120, 5 * DEG * np.sign(60 - time), 0.0)


def fly(
    fmu: GyroFmu, device: Device, duration: float, seed: int, *, self_test: bool = False
) -> Log:
    """The log of a flight of a warming gyro, s, whose input axis points down."""
    time = np.arange(0.0, duration, INTERVAL)
    ends, means, held = record_flight(fmu, device, time, seed, self_test=self_test)
    missing = {c.field: np.full(len(time), np.nan) for c in COLUMNS}
    recorded = {
        "time": time + INTERVAL,
        "virtual_rotation": held["virtualRotation"],
        "acceleration_z": held["accelerationZ"],
        "gyro_angle": ends[:, 0],
        "wave_angle": ends[:, 1],
        "amplitude_force": means[:, 0],
        "quadrature_force": means[:, 1],
        "frequency_offset": means[:, 2],
    }
    return Log(source="flight", interval=INTERVAL, **{**missing, **recorded})


def record_flight(
    fmu: GyroFmu,
    device: Device,
    time: Array,
    seed: int,
    ends: Sequence[str] = (),
    *,
    self_test: bool = False,
) -> tuple[Array, Array, dict[str, Array]]:
    """Rows of a flight: (n, 2 + e) angles of gyro and pattern and other variables at their ends,
    (n, 3) means of `FORCES`, and (n,) held inputs by name. time: (n,) of their beginnings, s."""
    steps = round(INTERVAL / CONTROL_PERIOD)
    inner = time[:, None] + INTERVAL / steps * (np.arange(steps) + 0.5)
    held = {
        "virtualRotation": rotate_virtually(time) if self_test else np.zeros_like(time),
        "accelerationZ": np.full(len(time), -STANDARD_GRAVITY),
    }
    moving = {
        "angularRate": np.where(inner < 120, 0.0, weave(inner)) + 7e-5,
        "caseTemperature": device.reference_temperature + RISE * (1 - np.exp(-inner / 300)),
    }
    with fmu.power_on(device.fmu_parameters(), seed, 0.4 + 0.1 * seed) as gyro:
        rows, means = gyro.record(
            moving, held, INTERVAL / steps, ["gyroAngle", "patternAngle", *ends], FORCES
        )
    return rows, means, held


def compute_rms(maps: Array) -> float:
    """Rms over the circumference, and over the maps, of maps (..., TERMS)."""
    return float(np.sqrt(np.mean(maps[..., 0] ** 2 + np.sum(maps[..., 1:] ** 2, axis=-1) / 2)))


def burst(log: Log, generator: np.random.Generator, first: float, last: float) -> Log:
    """The log with a burst of noise in both forces, fifty times their own, between times, s."""
    rows = (log.time > first) & (log.time < last)
    size = 50 * np.std(np.diff(log.amplitude_force))
    spoilt = {
        name: getattr(log, name) + rows * generator.normal(0.0, size, len(rows))
        for name in ("amplitude_force", "quadrature_force")
    }
    return replace(log, **spoilt)
