"""Variables of the flat model to modelDescription.xml, FMI 2.0 or 3.0."""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from fmu_build.dae import Dae, Variable
from fmu_build.dependencies import Dependencies, Graph

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

DISPLAY_UNITS: dict[str, tuple[str, float, float]] = {
    "rad": ("deg", 180 / math.pi, 0.0),
    "rad/s": ("deg/h", 180 / math.pi * 3600, 0.0),
    "K": ("degC", 1.0, -273.15),
}
"""Display unit, factor and offset: display value = factor * value + offset."""

LOG_CATEGORIES = {
    "logStatusError": "Refused calls and failed steps, with the reason",
    "logEvents": "Initialization, termination, reset, restored states",
}
"""What the C shell reports, in the order of its `log_categories`."""


@dataclass(frozen=True)
class Identity:
    """What an FMU calls itself."""

    identifier: str
    description: str
    token: str
    version: str
    sources: tuple[str, ...]
    step: str


@dataclass(frozen=True)
class Scalar:
    """One scalar variable as both standards describe it."""

    name: str
    reference: int
    causality: str
    variability: str
    whole: bool
    attributes: dict[str, str]
    """description, unit, displayUnit, min, max, nominal, start: those that apply."""


def scalars(dae: Dae) -> Iterator[Scalar]:
    """All scalars of a model, in the order of their value references."""
    for variable in dae.variables:
        causality = fmi_causality(dae, variable)
        for element in range(variable.count):
            yield Scalar(
                name=variable.element_name(element),
                reference=variable.offset + element,
                causality=causality,
                variability=_variability(variable),
                whole=variable.scalar == "integer",
                attributes=_attributes(dae, variable, element, causality),
            )


def fmi_causality(dae: Dae, variable: Variable) -> str:
    """Causality in the sense of FMI."""
    if variable.role == "parameter":
        settable = variable.tunable and dae.is_constant(variable.binding, variable.count)
        return "parameter" if settable else "calculatedParameter"
    return variable.causality if "." not in variable.name else "local"


def fmi2_description(dae: Dae, identity: Identity) -> str:
    """modelDescription.xml of FMI 2.0, co-simulation.

    Raises:
        ValueError: a variable has a unit that is not in `BASE_UNITS`.
    """
    root = _root("2.0", identity, guid=identity.token)
    simulation = ET.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=identity.identifier,
        canHandleVariableCommunicationStepSize="true",
        canGetAndSetFMUstate="true",
        canSerializeFMUstate="true",
        providesDirectionalDerivative="true",
        canNotUseMemoryManagementFunctions="true",
    )
    files = ET.SubElement(simulation, "SourceFiles")
    for name in identity.sources:
        ET.SubElement(files, "File", name=name)
    _common(root, dae, identity.step)
    variables = ET.SubElement(root, "ModelVariables")
    listed = list(scalars(dae))
    for scalar in listed:
        entry = ET.SubElement(
            variables,
            "ScalarVariable",
            name=scalar.name,
            valueReference=str(scalar.reference),
            causality=scalar.causality,
            variability=scalar.variability,
        )
        rest = dict(scalar.attributes)
        if "description" in rest:
            entry.set("description", rest.pop("description"))
        if scalar.causality not in ("parameter", "input"):
            entry.set("initial", "calculated")
        ET.SubElement(entry, "Integer" if scalar.whole else "Real", rest)
    structure = ET.SubElement(root, "ModelStructure")
    outputs, initial = (ET.SubElement(structure, x) for x in ("Outputs", "InitialUnknowns"))
    depends = _dependencies(dae)
    for index, scalar in enumerate(listed, 1):
        if scalar.causality == "output":
            knowns = _listed(i + 1 for i in depends[scalar.reference].stepping)
            ET.SubElement(outputs, "Unknown", index=str(index), dependencies=knowns)
        if scalar.causality in ("output", "calculatedParameter"):
            knowns = _listed(i + 1 for i in depends[scalar.reference].initial)
            ET.SubElement(initial, "Unknown", index=str(index), dependencies=knowns)
    return _text(root)


