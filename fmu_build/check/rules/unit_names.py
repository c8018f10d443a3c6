"""Meaning of a unit's name in SI base units, where it can be read: `rad/s2`, `km/h`, `N.m`."""

import math
import re
from dataclasses import dataclass

EXPONENTS = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")


@dataclass(frozen=True)
class Dimension:
    """Base units with exponents: value in base units = factor * value + offset."""

    exponents: tuple[int, ...]
    factor: float = 1.0
    offset: float = 0.0

    def __str__(self) -> str:
        terms = [f"{n}{e}" for n, e in zip(EXPONENTS, self.exponents, strict=True) if e]
        return ".".join(terms) or "1"

    @property
    def in_si(self) -> tuple[int, ...]:
        """Exponents without that of the radian, which is 1 in the SI."""
        return self.exponents[:-1]

    def times(self, other: "Dimension", power: int) -> "Dimension":
        """Product with a power of another; offsets are lost, as those of intervals are."""
        pairs = zip(self.exponents, other.exponents, strict=True)
        return Dimension(tuple(a + power * b for a, b in pairs), self.factor * other.factor**power)

    def per_second(self) -> "Dimension":
        """The dimension of its derivative in time."""
        return self.times(_unit(s=1), -1)

    def same_as(self, other: "Dimension") -> bool:
        """Whether numbers in both mean the same."""
        return self.in_si == other.in_si and math.isclose(self.factor, other.factor, rel_tol=1e-6)


def _unit(factor: float = 1.0, offset: float = 0.0, **exponents: int) -> Dimension:
    return Dimension(tuple(exponents.get(name, 0) for name in EXPONENTS), factor, offset)


PREFIXED = {
    "m": _unit(m=1),
    "g": _unit(1e-3, kg=1),
    "s": _unit(s=1),
    "A": _unit(A=1),
    "K": _unit(K=1),
    "mol": _unit(mol=1),
    "cd": _unit(cd=1),
    "rad": _unit(rad=1),
    "N": _unit(kg=1, m=1, s=-2),
    "Pa": _unit(kg=1, m=-1, s=-2),
    "J": _unit(kg=1, m=2, s=-2),
    "W": _unit(kg=1, m=2, s=-3),
    "V": _unit(kg=1, m=2, s=-3, A=-1),
    "C": _unit(A=1, s=1),
    "F": _unit(kg=-1, m=-2, s=4, A=2),
    "H": _unit(kg=1, m=2, s=-2, A=-2),
    "T": _unit(kg=1, s=-2, A=-1),
    "Wb": _unit(kg=1, m=2, s=-2, A=-1),
    "Ohm": _unit(kg=1, m=2, s=-3, A=-2),
    "S": _unit(kg=-1, m=-2, s=3, A=2),
    "bar": _unit(1e5, kg=1, m=-1, s=-2),
    "l": _unit(1e-3, m=3),
}
"""Units that take a prefix."""

PLAIN = {
    "1": _unit(),
    "%": _unit(0.01),
    "min": _unit(60.0, s=1),
    "h": _unit(3600.0, s=1),
    "d": _unit(86400.0, s=1),
    "deg": _unit(math.pi / 180, rad=1),
    "arcsec": _unit(math.pi / 648000, rad=1),
    "rev": _unit(2 * math.pi, rad=1),
    "degC": _unit(1.0, 273.15, K=1),
    "degF": _unit(5 / 9, 459.67 * 5 / 9, K=1),
}

PREFIXES = {"G": 1e9, "M": 1e6, "k": 1e3, "c": 1e-2, "m": 1e-3, "u": 1e-6, "n": 1e-9}


HERTZ = (_unit(s=-1), _unit(2 * math.pi, rad=1, s=-1))
"""Name of a frequency's unit, and of the display unit of a circular frequency."""


def find_meanings(name: str) -> tuple[Dimension, ...]:
    """What a unit's name may mean, in Modelica's notation: a dot multiplies, all after the one
    slash divides. None where it can't be read for certain."""
    if name == "Hz":
        return HERTZ
    if name in PLAIN:
        return (PLAIN[name],)
    if not name:
        return ()
    above, _, below = name.partition("/")
    result = _unit()
    for factors, sign in ((above, 1), (below.strip("()"), -1)):
        for factor in factors.split(".") if factors else []:
            match = re.fullmatch(r"([A-Za-z%]+|1)(-?\d+)?", factor)
            known = _symbol(match.group(1)) if match else None
            if match is None or known is None:
                return ()
            result = result.times(known, sign * int(match.group(2) or 1))
    return (result,)


def _symbol(symbol: str) -> Dimension | None:
    if symbol in PLAIN:
        return PLAIN[symbol]
    if symbol in PREFIXED:
        return PREFIXED[symbol]
    base = PREFIXED.get(symbol[1:])
    if base is not None and symbol[0] in PREFIXES:
        return _unit().times(base, 1).times(_unit(PREFIXES[symbol[0]]), 1)
    return None
