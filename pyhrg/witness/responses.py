"""Sensitivities of a gyro's channels and of its output to its mechanisms, from the FMU.

A channel of a gyro whose pattern stands at th while the case turns at W and a virtual rotation V is
commanded is a series over the pattern angle, for each of the motions 1, W, W^2, V, V^2
(docs/methods/witness.md, Eq. 2). Its coefficients are fitted to simulations of `HRGSlow` in which
the pattern turns through half a turn; sensitivities are differences of two devices.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import GyroFmu
from pyhrg.witness.mechanisms import COUNT, MECHANISMS, SIGNALS

HARMONICS = (2, 4, 6, 8)
TERMS = 1 + 2 * len(HARMONICS)
"""Number of terms over the pattern angle: the mean, and a cosine and a sine of each harmonic."""
MOTIONS = 5
"""Number of motions: rest, W, W^2, V, V^2."""
FORCES = ("amplitudeForce", "quadratureForce")
"""Outputs of the FMU that witness the mechanisms. Amplitude and quadrature are held by their loops,
and the frequency is the thermometer."""
SWEEPS = ((1 * DEG, 0.0), (-1 * DEG, 0.0), (5 * DEG, 0.0), (-5 * DEG, 0.0), (0.0, 5 * DEG),
          (0.0, -5 * DEG))  # fmt: skip
"""Rates of the case and virtual rotations of the simulations, rad/s. Chosen: two rates separate W
from W^2."""
SAMPLE_PERIOD = 0.02
"""Sample period of the FMU, s. Chosen: its loops then lag by 0.06 s, as loops of 33 rad/s do."""
STEPS = 5
"""Number of communication steps in a row of a simulation. Chosen: the pattern turns by 0.14 deg."""
SOAKED_LAG = 1.0
"""Thermal lag of the simulated gyro, s, the shortest that the FMU takes."""
SETTLING = 16.0
"""Time that is left out of each simulation until loops and temperature are at rest, s. Chosen: 16
thermal lags."""
WARMTH = 10.0
"""Temperature above the reference at which thermal mechanisms are simulated, K. Chosen."""
HEATING = 0.01
"""Rate of the case's temperature at which mechanisms that act by it are simulated, K/s. Chosen."""
ISOLATED_LAG = 1e6
"""Thermal lag of a gyro whose resonator stays cool while its case heats, s."""
NOISE_DURATION = 4000
"""Number of seconds of simulated noise. Chosen: levels are known to 1.1 %."""


@dataclass(frozen=True)
class Responses:
    """Sensitivities of one gyro.

    forces: (COUNT, 2, MOTIONS, TERMS) of amplitude and quadrature force, 1/s per unit of each
    mechanism and of its signal, per power of the motion's rate;
    output: (COUNT, MOTIONS, TERMS) of the output rate, rad/s, likewise;
    noise: (2,) white noise of the forces, 1/s in one second's mean.
    """

    forces: Array
    output: Array
    noise: Array


@dataclass(frozen=True)
class Chamber:
    """Temperature of a simulation: of case and resonator above the reference, K, or a rate of the
    case's alone, K/s."""

    rise: float = 0.0
    rate: float = 0.0


@dataclass(frozen=True)
class Motion:
    """What a gyro goes through, row by row.

    interval: of a row, s; angle: (n,) pattern angle in the middle of each row, rad; rate: (n,) of
    the case, rad/s; virtual_rotation: (n,) as an input rate, rad/s; temperature: (n,) of the
    resonator above the reference, K; heating: (n,) rate of the case's temperature, K/s.
    """

    interval: float
    angle: Array
    rate: Array
    virtual_rotation: Array
    temperature: Array
    heating: Array

    def take(self, rows: slice) -> "Motion":
        return Motion(
            self.interval,
            self.angle[rows],
            self.rate[rows],
            self.virtual_rotation[rows],
            self.temperature[rows],
            self.heating[rows],
        )


def evaluate_angles(angle: Array) -> Array:
    """(..., TERMS) 1, cos 2th, sin 2th, cos 4th, ... of pattern angles th (...), rad."""
    waves = [wave(h * angle) for h in HARMONICS for wave in (np.cos, np.sin)]
    return np.stack([np.ones_like(angle), *waves], axis=-1)


def evaluate_motion(motion: Motion) -> Array:
    """(n, MOTIONS, TERMS) products of the motions' powers and the terms over the pattern angle."""
    w, v = motion.rate, motion.virtual_rotation
    powers = np.stack([np.ones_like(w), w, w * w, v, v * v], axis=-1)
    return np.asarray(powers[:, :, None] * evaluate_angles(motion.angle)[:, None, :])


