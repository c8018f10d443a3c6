"""SystemStructure.ssd: the components of a system, and what is connected with what."""

import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from fmu_build.archive.description import format_xml
from fmu_build.archive.ssp import SPACES
from fmu_build.archive.units import read_base_units
from ins_eval.system.player.variables import (
    CASE_MOTION,
    CLIMB,
    GYROS,
    HEIGHT,
    ROW,
    SPECIFIC_FORCE,
)

NAMESPACES = SPACES | {
    "osp": "http://opensimulationplatform.com/SSP/OSPAnnotations",
}
VERSIONS = ("1.0", "2.0")
"""Versions of the standard that can be declared; what is used is alike in both."""

TRAJECTORY, ACCELEROMETERS, NAVIGATOR = "trajectory", "accelerometers", "navigator"
OUTPUTS = {
    "latitude": "rad",
    "longitude": "rad",
    "height": "m",
    "velocityNorth": "m/s",
    "velocityEast": "m/s",
    "velocityDown": "m/s",
    "heading": "rad",
    "pitch": "rad",
    "roll": "rad",
    "navigationTime": "s",
    "valid": "1",
}
"""Connectors of the navigator that nothing is connected with, and their units."""
SOURCES = {
    TRAJECTORY: "Trajectory",
    **dict.fromkeys(GYROS, "HRG"),
    ACCELEROMETERS: "Accelerometers",
    NAVIGATOR: "Navigator",
}
"""FMU of each component."""
PLACES = {TRAJECTORY: (0, 0), **{g: (40, 30 - 20 * i) for i, g in enumerate(GYROS)}}
PLACES |= {ACCELEROMETERS: (40, -30), NAVIGATOR: (80, 0)}
"""Middle of each component in a drawing, mm."""


@dataclass(frozen=True)
class Connection:
    """An output (component, variable), the input that it leads to, and their unit."""

    start: tuple[str, str]
    end: tuple[str, str]
    unit: str


def list_connections() -> list[Connection]:
    """All connections of the system."""
    moves = [
        Connection((TRAJECTORY, f"{gyro}.{name}"), (gyro, name), unit)
        for gyro in GYROS
        for name, unit in zip(CASE_MOTION, ("rad/s", "m/s2", "m/s2", "m/s2"), strict=True)
    ]
    forces = [Connection((TRAJECTORY, n), (ACCELEROMETERS, n), "m/s2") for n in SPECIFIC_FORCE]
    angles = [
        Connection((gyro, "gyroAngle"), (NAVIGATOR, f"gyroAngle[{i}]"), "rad")
        for i, gyro in enumerate(GYROS, 1)
    ]
    sums = [
        Connection((ACCELEROMETERS, f"velocity[{i}]"), (NAVIGATOR, f"velocity[{i}]"), "m/s")
        for i in (1, 2, 3)
    ]
    return [
        *moves,
        *forces,
        Connection((TRAJECTORY, ROW), (ACCELEROMETERS, ROW), "1"),
        *angles,
        *sums,
        Connection((TRAJECTORY, ROW), (NAVIGATOR, ROW), "1"),
        Connection((TRAJECTORY, HEIGHT), (NAVIGATOR, HEIGHT), "m"),
        Connection((TRAJECTORY, CLIMB), (NAVIGATOR, CLIMB), "m/s"),
    ]


def describe_structure(
    name: str, description: str, sets: Sequence[str], interval: float, stop: float, version: str
) -> str:
    """SystemStructure.ssd.

    sets: components that have a parameter set; interval: communication step, s; stop: time at which
    all of the motion is navigated, s; version: one of `VERSIONS`.
    """
    for prefix, uri in NAMESPACES.items():
        ET.register_namespace(prefix, uri)
    root = _tag("ssd", "SystemStructureDescription", {"name": name, "version": version})
    system = _add(root, "ssd", "System", {"name": "system", "description": description})
    elements = _add(system, "ssd", "Elements")
    units = _collect_connectors()
    for component in SOURCES:
        _describe_component(elements, component, units[component], component in sets)
    connections = _add(system, "ssd", "Connections")
    for connection in list_connections():
        given = dict(zip(("startElement", "startConnector"), connection.start, strict=True))
        given |= dict(zip(("endElement", "endConnector"), connection.end, strict=True))
        _add(connections, "ssd", "Connection", given)
    _describe_units(root, {unit for listed in units.values() for _, unit in listed.values()})
    times = {"startTime": "0", "stopTime": repr(stop)}
    experiment = _add(root, "ssd", "DefaultExperiment", times)
    annotations = _add(experiment, "ssd", "Annotations")
    annotation = _add(annotations, "ssc", "Annotation", {"type": "com.opensimulationplatform"})
    algorithm = _add(annotation, "osp", "Algorithm")
    _add(algorithm, "osp", "FixedStepAlgorithm", {"baseStepSize": repr(interval)})
    return format_xml(root)


def _collect_connectors() -> dict[str, dict[str, tuple[str, str]]]:
    """Kind and unit of each component's connectors by name."""
    connectors: dict[str, dict[str, tuple[str, str]]] = {component: {} for component in SOURCES}
    for connection in list_connections():
        for (component, name), kind in ((connection.start, "output"), (connection.end, "input")):
            connectors[component][name] = kind, connection.unit
    connectors[NAVIGATOR] |= {name: ("output", unit) for name, unit in OUTPUTS.items()}
    return connectors


def _describe_component(
    parent: ET.Element,
    component: str,
    connectors: Mapping[str, tuple[str, str]],
    has_parameters: bool,
) -> None:
    given = {"name": component, "source": f"resources/{SOURCES[component]}.fmu"}
    given["type"] = "application/x-fmu-sharedlibrary"
    element = _add(parent, "ssd", "Component", given)
    listed = _add(element, "ssd", "Connectors")
    for name, (kind, unit) in connectors.items():
        connector = _add(listed, "ssd", "Connector", {"name": name, "kind": kind})
        _add(connector, "ssc", "Real", {"unit": unit})
    x, y = PLACES[component]
    corners = {"x1": x - 12, "y1": y - 8, "x2": x + 12, "y2": y + 8}
    _add(element, "ssd", "ElementGeometry", {k: str(v) for k, v in corners.items()})
    if has_parameters:
        bindings = _add(element, "ssd", "ParameterBindings")
        _add(bindings, "ssd", "ParameterBinding", {"source": f"resources/{component}.ssv"})


def _describe_units(root: ET.Element, names: set[str]) -> None:
    units = _add(root, "ssd", "Units")
    for name in sorted(names):
        unit = _add(units, "ssc", "Unit", {"name": name})
        _add(unit, "ssc", "BaseUnit", read_base_units(name) or {})


def _tag(prefix: str, name: str, given: Mapping[str, str]) -> ET.Element:
    return ET.Element(f"{{{NAMESPACES[prefix]}}}{name}", dict(given))


def _add(
    parent: ET.Element, prefix: str, name: str, given: Mapping[str, str] | None = None
) -> ET.Element:
    element = _tag(prefix, name, given or {})
    parent.append(element)
    return element
