"""The effects that a diagnosis may name, each through parameters of the device.

Names and parameters are the campaign format's; sizes that are nothing special (`scale`) are those
of the physics: what a trimmed gyro of this class has.
"""

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR, HZ, MINUTE, PPM
from pyhrg.common.units import STANDARD_GRAVITY as G
from pyhrg.device.device import Device
from pyhrg.device.keys import KEYS, Key

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Effect:
    """What may be wrong with a gyro, as a vector in which it is nearly linear.

    name: of the campaign format.
    fields: of `Device`; with `periods`, a magnitude and the angle that goes with it.
    scale: a size that is nothing special, SI.
    periods: of the angle in a full turn: the vector is magnitude (cos m angle, sin m angle).
    """

    name: str
    fields: tuple[str, ...]
    scale: float
    periods: int = 0

    @property
    def size(self) -> int:
        """Components of the vector."""
        return len(self.fields)

    @property
    def keys(self) -> tuple[Key, ...]:
        """Its parameters, as files name them."""
        return tuple(next(key for key in KEYS if key.field == name) for name in self.fields)

    @property
    def bounds(self) -> tuple[float, float]:
        """Least and largest value, or magnitude, that a gyro may have, SI."""
        key = self.keys[0]
        return key.to_si(key.low), key.to_si(key.high)

    def vector(self, device: Device) -> Array:
        """(size,) the effect in a device, SI."""
        values = [getattr(device, name) for name in self.fields]
        if not self.periods:
            return np.array(values)
        magnitude, angle = values
        return magnitude * np.array([np.cos(self.periods * angle), np.sin(self.periods * angle)])

    def put(self, device: Device, vector: Array) -> Device:
        """A device with the effect at this vector, as far as a gyro may have it, and all else as it
        was."""
        low, high = self.bounds
        if not self.periods:
            (value,) = vector
            return _with(device, {self.fields[0]: min(max(float(value), low), high)})
        angle = float(np.arctan2(vector[1], vector[0])) / self.periods
        values = (min(float(np.hypot(*vector)), high), angle % (2 * math.pi / self.periods))
        return _with(device, dict(zip(self.fields, values, strict=True)))

    def parameters(self, vector: Array) -> dict[str, float]:
        """Parameters by the campaign format's names, in its units."""
        device = self.put(Device(), vector)
        return {key.name: key.from_si(getattr(device, key.field)) for key in self.keys}

    def vector_of(self, parameters: Mapping[str, float]) -> Array:
        """(size,) the vector of parameters by the campaign format's names, in its units."""
        values = {key.field: key.to_si(parameters[key.name]) for key in self.keys}
        return self.vector(_with(Device(), values))


def _with(device: Device, values: Mapping[str, Any]) -> Device:
    return replace(device, **values)


def _axis(name: str, magnitude: str, angle: str, scale: float, periods: int) -> Effect:
    return Effect(name, (magnitude, angle), scale, periods)


DETERMINISTIC = (
    _axis("damping_anisotropy", "damping_anisotropy", "damping_axis", 1e-5, 4),
    _axis("frequency_split", "frequency_split", "stiffness_axis", 2e-4 * HZ, 4),
    Effect("pickoff_gain_mismatch", ("pickoff_gain_mismatch",), 1e-3),
    Effect("pickoff_nonorthogonality", ("pickoff_nonorthogonality",), 1e-3),
    Effect("drive_gain_mismatch", ("drive_gain_mismatch",), 1e-3),
    Effect("drive_nonorthogonality", ("drive_nonorthogonality",), 1e-3),
    Effect("drive_frame_rotation", ("drive_frame_rotation",), 1e-3),
    Effect("demodulation_phase_error", ("phase_error",), 1e-2),
    Effect("differential_phase_error", ("differential_phase",), 1e-2),
    Effect("residual_quadrature", ("residual_quadrature",), 1e-3),
    Effect("demodulation_offset", ("demodulation_offset",), 1e-3),
    Effect("pickoff_cubic_nonlinearity", ("pickoff_cubic",), 1e-3),
    Effect("duffing_stiffness", ("duffing",), 1e-2 * HZ),
    Effect("drive_feedthrough", ("feedthrough",), 1e-4),
    Effect("loop_delay", ("loop_delay",), 1e-3),
    Effect("coriolis_factor_error", ("bryan_factor_error",), 100 * PPM),
    Effect("virtual_rotation_gain", ("virtual_rotation_error",), 100 * PPM),
    Effect("damping_anisotropy_temperature", ("damping_anisotropy_per_kelvin",), 0.05),
    Effect("decay_time_temperature", ("decay_time_per_kelvin",), 1e-3),
    Effect("phase_temperature", ("phase_per_kelvin",), 1e-4),
    Effect("pickoff_gain_temperature", ("pickoff_gain_per_kelvin",), 1e-5),
    Effect("temperature_rate_bias", ("bias_per_temperature_rate",), 0.1 * DEG_PER_H * MINUTE),
    Effect("g_sensitive_bias", ("bias_per_acceleration",), 0.1 * DEG_PER_H / G),
    Effect("g_sensitive_gain", ("pickoff_gain_per_acceleration",), 1e-4 / G),
    _axis("input_axis_misalignment", "misalignment", "misalignment_direction", 1e-3, 1),
)
"""Effects that move a noise-free simulation."""


@dataclass(frozen=True)
class NoiseEffect:
    """A noise beyond the believed one.

    name: of the campaign format.
    field: of `Device`, and the part of `SlowNoise` that it is.
    scale: a size that is nothing special, SI.
    """

    name: str
    field: str
    scale: float

    @property
    def key(self) -> Key:
        """Its parameter, as files name it."""
        return next(key for key in KEYS if key.field == self.field)


NOISES = (
    NoiseEffect("angle_random_walk", "angle_random_walk", 1e-3 * DEG_PER_SQRT_H),
    NoiseEffect("rate_random_walk", "rate_random_walk", 1e-2 * DEG_PER_H / math.sqrt(HOUR)),
    NoiseEffect("bias_instability", "bias_instability", 1e-2 * DEG_PER_H),
    NoiseEffect("angle_white_noise", "pickoff_noise", 0.1 * ARCSEC),
    NoiseEffect("angle_quantisation", "angle_quantum", 0.3 * ARCSEC),
)


@dataclass(frozen=True)
class Catalogue:
    """What a diagnosis may name."""

    effects: tuple[Effect, ...] = DETERMINISTIC
    noises: tuple[NoiseEffect, ...] = NOISES

    def without(self, names: Collection[str]) -> "Catalogue":
        """One that lacks these."""
        return Catalogue(
            tuple(effect for effect in self.effects if effect.name not in names),
            tuple(noise for noise in self.noises if noise.name not in names),
        )


WHOLE = Catalogue()
NAMES = tuple(effect.name for effect in (*DETERMINISTIC, *NOISES))
EFFECTS = {effect.name: effect for effect in DETERMINISTIC}
NOISE_EFFECTS = {noise.name: noise for noise in NOISES}
