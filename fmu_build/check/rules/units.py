"""Rules on units: a name that can be read must agree with its declaration."""

import math
from collections.abc import Mapping

from fmu_build.check.archive import Fmu, Variable
from fmu_build.check.rules.rule import Findings, rule
from fmu_build.check.rules.unit_names import EXPONENTS, Dimension, find_meanings

TOLERANCE = 1e-6
"""Relative difference of factors that counts as rounding of a written number."""


def read_declared_unit(given: Mapping[str, str]) -> Dimension:
    """A BaseUnit element as a dimension."""
    exponents = tuple(int(given.get(name, 0)) for name in EXPONENTS)
    return Dimension(exponents, float(given.get("factor", 1)), float(given.get("offset", 0)))


def dimensions(fmu: Fmu) -> dict[str, Dimension]:
    """Declared units that have base units."""
    dimensions = {}
    for unit in fmu.description.findall("UnitDefinitions/Unit"):
        base = unit.find("BaseUnit")
        if base is not None:
            dimensions[unit.get("name", "")] = read_declared_unit(base.attrib)
    return dimensions


@rule("base units and their factors are those that a unit's name means")
def base_units(fmu: Fmu) -> Findings:
    """SI Brochure, 9th edition; names that can't be read are not judged."""
    for name, dimension in dimensions(fmu).items():
        meant = find_meanings(name)
        alike = [m for m in meant if m.in_si == dimension.in_si]
        if meant and not alike:
            yield f"{name} has the base units {dimension}, expected {meant[0]}"
        elif alike and not any(m.same_as(dimension) for m in alike):
            yield f"{name} has the factor {dimension.factor!r}, expected {alike[0].factor!r}"
        elif alike and not any(_close(m.offset, dimension.offset) for m in alike):
            yield f"{name} has the offset {dimension.offset!r}, expected {alike[0].offset!r}"


@rule("factors and offsets of display units are those that the names mean")
def display_units(fmu: Fmu) -> Findings:
    """Display value = factor * value + offset."""
    for unit in fmu.description.findall("UnitDefinitions/Unit"):
        name = unit.get("name", "")
        for display in unit.findall("DisplayUnit"):
            if display.get("inverse") != "true":
                where = f"display unit {display.get('name')} of {name}"
                yield from _display_unit(where, name, display.attrib)


def _display_unit(where: str, name: str, display: Mapping[str, str]) -> Findings:
    pairs = [
        (own, shown) for own in find_meanings(name) for shown in find_meanings(display["name"])
    ]
    alike = [(own, shown) for own, shown in pairs if own.exponents == shown.exponents]
    if pairs and not alike:
        yield f"{where} has another dimension: {pairs[0][1]}, expected {pairs[0][0]}"
    factor, offset = (float(display.get(k, d)) for k, d in (("factor", 1), ("offset", 0)))
    expected = [(o.factor / s.factor, (o.offset - s.offset) / s.factor) for o, s in alike]
    if expected and not any(_close(factor, f) and _close(offset, o) for f, o in expected):
        yield (
            f"{where} has the factor {factor!r} and the offset {offset!r}, "
            f"expected {expected[0][0]!r} and {expected[0][1]!r}"
        )


def _close(first: float, second: float) -> bool:
    return math.isclose(first, second, rel_tol=TOLERANCE, abs_tol=1e-12)


@rule("a derivative has the unit of its state over seconds")
def derivative_units(fmu: Fmu) -> Findings:
    """Where both are declared with base units."""
    known = dimensions(fmu)
    for variable in fmu.variables:
        state = _state_of(fmu, variable)
        if state is None:
            continue
        unit, of = (fmu.attribute(v, "unit") or "" for v in (variable, state))
        if unit in known and of in known and not known[of].per_second().same_as(known[unit]):
            yield f"{variable.name} is in {unit}, the state {state.name} in {of}"


def _state_of(fmu: Fmu, variable: Variable) -> Variable | None:
    """FMI 2.0 counts variables from 1, FMI 3.0 names a value reference."""
    target = variable.given.get("derivative", "")
    if fmu.major == 3:
        return next((v for v in fmu.variables if target and v.reference == target), None)
    number = int(target) if target.isdigit() else 0
    return fmu.variables[number - 1] if 0 < number <= len(fmu.variables) else None
