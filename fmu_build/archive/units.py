"""Units that an FMU declares, by base units, and the display units that they are shown in."""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable

BASE_UNITS: dict[str, dict[str, str]] = {
    "1": {},
    "K": {"K": "1"},
    "K/s": {"K": "1", "s": "-1"},
    "1/K": {"K": "-1"},
    "m/s2": {"m": "1", "s": "-2"},
    "s": {"s": "1"},
    "s/m": {"s": "1", "m": "-1"},
    "s2/m": {"s": "2", "m": "-1"},
    "s4/m2": {"s": "4", "m": "-2"},
    "1/s": {"s": "-1"},
    "1/s2": {"s": "-2"},
    "rad": {"rad": "1"},
    "rad/K": {"rad": "1", "K": "-1"},
    "rad.s": {"rad": "1", "s": "1"},
    "rad.s/K": {"rad": "1", "s": "1", "K": "-1"},
    "rad.s/m": {"rad": "1", "s": "1", "m": "-1"},
    "rad.s2/m": {"rad": "1", "s": "2", "m": "-1"},
    "rad/s": {"rad": "1", "s": "-1"},
    "rad2/s": {"rad": "2", "s": "-1"},
    "rad2/s2": {"rad": "2", "s": "-2"},
    "rad2/s3": {"rad": "2", "s": "-3"},
}
"""Exponents of the SI base units of every unit that the library uses."""

DISPLAY_UNITS: dict[tuple[str, str], tuple[float, float]] = {
    ("rad", "deg"): (180 / math.pi, 0.0),
    ("rad/s", "deg/h"): (180 / math.pi * 3600, 0.0),
    ("rad/s", "Hz"): (0.5 / math.pi, 0.0),
    ("K", "degC"): (1.0, -273.15),
}
"""Factor and offset of a unit's display unit: display value = factor * value + offset."""


def convert_to_display_unit(value: float, unit: str, display: str) -> float:
    """A value in its display unit."""
    factor, offset = DISPLAY_UNITS[unit, display]
    return factor * value + offset


def add_unit_definitions(root: ET.Element, used: Iterable[tuple[str, str]]) -> None:
    """Append `UnitDefinitions`, alike in FMI 2.0 and 3.0, for pairs of unit and display unit, which
    may be empty."""
    pairs = set(used)
    definitions = ET.SubElement(root, "UnitDefinitions")
    for name in sorted({unit for unit, _ in pairs}):
        if name not in BASE_UNITS:
            raise ValueError(f"unit {name} is not among {', '.join(BASE_UNITS)}")
        unit = ET.SubElement(definitions, "Unit", name=name)
        ET.SubElement(unit, "BaseUnit", BASE_UNITS[name])
        for display in sorted({d for u, d in pairs if u == name and d}):
            _add_display_unit(unit, name, display)


def _add_display_unit(parent: ET.Element, unit: str, display: str) -> None:
    if (unit, display) not in DISPLAY_UNITS:
        known = ", ".join(f"{d} of {u}" for u, d in DISPLAY_UNITS)
        raise ValueError(f"display unit {display} of {unit} is not among {known}")
    factor, offset = DISPLAY_UNITS[unit, display]
    entry = ET.SubElement(parent, "DisplayUnit", name=display, factor=repr(factor))
    if offset:
        entry.set("offset", repr(offset))
