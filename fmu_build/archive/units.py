"""Units that an FMU declares, by base units, and the display units that they are shown in."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable

DISPLAY_UNITS: dict[tuple[str, str], tuple[float, float]] = {
    ("rad", "deg"): (180 / math.pi, 0.0),
    ("rad/s", "deg/h"): (180 / math.pi * 3600, 0.0),
    ("rad/s", "Hz"): (0.5 / math.pi, 0.0),
    ("K", "degC"): (1.0, -273.15),
}
"""Factor and offset of a unit's display unit: display value = factor * value + offset."""


def read_base_units(name: str) -> dict[str, str] | None:
    """Exponents of the SI base units, by the unit's name in Modelica's notation: `rad.s/K`. None
    for a unit with a root, as those of noise: exponents of both standards are whole."""
    if "sqrt(" in name:
        return None
    above, _, below = name.partition("/")
    exponents = {}
    for factors, sign in ((above, ""), (below, "-")):
        for factor in factors.split("."):
            power = re.fullmatch(r"(K|m|rad|s)(\d*)", factor)
            if power:
                exponents[power[1]] = f"{sign}{power[2] or 1}"
            elif factor not in ("", "1"):
                raise ValueError(f"unit {name} is not among products of K, m, rad and s")
    return exponents


def add_unit_definitions(root: ET.Element, used: Iterable[tuple[str, str]]) -> None:
    """Append `UnitDefinitions`, alike in FMI 2.0 and 3.0, for pairs of unit and display unit, which
    may be empty."""
    pairs = set(used)
    definitions = ET.SubElement(root, "UnitDefinitions")
    for name in sorted({unit for unit, _ in pairs}):
        unit = ET.SubElement(definitions, "Unit", name=name)
        base = read_base_units(name)
        if base is not None:
            ET.SubElement(unit, "BaseUnit", base)
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
