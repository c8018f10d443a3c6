"""The effects that a diagnosis may name, each through parameters of the device.

They follow from the declarations of the device's parameters (`pyhrg.device.declarations`). Names,
keys and units are the record format's.
"""

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly
from pyhrg.common.toml_table import Key
from pyhrg.device.declarations import Family, read_declarations
from pyhrg.device.device import Device
from pyhrg.device.keys import KEYS


@dataclass(frozen=True)
class Effect:
    """An error of the gyro, as a vector on which the outputs depend almost linearly.

    name: in the record format.
    fields: of `Device`: one value, or a magnitude and its angle if `periods` is not 0.
    scale: typical size in a trimmed gyro of this class, SI.
    periods: m, of the effect while the angle makes a full turn. The vector is then
        magnitude (cos m angle, sin m angle).
    family: what is wrong: the gyro, a nominal value, the bench or the record.
    tolerance, relative_tolerance: standard deviation of a component about the stated value, SI, or
        over the stated value if that is larger; 0 for an effect of the gyro.
    imitators: names of errors of the bench that no test of a gyro can tell from it.
    """

    name: str
    fields: tuple[str, ...]
    scale: float
    periods: int = 0
    family: Family = "gyro"
    tolerance: float = 0.0
    relative_tolerance: float = 0.0
    imitators: tuple[str, ...] = ()

    @property
    def size(self) -> int:
        """Number of components of the vector."""
        return len(self.fields)

    @property
    def keys(self) -> tuple[Key, ...]:
        """Keys of its parameters in files."""
        return tuple(next(key for key in KEYS if key.field == name) for name in self.fields)

    @property
    def bounds(self) -> tuple[float, float]:
        """Least and largest value (or magnitude) that a device may have, SI."""
        key = self.keys[0]
        return key.to_si(key.low), key.to_si(key.high)

    def vector(self, device: Device) -> Array:
        """(size,) the effect that a device has, SI."""
        values = [getattr(device, name) for name in self.fields]
        if not self.periods:
            return np.array(values)
        magnitude, angle = values
        return magnitude * np.array([np.cos(self.periods * angle), np.sin(self.periods * angle)])

    def tolerance_of(self, nominal: Device) -> float:
        """Standard deviation of each component about its value in a nominal device, SI."""
        stated = 0.0 if self.periods else abs(float(getattr(nominal, self.fields[0])))
        return max(self.tolerance, self.relative_tolerance * stated)

    def put(self, device: Device, vector: Array) -> Device:
        """The device with its effect set to a vector, (size,), SI; beyond `bounds` the nearest
        value within. All other parameters stay."""
        low, high = self.bounds
        if not self.periods:
            values = [min(max(float(vector[0]), low), high)]
        else:
            angle = float(np.arctan2(vector[1], vector[0])) / self.periods
            values = [min(float(np.hypot(*vector)), high), angle % (2 * math.pi / self.periods)]
        fields: dict[str, Any] = dict(zip(self.fields, values, strict=True))
        return replace(device, **fields)

    def parameters(self, vector: Array) -> dict[str, float]:
        """Values by key of the record format, in the keys' units, of a vector (size,), SI."""
        device = self.put(Device(), vector)
        return {key.name: key.from_si(getattr(device, key.field)) for key in self.keys}

    def vector_of(self, parameters: Mapping[str, float]) -> Array:
        """(size,) vector, SI, of values by key of the record format, in the keys' units."""
        values: dict[str, Any] = {key.field: key.to_si(parameters[key.name]) for key in self.keys}
        return self.vector(replace(Device(), **values))


@dataclass(frozen=True)
class NoiseEffect:
    """A noise above its believed level.

    name: in the record format.
    field: of `Device`. A level of `NoiseModel` has the same name, except of a quantization step.
    scale: typical level in a trimmed gyro of this class, SI.
    """

    name: str
    field: str
    scale: float

    @property
    def key(self) -> Key:
        """Key of its parameter in files."""
        return next(key for key in KEYS if key.field == self.field)


def _collect_effects() -> tuple[Effect, ...]:
    """Declared effects by their position, those without one last."""
    declared = [(field, d.effect) for field, d in read_declarations(Device).items() if d.effect]
    return tuple(
        Effect(e.name, (field, e.angle) if e.angle else (field,), e.scale, e.periods)
        for field, e in sorted(declared, key=lambda pair: pair[1].position)
    )


DETERMINISTIC = _collect_effects()
"""Effects that change a simulation without noise."""
KNOWN = tuple(
    Effect(
        k.name,
        (field, k.angle) if k.angle else (field,),
        k.scale,
        k.periods,
        k.family,
        k.tolerance,
        k.relative_tolerance,
        k.imitators,
    )
    for field, declaration in read_declarations(Device).items()
    if (k := declaration.tolerance)
)
"""Nominal values, and properties of bench and record, that are known within a tolerance."""
NOISES = tuple(
    NoiseEffect(declared.noise.name, field, declared.noise.scale)
    for field, declared in read_declarations(Device).items()
    if declared.noise
)
"""Effects that change the noise alone."""


@dataclass(frozen=True)
class Catalogue:
    """What a diagnosis may name.

    effects: errors of the gyro; noises: noises above their levels; known: nominal values, and
    properties of bench and record, that are known within a tolerance.
    """

    effects: tuple[Effect, ...] = DETERMINISTIC
    noises: tuple[NoiseEffect, ...] = NOISES
    known: tuple[Effect, ...] = KNOWN

    __repr__ = describe_briefly

    @property
    def parameters(self) -> tuple[Effect, ...]:
        """All that changes a simulation: the gyro's effects, then the known parameters."""
        return (*self.effects, *self.known)

    def with_tolerances(self, tolerances: Mapping[str, float]) -> "Catalogue":
        """The catalogue with stated tolerances, by key in files and in the key's unit, in place of
        the declared ones. A gyro's effect that has one is a nominal value."""

        def state(effect: Effect) -> Effect:
            key, family = effect.keys[0], "nominal" if effect.family == "gyro" else effect.family
            tolerance = tolerances[key.name] * key.factor
            return replace(effect, family=family, tolerance=tolerance, relative_tolerance=0.0)

        def is_stated(effect: Effect) -> bool:
            return effect.keys[0].name in tolerances

        return Catalogue(
            tuple(effect for effect in self.effects if not is_stated(effect)),
            self.noises,
            (
                *(effect for effect in self.known if not is_stated(effect)),
                *(state(effect) for effect in self.parameters if is_stated(effect)),
            ),
        )

    def without(self, names: Collection[str]) -> "Catalogue":
        """The catalogue less the effects and noises of these names."""
        return Catalogue(
            tuple(effect for effect in self.effects if effect.name not in names),
            tuple(noise for noise in self.noises if noise.name not in names),
            self.known,
        )


FULL_CATALOGUE = Catalogue()
"""All declared effects and noises."""
EFFECT_NAMES = (*(effect.name for effect in DETERMINISTIC), *(noise.name for noise in NOISES))
"""Names of all effects and noises in the record format, in the order of the catalogue."""

EFFECTS = {effect.name: effect for effect in (*DETERMINISTIC, *KNOWN)}
NOISE_EFFECTS = {noise.name: noise for noise in NOISES}
