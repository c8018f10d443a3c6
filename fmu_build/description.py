"""Variables of the flat model to modelDescription.xml."""

import math
import xml.etree.ElementTree as ET

from fmu_build.dae import Dae, Variable

BASE_UNITS: dict[str, dict[str, str]] = {
    "1": {},
    "s": {"s": "1"},
    "1/s": {"s": "-1"},
    "1/s2": {"s": "-2"},
    "rad": {"rad": "1"},
    "rad.s": {"rad": "1", "s": "1"},
    "rad/s": {"rad": "1", "s": "-1"},
    "rad2/s": {"rad": "2", "s": "-1"},
}
"""Exponents of the SI base units of every unit that the library uses."""

DISPLAY_UNITS: dict[str, tuple[str, float]] = {
    "rad": ("deg", 180 / math.pi),
    "rad/s": ("deg/h", 180 / math.pi * 3600),
}
"""Display unit and its factor: display value = factor * value."""


def model_description(dae: Dae, identifier: str, description: str, guid: str, version: str) -> str:
    """The FMI 2.0 description of a model for co-simulation.

    Raises:
        ValueError: a variable has a unit that is not in `BASE_UNITS`.
    """
    root = ET.Element(
        "fmiModelDescription",
        fmiVersion="2.0",
        modelName=identifier,
        guid=guid,
        description=description,
        version=version,
        generationTool=f"hrg fmu_build {version}",
        variableNamingConvention="structured",
    )
    ET.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=identifier,
        canHandleVariableCommunicationStepSize="true",
        canGetAndSetFMUstate="true",
        canSerializeFMUstate="true",
        canNotUseMemoryManagementFunctions="true",
    )
    _units(root, dae)
    categories = ET.SubElement(root, "LogCategories")
    ET.SubElement(categories, "Category", name="logStatusError", description="Refused calls")
    ET.SubElement(root, "DefaultExperiment", startTime="0", stopTime="10", stepSize="0.01")
    variables = ET.SubElement(root, "ModelVariables")
    structure: dict[str, list[int]] = {"output": [], "calculatedParameter": []}
    index = 0
    for variable in dae.variables:
        causality = fmi_causality(dae, variable)
        for element in range(variable.count):
            index += 1
            _scalar(variables, dae, variable, element, causality)
            structure.get(causality, []).append(index)
    _structure(root, structure)
    ET.indent(root)
    text = ET.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'


def fmi_causality(dae: Dae, variable: Variable) -> str:
    """Causality in the sense of FMI 2.0."""
    if variable.role == "parameter":
        settable = variable.tunable and dae.literal(variable.binding) is not None
        return "parameter" if settable else "calculatedParameter"
    return variable.causality if "." not in variable.name else "local"


def _units(root: ET.Element, dae: Dae) -> None:
    definitions = ET.SubElement(root, "UnitDefinitions")
    for name in sorted({v.unit for v in dae.variables if v.unit}):
        if name not in BASE_UNITS:
            raise ValueError(f"unit {name} is not among {', '.join(BASE_UNITS)}")
        unit = ET.SubElement(definitions, "Unit", name=name)
        ET.SubElement(unit, "BaseUnit", BASE_UNITS[name])
        if name in DISPLAY_UNITS:
            display, factor = DISPLAY_UNITS[name]
            ET.SubElement(unit, "DisplayUnit", name=display, factor=repr(factor))


def _scalar(parent: ET.Element, dae: Dae, variable: Variable, element: int, causality: str) -> None:
    entry = ET.SubElement(
        parent,
        "ScalarVariable",
        name=variable.element_name(element),
        valueReference=str(variable.offset + element),
        causality=causality,
        variability=_variability(variable, causality),
    )
    if variable.description:
        entry.set("description", variable.description)
    if causality not in ("parameter", "input"):
        entry.set("initial", "calculated")
    kind = ET.SubElement(entry, "Integer" if variable.scalar == "integer" else "Real")
    whole = variable.scalar == "integer"
    if variable.unit:
        kind.set("unit", variable.unit)
        if variable.unit in DISPLAY_UNITS:
            kind.set("displayUnit", DISPLAY_UNITS[variable.unit][0])
    bounds = {"min": variable.minimum, "max": variable.maximum, "nominal": variable.nominal}
    for name, node in bounds.items():
        value = dae.literal(node)
        if value is not None:
            kind.set(name, _text(value, whole))
    if causality in ("parameter", "input"):
        start = dae.literal(variable.binding if causality == "parameter" else variable.start)
        kind.set("start", _text(start or 0.0, whole))


def _variability(variable: Variable, causality: str) -> str:
    if variable.role == "parameter":
        return "fixed"
    if variable.role == "discrete_real":
        return "discrete"
    return "discrete" if variable.scalar == "integer" else "continuous"


def _structure(root: ET.Element, structure: dict[str, list[int]]) -> None:
    parent = ET.SubElement(root, "ModelStructure")
    outputs = ET.SubElement(parent, "Outputs")
    for index in structure["output"]:
        ET.SubElement(outputs, "Unknown", index=str(index))
    initial = ET.SubElement(parent, "InitialUnknowns")
    for index in sorted(structure["output"] + structure["calculatedParameter"]):
        ET.SubElement(initial, "Unknown", index=str(index))


def _text(value: float, whole: bool) -> str:
    return str(int(value)) if whole else repr(value)
