"""Sensitivities of a gyro's channels and of its output to its mechanisms, from the FMU.

A channel of a gyro whose pattern stands at th while the case turns at W and a virtual rotation V is
commanded is a series over the pattern angle, for each of the motions 1, W, W^2, V, V^2 and each
power of the temperature (docs/methods/witness.md, Eq. 2). Its coefficients are fitted to
simulations of `HRGSlow` in which the pattern turns through half a turn; sensitivities are
differences of two devices.
"""

import math
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import GyroFmu, record_together
from pyhrg.witness.design import MOTIONS, POWERS, TERMS, evaluate_cool
from pyhrg.witness.mechanisms import COUNT, MECHANISMS, THERMAL

FORCES = ("amplitudeForce", "quadratureForce")
"""Outputs of the FMU that witness the mechanisms. Amplitude and quadrature are held by their loops,
and the frequency is the thermometer."""
RISES = (0.0, 7.5, 15.0)
"""Temperatures above the reference of the simulations, K. Chosen: a product of two thermal
coefficients of 0.3 % is then interpolated to 1e-5 at 20 K."""
SWEEPS = ((2 * DEG, 0.0), (-2 * DEG, 0.0), (5 * DEG, 0.0), (-5 * DEG, 0.0), (0.0, 5 * DEG),
          (0.0, -5 * DEG))  # fmt: skip
"""Rates of the case and virtual rotations of the simulations, rad/s. Chosen: two rates separate W
from W^2."""
SAMPLE_PERIOD = 0.02
"""Sample period of the FMU, s. Chosen: its loops then lag by 0.06 s, as loops of 33 rad/s do."""
ROW_ANGLE = 0.14 * DEG
"""Turn of the pattern in a row of a simulation, rad. Chosen."""
SOAKED_LAG = 1.0
"""Thermal lag of the simulated gyro, s, the shortest that the FMU takes."""
SETTLING = 16.0
"""Time that is left out of each simulation until loops and temperature are at rest, s. Chosen: 16
thermal lags."""
HEATING_RATE = 0.01
"""Rate of the case's temperature at which mechanisms that act by it are simulated, K/s. Chosen."""
SPECIFIC_FORCE = ("accelerationX", "accelerationZ")
"""Inputs of the FMU by which mechanisms act."""
ISOLATED_LAG = 1e6
"""Thermal lag of a gyro whose resonator stays cool while its case heats, s."""
NOISE_PERIOD, NOISE_DURATION = 0.1, 20_000
"""Sample period and duration of simulated noise, s. Chosen: levels are known to 1.5 %."""


@dataclass(frozen=True)
class Responses:
    """Sensitivities of one gyro.

    Attributes:
        forces: (COUNT, 2, POWERS, MOTIONS, TERMS) of amplitude and quadrature force, 1/s per unit
            of each mechanism and of its signal, per power of the temperature and of the motion's
            rate.
        output: (COUNT, POWERS, MOTIONS, TERMS) of the output rate, rad/s, likewise.
        noise: (2,) white noise of the forces, 1/s in one second's mean.
        angular_gain: Bryan factor.
    """

    forces: Array
    output: Array
    noise: Array
    angular_gain: float


@dataclass(frozen=True)
class Chamber:
    """Environment of a simulation: temperature of case and resonator above the reference, K, or a
    rate of the case's alone, K/s; specific force along x electrodes and input axis, m/s^2."""

    rise: float = 0.0
    rate: float = 0.0
    force: float = 0.0


def measure_responses(fmu: GyroFmu, device: Device, noise: Array | None = None) -> Responses:
    """Sensitivities of a gyro to all mechanisms, linear in the temperature, and the noise of its
    forces.

    fmu: `HRGSlow`; noise: (2,) of the forces, where it is known.
    """
    quiet = device.without_noise()
    cool, warm, heated = Chamber(), Chamber(rise=RISES[-1]), Chamber(rate=HEATING_RATE)
    forced = Chamber(force=STANDARD_GRAVITY)
    by_signal = {
        "temperature rate": (heated, HEATING_RATE),
        "force across": (forced, STANDARD_GRAVITY),
        "force along": (forced, STANDARD_GRAVITY),
    }
    cases = [(quiet, each) for each in (cool, warm, heated, forced)]
    chambers: list[list[Chamber]] = []
    for place, mechanism in enumerate(MECHANISMS):
        steady = [warm] if THERMAL[place] else [cool, warm]
        acting = [by_signal[mechanism.signal][0]] if mechanism.signal in by_signal else steady
        chambers.append(acting)
        changed = mechanism.add(quiet, mechanism.step)
        cases += [(changed, each) for each in acting]
    unchanged, changed_channels = np.split(_fit_channels(fmu, cases), [4])
    base = dict(zip((cool, warm, heated, forced), unchanged, strict=True))
    changes, fitted = np.zeros((COUNT, 3, POWERS, MOTIONS, TERMS)), iter(changed_channels)
    for place, (mechanism, acting) in enumerate(zip(MECHANISMS, chambers, strict=True)):
        by_chamber = {each: (next(fitted) - base[each]) / mechanism.step for each in acting}
        at_rest = np.zeros((3, MOTIONS, TERMS))
        if mechanism.signal in by_signal:
            chamber, size = by_signal[mechanism.signal]
            changes[place, :, 0] = by_chamber[chamber] / size
        else:
            at_rest = by_chamber.get(cool, at_rest)
            changes[place, :, 0] = at_rest
            changes[place, :, 1] = (by_chamber[warm] - at_rest) / RISES[-1]
    noise = measure_noise(fmu, device) if noise is None else noise
    return Responses(changes[:, :2], changes[:, 2], noise, device.bryan_factor)


