"""Variables of the flat model to modelDescription.xml, FMI 2.0 or 3.0."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from importlib.metadata import version

from fmu_build.archive.licences import read_licence
from fmu_build.archive.units import add_unit_definitions
from fmu_build.equations.case_angle import ANGLE
from fmu_build.equations.dae import Dae
from fmu_build.equations.dependencies import trace_dependencies
from fmu_build.equations.scalars import Scalar, list_variables
from fmu_build.roots import Root
from pyhrg.common.errors import HrgError

LOG_CATEGORIES = {
    "logStatusError": "Refused calls and failed steps, with the reason",
    "logStatusDiscard": "Values out of range, which were not set",
    "logEvents": "Initialization, termination, reset, restored states",
}
"""What the C shell reports, in the order of its `log_categories`."""


FMI2_CAPABILITIES = (
    "canHandleVariableCommunicationStepSize",
    "canInterpolateInputs",
    "canGetAndSetFMUstate",
    "canSerializeFMUstate",
    "providesDirectionalDerivative",
    "canNotUseMemoryManagementFunctions",
)
FMI3_CAPABILITIES = (
    "canHandleVariableCommunicationStepSize",
    "canGetAndSetFMUState",
    "canSerializeFMUState",
    "providesDirectionalDerivatives",
    "providesAdjointDerivatives",
    "providesIntermediateUpdate",
    "canReturnEarlyAfterIntermediateUpdate",
)


FMI3_KINDS = {"real": "Float64", "integer": "Int32", "switch": "Boolean"}


NO_TEXT = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""A character that XML 1.0 can't hold, such as the bell."""


def format_xml(root: ET.Element) -> str:
    """Indented text of a document, with its declaration.

    Raises:
        HrgError: a name or a description of the model holds what XML can't.
    """
    ET.indent(root)
    text = ET.tostring(root, encoding="unicode")
    if match := NO_TEXT.search(text):
        raise HrgError(
            f"a description of the model: found the character {match.group()!r}, expected text"
        )
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'


def describe_fmi2(dae: Dae, model: Root, token: str, sources: Sequence[str]) -> str:
    """modelDescription.xml of FMI 2.0, co-simulation."""
    listed = list_variables(dae, 2)
    root = make_root(
        "2.0", model.identifier, model.description, FMI2_CAPABILITIES, sources, guid=token
    )
    variables = _common(root, listed, model.step)
    for scalar in listed:
        typed = _list_type_attributes(scalar)
        shown = {name: typed.pop(name) for name in ("description",) if name in typed}
        entry = ET.SubElement(variables, "ScalarVariable", _head(scalar) | shown)
        ET.SubElement(entry, "Integer" if scalar.kind == "integer" else "Real", typed)
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
    listed = list_variables(dae, 3)
    root = make_root(
        "3.0", model.identifier, model.description, FMI3_CAPABILITIES, instantiationToken=token
    )
    if dae.settable_period is None:
        root[0].set("fixedInternalStepSize", repr(float(dae.sample_period)))
    variables = _common(root, listed, model.step)
    for scalar in listed:
        kind = FMI3_KINDS[scalar.kind]
        head = _head(scalar) | _list_type_attributes(scalar)
        if scalar.kind == "switch":
            head = _as_boolean(head)
        if scalar.causality in ("input", "output") and scalar.name != ANGLE:
            head["intermediateUpdate"] = "true"
        entry = ET.SubElement(variables, kind, head)
        if scalar.count > 1:
            ET.SubElement(entry, "Dimension", start=str(scalar.count))
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
    owners = {s.reference + e: s.reference for s in listed for e in range(s.count)}
    for kind, scalar, dependencies in _unknowns(dae, listed):
        text = " ".join(str(r) for r in sorted({owners[reference] for reference in dependencies}))
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


def make_root(
    fmi_version: str,
    identifier: str,
    description: str,
    capabilities: Sequence[str],
    sources: Sequence[str] = (),
    **token: str,
) -> ET.Element:
    """A description with its interface for co-simulation, which FMI 2.0 lists the sources in."""
    licence = read_licence()
    root = ET.Element(
        "fmiModelDescription",
        {"fmiVersion": fmi_version, "modelName": identifier, **token},
        description=description,
        version=version("hrg"),
        generationTool=f"hrg fmu_build {version('hrg')}",
        variableNamingConvention="structured",
        author=licence.author,
        copyright=licence.copyright,
        license=licence.expression,
    )
    given = {"modelIdentifier": identifier, **dict.fromkeys(capabilities, "true")}
    interface = ET.SubElement(root, "CoSimulation", given)
    if sources:
        files = ET.SubElement(interface, "SourceFiles")
        for name in sources:
            ET.SubElement(files, "File", name=name)
    return root


def _common(root: ET.Element, listed: Sequence[Scalar], step: str) -> ET.Element:
    """Units, types, log categories and default experiment, alike in both standards; returns the
    parent of the variables, still empty."""
    shown = ((s.attributes.get("unit", ""), s.attributes.get("displayUnit", "")) for s in listed)
    add_unit_definitions(root, (pair for pair in shown if pair[0]))
    is_fmi2 = root.get("fmiVersion") == "2.0"
    types = {
        s.declared.name: s.declared for s in listed if s.declared and (is_fmi2 or s.kind == "real")
    }
    definitions = ET.SubElement(root, "TypeDefinitions")
    for _, declared in sorted(types.items()):
        attributes = {
            "quantity": declared.quantity,
            "unit": declared.unit,
            "displayUnit": declared.display_unit,
        }
        attributes = {k: v for k, v in attributes.items() if v}
        head = {"name": declared.name, "description": declared.description}
        if is_fmi2:
            ET.SubElement(ET.SubElement(definitions, "SimpleType", head), "Real", attributes)
        else:
            ET.SubElement(definitions, "Float64Type", head | attributes)
    categories = ET.SubElement(root, "LogCategories")
    for name, description in LOG_CATEGORIES.items():
        ET.SubElement(categories, "Category", name=name, description=description)
    ET.SubElement(root, "DefaultExperiment", startTime="0", stopTime="10", stepSize=step)
    return ET.SubElement(root, "ModelVariables")


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


def _list_type_attributes(scalar: Scalar) -> dict[str, str]:
    declared = {"declaredType": scalar.declared.name} if scalar.declared else {}
    return declared | scalar.attributes


def _as_boolean(head: dict[str, str]) -> dict[str, str]:
    """Attributes of a real variable that is 1 or 0, as those of a Boolean."""
    numeric = {"unit", "min", "max", "nominal", "declaredType", "quantity"}
    kept = {key: text for key, text in head.items() if key not in numeric}
    if "start" in kept:
        kept["start"] = "true" if float(kept["start"]) else "false"
    return kept if kept["causality"] == "parameter" else kept | {"variability": "discrete"}


def _unknowns(dae: Dae, listed: Sequence[Scalar]) -> Iterator[tuple[str, Scalar, tuple[int, ...]]]:
    """Kind, scalar and references of the knowns it depends on; ascending, as FMI 2.0 asks."""
    calculated = [s for s in listed if s.causality in ("output", "calculatedParameter")]
    depends = trace_dependencies(dae, {s.variable for s in calculated})
    for scalar in calculated:
        if scalar.causality == "output":
            yield "Output", scalar, depends[scalar.variable].stepping
    for scalar in calculated:
        yield "InitialUnknown", scalar, depends[scalar.variable].initial
