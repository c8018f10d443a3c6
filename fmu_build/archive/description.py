"""Variables of the flat model to modelDescription.xml, FMI 2.0 or 3.0."""

import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Sequence
from importlib.metadata import version

from fmu_build.archive.licences import read_licence
from fmu_build.archive.units import add_unit_definitions
from fmu_build.archive.xml import format_xml
from fmu_build.equations.dae import Dae
from fmu_build.equations.dependencies import trace_dependencies
from fmu_build.equations.modelica import RealType
from fmu_build.equations.scalars import Scalar, list_scalars
from fmu_build.roots import Root

LOG_CATEGORIES = {
    "logStatusError": "Refused calls and failed steps, with the reason",
    "logEvents": "Initialization, termination, reset, restored states",
}
"""What the C shell reports, in the order of its `log_categories`."""


def describe_fmi2(dae: Dae, model: Root, token: str, sources: Sequence[str]) -> str:
    """modelDescription.xml of FMI 2.0, co-simulation."""
    root = _root("2.0", model, guid=token)
    simulation = ET.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=model.identifier,
        canHandleVariableCommunicationStepSize="true",
        canGetAndSetFMUstate="true",
        canSerializeFMUstate="true",
        providesDirectionalDerivative="true",
        canNotUseMemoryManagementFunctions="true",
    )
    files = ET.SubElement(simulation, "SourceFiles")
    for name in sources:
        ET.SubElement(files, "File", name=name)
    listed = list(list_scalars(dae))
    _common(root, listed, model.step, _add_simple_type)
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


def describe_fmi3(dae: Dae, model: Root, token: str) -> str:
    """modelDescription.xml of FMI 3.0, co-simulation."""
    root = _root("3.0", model, instantiationToken=token)
    ET.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=model.identifier,
        canHandleVariableCommunicationStepSize="true",
        canGetAndSetFMUState="true",
        canSerializeFMUState="true",
        providesDirectionalDerivatives="true",
        providesAdjointDerivatives="true",
        providesIntermediateUpdate="true",
        canReturnEarlyAfterIntermediateUpdate="true",
    )
    listed = list(list_scalars(dae))
    _common(root, listed, model.step, _add_float64_type)
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


def describe_build(identifier: str, sources: Sequence[str], options: Sequence[str]) -> str:
    """sources/buildDescription.xml of FMI 3.0: how the sources of C99 beside their headers are
    compiled, with options of the GCC family that give the same numbers everywhere."""
    root = ET.Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = ET.SubElement(root, "BuildConfiguration", modelIdentifier=identifier)
    files = ET.SubElement(
        configuration,
        "SourceFileSet",
        language="C99",
        compiler="clang",
        compilerOptions=" ".join(options),
    )
    for name in sources:
        ET.SubElement(files, "SourceFile", name=name)
    return format_xml(root)


def _root(fmi_version: str, model: Root, **token: str) -> ET.Element:
    licence = read_licence()
    return ET.Element(
        "fmiModelDescription",
        {"fmiVersion": fmi_version, "modelName": model.identifier, **token},
        description=model.description,
        version=version("hrg"),
        generationTool=f"hrg fmu_build {version('hrg')}",
        variableNamingConvention="structured",
        author=licence.author,
        copyright=licence.copyright,
        license=licence.expression,
    )


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
    calculated = [s for s in listed if s.causality in ("output", "calculatedParameter")]
    depends = trace_dependencies(dae, {s.variable for s in calculated})
    for scalar in calculated:
        if scalar.causality == "output":
            yield "Output", scalar, depends[scalar.variable].stepping
    for scalar in calculated:
        yield "InitialUnknown", scalar, depends[scalar.variable].initial