def measure_channels(fmu: GyroFmu, devices: Sequence[Device]) -> Array:
    """(d, 3, POWERS, MOTIONS, TERMS) coefficients of amplitude force, quadrature force and output
    rate of devices, their noise left out, by the powers of the temperature above the reference.

    fmu: `HRGSlow`.
    """
    quiet = [each.without_noise() for each in devices]
    cases = [(device, Chamber(rise=rise)) for device in quiet for rise in RISES]
    fitted = _fit_channels(fmu, cases)
    at_rises = fitted.reshape(len(devices), POWERS, *fitted.shape[1:])
    to_powers = np.linalg.inv(np.vander(RISES, POWERS, increasing=True))
    return np.asarray(np.einsum("pr,drcmt->dcpmt", to_powers, at_rises))


def measure_noise(fmu: GyroFmu, device: Device) -> Array:
    """(2,) white noise of each force of a gyro at rest, as the standard deviation of one second's
    mean, 1/s.

    Half the mean square difference of neighbouring means over T is a/T + c/T^2 with white noise a;
    the rest, by the lag of the loops, differs between means of 1 and 5 s.
    """
    steps = round(1 / NOISE_PERIOD)
    with fmu.power_on(_list_parameters(device, Chamber(), NOISE_PERIOD), 1, 0.0) as gyro:
        moving = {"angularRate": np.zeros((NOISE_DURATION, steps))}
        _, means = gyro.record(moving, {}, NOISE_PERIOD, [], FORCES)
    short = means[10:]
    long = short[: len(short) // 5 * 5].reshape(-1, 5, len(FORCES)).mean(axis=1)
    at_1, at_5 = (np.var(np.diff(each, axis=0), axis=0) / 2 for each in (short, long))
    return np.sqrt(np.maximum((25 * at_5 - at_1) / 4, 0.0))


def measure_output(fmu: GyroFmu, device: Device, rise: float) -> Array:
    """(2 TERMS,) maps of a gyro's output at a temperature above the reference, K: bias at rest,
    rad/s, and scale-factor error.

    fmu: `HRGSlow`.
    """
    (channels,) = _fit_channels(fmu, [(device.without_noise(), Chamber(rise=rise))])
    return np.asarray(channels[2, :2].ravel())


def _fit_channels(fmu: GyroFmu, cases: Sequence[tuple[Device, Chamber]]) -> Array:
    """(c, 3, MOTIONS, TERMS) coefficients of amplitude force, quadrature force and output rate."""
    sweeps = [_sweep(fmu, cases, *each) for each in SWEEPS]
    fits = []
    for parts in zip(*sweeps, strict=True):
        design = np.concatenate([rows for rows, _ in parts])
        channels = np.concatenate([values for _, values in parts])
        scale = np.sqrt(np.mean(design**2, axis=0))
        scaled = design / scale
        fitted = np.linalg.solve(scaled.T @ scaled, scaled.T @ channels) / scale[:, None]
        fits.append(fitted.T.reshape(3, MOTIONS, TERMS))
    return np.array(fits)


def _sweep(
    fmu: GyroFmu, cases: Sequence[tuple[Device, Chamber]], rate: float, rotation: float
) -> list[tuple[Array, Array]]:
    """Rows of the fit and the channels of each case, while it turns at a rate or virtually."""
    turning = cases[0][0].bryan_factor * (abs(rate) + abs(rotation))
    steps = round(ROW_ANGLE / turning / SAMPLE_PERIOD)
    interval = steps * SAMPLE_PERIOD
    skipped = math.ceil(SETTLING / interval)
    count = skipped + math.ceil(math.pi / turning / interval)
    time = SAMPLE_PERIOD * np.arange(count * steps).reshape(count, steps)
    moving = [
        {
            "angularRate": np.full((count, steps), rate),
            "caseTemperature": device.reference_temperature + chamber.rate * time,
            **{name: np.full_like(time, chamber.force) for name in SPECIFIC_FORCE},
        }
        for device, chamber in cases
    ]
    held = [{"virtualRotation": np.full(count, rotation)}] * len(cases)
    with ExitStack() as stack:
        gyros = [
            stack.enter_context(fmu.power_on(_list_parameters(*each, SAMPLE_PERIOD), 0, 0.0))
            for each in cases
        ]
        names = ["gyroAngle", "patternAngle"]
        recorded = record_together(gyros, moving, held, SAMPLE_PERIOD, names, FORCES)
    return [_list_rows(*each, interval, skipped, rate, rotation) for each in recorded]


def _list_rows(
    ends: Array, means: Array, interval: float, skipped: int, rate: float, rotation: float
) -> tuple[Array, Array]:
    output = np.diff(ends[skipped - 1 :, 0]) / interval - rate
    angle = 0.5 * (ends[skipped:, 1] + ends[skipped - 1 : -1, 1])
    every = np.ones_like(angle)
    rows = evaluate_cool(angle, rate * every, rotation * every).reshape(len(angle), -1)
    return rows, np.column_stack([means[skipped:], output])


def _list_parameters(device: Device, chamber: Chamber, period: float) -> dict[str, float]:
    """Parameters of `HRGSlow` for a gyro in a chamber, whose case begins at its reference."""
    reference = "resonator.environment.referenceTemperature"
    soaked = replace(
        device,
        thermal_lag=ISOLATED_LAG if chamber.rate else SOAKED_LAG,
        model={**device.model, reference: device.reference_temperature - chamber.rise},
    )
    parameters = {
        name: value
        for name, value in soaked.fmu_parameters().items()
        if name not in LOOP_FREQUENCIES
    }
    return {**parameters, "samplePeriod": period}
