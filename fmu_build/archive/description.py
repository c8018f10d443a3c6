"""Variables of the flat model to modelDescription.xml, FMI 2.0 or 3.0."""

import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from fmu_build.archive.units import add_unit_definitions
from fmu_build.archive.xml import format_xml
from fmu_build.equations.dae import Dae
from fmu_build.equations.dependencies import Graph
from fmu_build.equations.modelica import RealType
from fmu_build.equations.scalars import Scalar, list_scalars

LOG_CATEGORIES = {
    "logStatusError": "Refused calls and failed steps, with the reason",
    "logEvents": "Initialization, termination, reset, restored states",
}
"""What the C shell reports, in the order of its `log_categories`."""


@dataclass(frozen=True)
class Identity:
    """What an FMU calls itself; `step` is its default communication step in s, `licence` an SPDX
    expression. An attribute that is empty is left out of the description."""

    identifier: str
    description: str
    token: str
    version: str
    sources: tuple[str, ...]
    step: str
    licence: str = ""
    author: str = ""
    copyright: str = ""


def describe_fmi2(dae: Dae, identity: Identity) -> str:
    """modelDescription.xml of FMI 2.0, co-simulation.

    Raises:
        ValueError: a variable has a unit or display unit that `units.py` doesn't know.
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
    listed = list(list_scalars(dae))
    _common(root, listed, identity.step, _add_simple_type)
    variables = ET.SubElement(root, "ModelVariables")
    for scalar in listed:
        _add_scalar_variable(variables, scalar)
    structure = ET.SubElement(root, "ModelStructure")
    kinds = {"Output": "Outputs", "InitialUnknown": "InitialUnknowns"}
    parents = {kind: ET.SubElement(structure, name) for kind, name in kinds.items()}
    for kind, scalar, dependencies in _unknowns(dae, listed):
        # an index counts from 1, in the order of the variables
        text = " ".join(str(reference + 1) for reference in dependencies)
        index = str(scalar.reference + 1)
        ET.SubElement(parents[kind], "Unknown", index=index, dependencies=text)
    return format_xml(root)


def describe_fmi3(dae: Dae, identity: Identity) -> str:
    """modelDescription.xml of FMI 3.0, co-simulation.

    Raises:
        ValueError: a variable has a unit or display unit that `units.py` doesn't know.
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
    listed = list(list_scalars(dae))
    _common(root, listed, identity.step, _add_float64_type)
    variables = ET.SubElement(root, "ModelVariables")
    for scalar in listed:
        _add_typed_variable(variables, scalar)
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
    structure = ET.SubElement(root, "ModelStructure")
    for kind, scalar, dependencies in _unknowns(dae, listed):
        text = " ".join(str(reference) for reference in dependencies)
        ET.SubElement(structure, kind, valueReference=str(scalar.reference), dependencies=text)
    return format_xml(root)


def _root(fmi_version: str, identity: Identity, **token: str) -> ET.Element:
    root = ET.Element(
        "fmiModelDescription",
        {"fmiVersion": fmi_version, "modelName": identity.identifier, **token},
        description=identity.description,
        version=identity.version,
        generationTool=f"hrg fmu_build {identity.version}",
        variableNamingConvention="structured",
    )
    rights = {
        "author": identity.author,
        "copyright": identity.copyright,
        "license": identity.licence,
    }
    for name, text in rights.items():
        if text:
            root.set(name, text)
    return root


def _common(
    root: ET.Element, listed: Sequence[Scalar], step: str, add_type: Callable[..., None]
) -> None:
    """Units, types, log categories and default experiment: alike in both standards."""
    shown = ((s.attributes.get("unit", ""), s.attributes.get("displayUnit", "")) for s in listed)
    add_unit_definitions(root, (pair for pair in shown if pair[0]))
    types = {s.declared.name: s.declared for s in listed if s.declared}
    definitions = ET.SubElement(root, "TypeDefinitions")
    for _, declared in sorted(types.items()):
        attributes = {
            "quantity": declared.quantity,
            "unit": declared.unit,
            "displayUnit": declared.display_unit,
        }
        add_type(definitions, declared, {k: v for k, v in attributes.items() if v})
    categories = ET.SubElement(root, "LogCategories")
    for name, description in LOG_CATEGORIES.items():
        ET.SubElement(categories, "Category", name=name, description=description)
    ET.SubElement(root, "DefaultExperiment", startTime="0", stopTime="10", stepSize=step)


def _add_simple_type(parent: ET.Element, declared: RealType, attributes: dict[str, str]) -> None:
    entry = ET.SubElement(
        parent, "SimpleType", name=declared.name, description=declared.description
    )
    ET.SubElement(entry, "Real", attributes)


def _add_float64_type(parent: ET.Element, declared: RealType, attributes: dict[str, str]) -> None:
    head = {"name": declared.name, "description": declared.description}
    ET.SubElement(parent, "Float64Type", head | attributes)


def _add_scalar_variable(parent: ET.Element, scalar: Scalar) -> None:
    rest = _typed(scalar)
    entry = ET.SubElement(parent, "ScalarVariable", _head(scalar))
    if "description" in rest:
        entry.set("description", rest.pop("description"))
    ET.SubElement(entry, "Integer" if scalar.whole else "Real", rest)


def _add_typed_variable(parent: ET.Element, scalar: Scalar) -> None:
    kind = "Int32" if scalar.whole else "Float64"
    ET.SubElement(parent, kind, _head(scalar) | _typed(scalar))


def _head(scalar: Scalar) -> dict[str, str]:
    head = {
        "name": scalar.name,
        "valueReference": str(scalar.reference),
        "causality": scalar.causality,
        "variability": scalar.variability,
    }
    if scalar.causality not in ("parameter", "input"):
        head["initial"] = "calculated"
    return head


def _typed(scalar: Scalar) -> dict[str, str]:
    declared = {"declaredType": scalar.declared.name} if scalar.declared else {}
    return declared | scalar.attributes


def _unknowns(dae: Dae, listed: Sequence[Scalar]) -> Iterator[tuple[str, Scalar, tuple[int, ...]]]:
    """Kind, scalar and references of the knowns it depends on; ascending, as FMI 2.0 asks."""
    graph = Graph(dae)
    calculated = [s for s in listed if s.causality in ("output", "calculatedParameter")]
    depends = {index: graph.of(index) for index in {s.variable for s in calculated}}
    for scalar in calculated:
        if scalar.causality == "output":
            yield "Output", scalar, depends[scalar.variable].stepping
    for scalar in calculated:
        yield "InitialUnknown", scalar, depends[scalar.variable].initial
