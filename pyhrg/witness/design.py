"""Change of a gyro's channels along a motion, per unit of each mechanism (docs/methods/witness.md,
Eqs. 2 and 2a)."""

from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.witness.mechanisms import CHANGING, FOLLOWED

HARMONICS = (2, 4, 6, 8)
TERMS = 1 + 2 * len(HARMONICS)
"""Number of terms over the pattern angle: the mean, and a cosine and a sine of each harmonic."""
MOTIONS = 5
"""Number of motions: rest, W, W^2, V, V^2."""
TURNING = 1
"""Place of W among the motions."""
POWERS = 3
"""Number of powers of the temperature: 0 to 2."""


@dataclass(frozen=True)
class Motion:
    """Motion and environment of a gyro, row by row.

    Attributes:
        interval: length of a row, s.
        angle: (n,) pattern angle in the middle of each row, rad.
        rate: (n,) of the case, rad/s.
        virtual_rotation: (n,) as an input rate, rad/s.
        temperature: (n,) of the resonator above the reference, K.
        signals: (n, SIGNALS) that mechanisms act in proportion to.
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
    cool = evaluate_cool(motion.angle, motion.rate, motion.virtual_rotation)
    return np.asarray(warmth[:, :, None, None] * cool[:, None])


def evaluate_cool(angle: Array, rate: Array, rotation: Array) -> Array:
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
