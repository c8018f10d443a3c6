"""How a parameter of a gyro is declared: once, for files, for the FMU and for the diagnosis.

A field of a dataclass is declared by `parameter`. From the declarations follow the keys of device
files (`pyhrg.device.keys`), the names in the FMU (`pyhrg.device.fmu_parameters`), the catalogue of
effects (`pyhrg.gap.effects.catalogue`), the errors of a flight's budget (`pyhrg.device.causes`)
and the coordinates that an effect shows in (`pyhrg.challenge.scoring.score`).
"""

import math
import re
from dataclasses import dataclass, field, fields
from typing import Literal


@dataclass(frozen=True)
class EffectDeclaration:
    """Declares that a parameter may be wrong: an effect that a diagnosis may name, or a noise that
    may exceed its believed level.

    Attributes:
        name: name in the record format.
        scale: typical size in a trimmed gyro of this class, SI.
        coordinates: coordinates in which the greatest share of the gap may lie, by their names in
            the record format.
        position: place in the catalogue, which decides the order of sums; effects without one come
            last, in the order of the fields.
        angle: field of the angle that goes with a magnitude; empty if the parameter stands alone.
        periods: number of periods of the effect while that angle makes a full turn.
    """

    name: str
    scale: float
    coordinates: tuple[str, ...]
    position: float = math.inf
    angle: str = ""
    periods: int = 0


Family = Literal["gyro", "nominal", "bench", "record"]
"""What is wrong: the gyro; a value that is stated of it; the bench; or the record."""


@dataclass(frozen=True)
class ToleranceDeclaration:
    """Declares that a parameter is known from elsewhere within a tolerance: a nominal value, or one
    of the bench.

    Attributes:
        name: name of the cause in the record format if the value is off by more.
        family: see `Family`.
        scale: typical size of a change of it, SI; a sensitivity is taken over a share of it
            (docs/methods/effects.md, Eq. 1).
        tolerance: one standard deviation of the true value about the stated one, SI.
        relative_tolerance: the same over the stated value; the larger of the two holds.
        angle, periods: see `EffectDeclaration`.
        imitators: names of other errors of the bench that do the same to a gyro in every test.
    """

    name: str
    family: Family
    scale: float
    tolerance: float = 0.0
    relative_tolerance: float = 0.0
    angle: str = ""
    periods: int = 0
    imitators: tuple[str, ...] = ()


@dataclass(frozen=True)
class Declaration:
    """What a field declares; see `parameter`."""

    keys: tuple[str, ...]
    limits: tuple[float, float]
    unit: float
    zero: float
    fmu: tuple[str, ...]
    effect: EffectDeclaration | None
    noise: EffectDeclaration | None
    tolerance: ToleranceDeclaration | None
    group: str

    @property
    def cause(self) -> str:
        """Name of what is wrong where the value is not the ideal one, in the record format; empty
        if the value belongs to the design."""
        if self.group:
            return self.group
        if self.effect:
            return self.effect.name
        if self.tolerance and self.tolerance.family in ("bench", "record"):
            return self.tolerance.name
        return ""


def parameter(
    default: float = 0.0,
    *,
    key: str | tuple[str, ...],
    limits: tuple[float, float],
    unit: float = 1.0,
    zero: float = 0.0,
    fmu: str | tuple[str, ...] = (),
    effect: EffectDeclaration | None = None,
    noise: EffectDeclaration | None = None,
    tolerance: ToleranceDeclaration | None = None,
    group: str = "",
) -> float:
    """A field of a dataclass that is a parameter of a gyro.

    Args:
        default: value of an ideal gyro, SI; the FMU's own.
        key: name in files, with its unit; of several names the first is written.
        limits: least and largest value in files, in the key's unit.
        unit: factor from the key's unit to SI, pi/180 for deg.
        zero: value in SI of 0 in the key's unit.
        fmu: names of the FMU's parameters and inputs that take the value as it stands; none if the
            FMU defines it otherwise (`pyhrg.device.fmu_parameters`) or does not have it.
        effect: set if a diagnosis may name it.
        noise: set if a diagnosis may find it as a noise.
        tolerance: set if it is known within a tolerance; a diagnosis identifies it with all else.
        group: name of the error that this parameter makes together with others; that of its effect
            if empty.
    """
    declaration = Declaration(
        keys=(key,) if isinstance(key, str) else key,
        limits=limits,
        unit=unit,
        zero=zero,
        fmu=(fmu,) if isinstance(fmu, str) else fmu,
        effect=effect,
        noise=noise,
        tolerance=tolerance,
        group=group,
    )
    return field(default=default, metadata={"declaration": declaration})


def read_declarations(parameters: type) -> dict[str, Declaration]:
    """Declarations of a dataclass by field, in the order of its fields."""
    return {
        f.name: f.metadata["declaration"] for f in fields(parameters) if "declaration" in f.metadata
    }


USUAL = {
    "g sensitive": "g-sensitive",
    "coriolis": "Coriolis",
    "duffing": "Duffing",
    "pickoff": "pick-off",
    "nonorthogonality": "non-orthogonality",
}
"""Words as they are usually written, by those of the record format."""


def format_effect(name: str) -> str:
    """An effect's name in words, with the field's hyphens and capitals."""
    words = re.sub("(?<!nominal)_temperature$", "_over_temperature", name).replace("_", " ")
    for plain, usual in USUAL.items():
        words = words.replace(plain, usual)
    return words