def compute_design(sensitivities: Array, motion: Motion) -> Array:
    """(n, channels, COUNT) change of each channel in each row per unit of each mechanism.

    sensitivities: (COUNT, channels, MOTIONS, TERMS).
    """
    count, channels = sensitivities.shape[:2]
    flat = sensitivities.reshape(count * channels, -1)
    rows = evaluate_motion(motion).reshape(len(motion.angle), -1) @ flat.T
    design = np.moveaxis(rows.reshape(-1, count, channels), 1, 2)
    design[:, :, SIGNALS == "temperature"] *= motion.temperature[:, None, None]
    design[:, :, SIGNALS == "heating"] *= motion.heating[:, None, None]
    return design


def measure_responses(fmu: GyroFmu, device: Device) -> Responses:
    """Sensitivities of a gyro to all mechanisms, and the noise of its forces.

    fmu: `HRGSlow`.
    """
    quiet = device.without_noise()
    sizes = {"one": 1.0, "temperature": WARMTH, "heating": HEATING}
    chambers = {
        "one": Chamber(),
        "temperature": Chamber(rise=WARMTH),
        "heating": Chamber(rate=HEATING),
    }
    unchanged = {name: _fit_channels(fmu, quiet, chamber) for name, chamber in chambers.items()}
    changes = np.empty((COUNT, *unchanged["one"].shape))
    for place, mechanism in enumerate(MECHANISMS):
        signal, changed = mechanism.signal, mechanism.add(quiet, mechanism.step)
        difference = _fit_channels(fmu, changed, chambers[signal]) - unchanged[signal]
        changes[place] = difference / (mechanism.step * sizes[signal])
    return Responses(changes[:, :2], changes[:, 2], measure_noise(fmu, device))


def measure_noise(fmu: GyroFmu, device: Device) -> Array:
    """(2,) standard deviation of one second's mean of each force of a gyro at rest, 1/s."""
    steps = 10
    with fmu.power_on(_list_parameters(device, Chamber(), 0.1), 1, 0.0) as gyro:
        moving = {"angularRate": np.zeros((NOISE_DURATION, steps))}
        _, means = gyro.record(moving, {}, 0.1, [], FORCES)
    return np.asarray(np.std(np.diff(means[10:], axis=0), axis=0) / math.sqrt(2))


def measure_output(fmu: GyroFmu, device: Device, rise: float) -> Array:
    """(2 TERMS,) maps of a gyro's output at a temperature above the reference, K: bias at rest,
    rad/s, and scale-factor error.

    fmu: `HRGSlow`.
    """
    return np.asarray(_fit_channels(fmu, device.without_noise(), Chamber(rise=rise))[2, :2].ravel())


def _fit_channels(fmu: GyroFmu, device: Device, chamber: Chamber) -> Array:
    """(3, MOTIONS, TERMS) coefficients of amplitude force, quadrature force and output rate."""
    rows, values = zip(*_sweep(fmu, device, chamber), strict=True)
    design, channels = np.concatenate(rows), np.concatenate(values)
    scale = np.sqrt(np.mean(design**2, axis=0))
    kept = scale > 0
    fitted = np.linalg.lstsq(design[:, kept] / scale[kept], channels, rcond=None)[0]
    coefficients = np.zeros((design.shape[1], 3))
    coefficients[kept] = fitted / scale[kept, None]
    return np.asarray(coefficients.T.reshape(3, MOTIONS, TERMS))


def _sweep(fmu: GyroFmu, device: Device, chamber: Chamber) -> Iterator[tuple[Array, Array]]:
    """Rows of the fit and the channels, of each simulation."""
    interval = STEPS * SAMPLE_PERIOD
    skipped = round(SETTLING / interval)
    for rate, rotation in SWEEPS:
        turning = device.bryan_factor * (abs(rate) + abs(rotation))
        count = skipped + math.ceil(math.pi / turning / interval)
        time = SAMPLE_PERIOD * np.arange(count * STEPS).reshape(count, STEPS)
        case = device.reference_temperature + chamber.rate * time
        moving = {"angularRate": np.full((count, STEPS), rate), "caseTemperature": case}
        held = {"virtualRotation": np.full(count, rotation)}
        with fmu.power_on(_list_parameters(device, chamber, SAMPLE_PERIOD), 0, 0.0) as gyro:
            names = ["gyroAngle", "patternAngle"]
            ends, means = gyro.record(moving, held, SAMPLE_PERIOD, names, FORCES)
        output = np.diff(ends[skipped - 1 :, 0]) / interval - rate
        angle = 0.5 * (ends[skipped:, 1] + ends[skipped - 1 : -1, 1])
        every = np.ones_like(angle)
        motion = Motion(interval, angle, rate * every, rotation * every, 0 * every, 0 * every)
        yield (
            evaluate_motion(motion).reshape(len(angle), -1),
            np.column_stack([means[skipped:], output]),
        )


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