def fmi3_description(dae: Dae, identity: Identity) -> str:
    """modelDescription.xml of FMI 3.0, co-simulation.

    Raises:
        ValueError: a variable has a unit that is not in `BASE_UNITS`.
    """
    root = _root("3.0", identity, instantiationToken=identity.token)
    ET.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=identity.identifier,
        canHandleVariableCommunicationStepSize="true",
        canGetAndSetFMUState="true",
        canSerializeFMUState="true",
        providesDirectionalDerivatives="true",
        providesAdjointDerivatives="true",
        providesIntermediateUpdate="true",
        canReturnEarlyAfterIntermediateUpdate="true",
    )
    _common(root, dae, identity.step)
    variables = ET.SubElement(root, "ModelVariables")
    structure = ET.Element("ModelStructure")
    listed = list(scalars(dae))
    for scalar in listed:
        entry = ET.SubElement(
            variables,
            "Int32" if scalar.whole else "Float64",
            {"name": scalar.name, "valueReference": str(scalar.reference)},
            causality=scalar.causality,
            variability=scalar.variability,
        )
        if scalar.causality not in ("parameter", "input"):
            entry.set("initial", "calculated")
        entry.attrib.update(scalar.attributes)
    ET.SubElement(
        variables,
        "Float64",
        name="time",
        valueReference=str(dae.scalar_count),
        causality="independent",
        variability="continuous",
        description="Simulation time",
        unit="s",
    )
    root.append(structure)
    depends = _dependencies(dae)
    for kind, phase, causalities in (
        ("Output", "stepping", ("output",)),
        ("InitialUnknown", "initial", ("output", "calculatedParameter")),
    ):
        for scalar in listed:
            if scalar.causality in causalities:
                knowns = _listed(getattr(depends[scalar.reference], phase))
                reference = str(scalar.reference)
                ET.SubElement(structure, kind, valueReference=reference, dependencies=knowns)
    return _text(root)


def _dependencies(dae: Dae) -> dict[int, Dependencies]:
    """Of every scalar that is an output or a calculated parameter, by value reference."""
    graph = Graph(dae)
    return {
        variable.offset + element: graph.of(index)
        for index, variable in enumerate(dae.variables)
        if fmi_causality(dae, variable) in ("output", "calculatedParameter")
        for element in range(variable.count)
    }


def _listed(numbers: Iterable[int]) -> str:
    return " ".join(str(number) for number in numbers)


def _root(fmi_version: str, identity: Identity, **token: str) -> ET.Element:
    return ET.Element(
        "fmiModelDescription",
        {"fmiVersion": fmi_version, "modelName": identity.identifier, **token},
        description=identity.description,
        version=identity.version,
        generationTool=f"hrg fmu_build {identity.version}",
        variableNamingConvention="structured",
    )


def _common(root: ET.Element, dae: Dae, step: str) -> None:
    """Units, log categories and default experiment: alike in both standards."""
    definitions = ET.SubElement(root, "UnitDefinitions")
    for name in sorted({v.unit for v in dae.variables if v.unit}):
        if name not in BASE_UNITS:
            raise ValueError(f"unit {name} is not among {', '.join(BASE_UNITS)}")
        unit = ET.SubElement(definitions, "Unit", name=name)
        ET.SubElement(unit, "BaseUnit", BASE_UNITS[name])
        if name in DISPLAY_UNITS:
            display, factor, offset = DISPLAY_UNITS[name]
            entry = ET.SubElement(unit, "DisplayUnit", name=display, factor=repr(factor))
            if offset:
                entry.set("offset", repr(offset))
    categories = ET.SubElement(root, "LogCategories")
    for name, description in LOG_CATEGORIES.items():
        ET.SubElement(categories, "Category", name=name, description=description)
    ET.SubElement(root, "DefaultExperiment", startTime="0", stopTime="10", stepSize=step)


def _variability(variable: Variable) -> str:
    if variable.role == "parameter":
        return "fixed"
    return "discrete" if variable.role == "discrete_real" else "continuous"


def _attributes(dae: Dae, variable: Variable, element: int, causality: str) -> dict[str, str]:
    whole = variable.scalar == "integer"
    result = {}
    if variable.description:
        result["description"] = variable.description
    if variable.unit:
        result["unit"] = variable.unit
        if variable.unit in DISPLAY_UNITS:
            result["displayUnit"] = DISPLAY_UNITS[variable.unit][0]
    bounds = {"min": variable.minimum, "max": variable.maximum, "nominal": variable.nominal}
    for name, node in bounds.items():
        value = dae.constant(node, element)
        if value is not None:
            result[name] = _number(value, whole)
    if causality in ("parameter", "input"):
        node = variable.binding if causality == "parameter" else variable.start
        result["start"] = _number(dae.constant(node, element) or 0.0, whole)
    return result


def _number(value: float, whole: bool) -> str:
    return str(int(value)) if whole else repr(value)


def _text(root: ET.Element) -> str:
    ET.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n'
