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
from pyhrg.witness.mechanisms import CHANGING, COUNT, FOLLOWED, MECHANISMS, THERMAL

HARMONICS = (2, 4, 6, 8)
TERMS = 1 + 2 * len(HARMONICS)
"""Number of terms over the pattern angle: the mean, and a cosine and a sine of each harmonic."""
MOTIONS = 5
"""Number of motions: rest, W, W^2, V, V^2."""
FORCES = ("amplitudeForce", "quadratureForce")
"""Outputs of the FMU that witness the mechanisms. Amplitude and quadrature are held by their loops,
and the frequency is the thermometer."""
TURNING = 1
"""Place of W among the motions."""
POWERS = 3
"""Number of powers of the temperature: 0 to 2."""
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

    forces: (COUNT, 2, POWERS, MOTIONS, TERMS) of amplitude and quadrature force, 1/s per unit of
    each mechanism and of its signal, per power of the temperature and of the motion's rate;
    output: (COUNT, POWERS, MOTIONS, TERMS) of the output rate, rad/s, likewise;
    noise: (2,) white noise of the forces, 1/s in one second's mean; angular_gain: Bryan factor.
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


@dataclass(frozen=True)
class Motion:
    """What a gyro goes through, row by row.

    interval: of a row, s; angle: (n,) pattern angle in the middle of each row, rad; rate: (n,) of
    the case, rad/s; virtual_rotation: (n,) as an input rate, rad/s; temperature: (n,) of the
    resonator above the reference, K; signals: (n, SIGNALS) that mechanisms act in proportion to.
    """

    interval: float
    angle: Array
    rate: Array
    virtual_rotation: Array
    temperature: Array
    signals: Array

    def take(self, rows: slice) -> "Motion":
        return Motion(
            self.interval,
            self.angle[rows],
            self.rate[rows],
            self.virtual_rotation[rows],
            self.temperature[rows],
            self.signals[rows],
        )


def stack_signals(temperature_rate: Array, force: Array | float = 0.0) -> Array:
    """(n, SIGNALS) from rates (n,) of the case's temperature, K/s, and specific forces (n, 3) along
    x electrodes, y electrodes and input axis, m/s^2."""
    x, _, z = np.broadcast_to(force, (len(temperature_rate), 3)).T
    return np.stack([np.ones_like(temperature_rate), temperature_rate, x, z], axis=-1)


def evaluate_angles(angle: Array) -> Array:
    """(..., TERMS) 1, cos 2th, sin 2th, cos 4th, ... of pattern angles th (...), rad."""
    waves = [wave(h * angle) for h in HARMONICS for wave in (np.cos, np.sin)]
    return np.stack([np.ones_like(angle), *waves], axis=-1)


def evaluate_motion(motion: Motion) -> Array:
    """(n, POWERS, MOTIONS, TERMS) products of powers of the temperature, powers of the motion, and
    terms over the pattern angle."""
    warmth = np.vander(motion.temperature, POWERS, increasing=True)
    cool = _evaluate_cool(motion.angle, motion.rate, motion.virtual_rotation)
    return np.asarray(warmth[:, :, None, None] * cool[:, None])


def _evaluate_cool(angle: Array, rate: Array, rotation: Array) -> Array:
    """(n, MOTIONS, TERMS) the same at the reference temperature."""
    moved = np.stack([np.ones_like(rate), rate, rate**2, rotation, rotation**2], axis=-1)
    return np.asarray(moved[:, :, None] * evaluate_angles(angle)[:, None, :])


def compute_design(sensitivities: Array, motion: Motion, angular_gain: float) -> Array:
    """(n, channels, COUNT) change of each channel in each row per unit of each mechanism.

    sensitivities: (COUNT, channels, POWERS, MOTIONS, TERMS).
    """
    count, channels = sensitivities.shape[:2]
    flat = sensitivities.reshape(count * channels, -1)
    rows = evaluate_motion(motion).reshape(len(motion.angle), -1) @ flat.T
    design = np.moveaxis(rows.reshape(-1, count, channels), 1, 2)
    design = design * motion.signals[:, None, FOLLOWED]
    return np.asarray(design + compute_change_design(sensitivities, motion, angular_gain))


def compute_change_design(sensitivities: Array, motion: Motion, angular_gain: float) -> Array:
    """(n, channels, COUNT) part of the design by the rates of signals (Eq. 2a).

    What pick-offs make of amplitude and angle, U(th), shows as it changes, whether the pattern
    turns, -k dU/dth for each rad/s of the case, or the signal changes, U.
    """
    count, channels = sensitivities.shape[:2]
    design = np.zeros((len(motion.angle), channels, count))
    slope = sensitivities[CHANGING, :, 0, TURNING, 1:].reshape(-1, channels, len(HARMONICS), 2)
    scale = angular_gain * np.array(HARMONICS)
    made = np.stack([slope[..., 1], -slope[..., 0]], axis=-1) / scale[:, None]
    potential = evaluate_angles(motion.angle)[:, 1:] @ made.reshape(*made.shape[:2], -1).swapaxes(
        1, 2
    )
    rates = np.gradient(motion.signals, motion.interval, axis=0)[:, FOLLOWED[CHANGING]]
    design[:, :, CHANGING] = np.moveaxis(potential * rates.T[:, :, None], 0, 2)
    return design


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
    rate of devices without noise, by the powers of the temperature above the reference.

    fmu: `HRGSlow`.
    """
    cases = [(device, Chamber(rise=rise)) for device in devices for rise in RISES]
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
    rows = _evaluate_cool(angle, rate * every, rotation * every).reshape(len(angle), -1)
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
