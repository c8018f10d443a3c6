"""terminalsAndIcons.xml: inputs and outputs in the groups that a system is wired by."""

import xml.etree.ElementTree as ET
from dataclasses import dataclass

from fmu_build.archive.xml import format_xml
from fmu_build.equations.dae import Dae
from fmu_build.equations.scalars import list_scalars


@dataclass(frozen=True)
class Terminal:
    """A plug: members are matched by name."""

    name: str
    description: str
    members: tuple[str, ...]


TERMINALS = (
    Terminal(
        "caseMotion",
        "Motion of the case: from a trajectory, a rate table or a vehicle",
        ("angularRate", "accelerationX", "accelerationY", "accelerationZ", "vibration"),
    ),
    Terminal("environment", "Temperature of the case", ("caseTemperature",)),
    Terminal(
        "commands",
        "Commands to the electronics",
        ("virtualRotation", "amplitudeSetpoint", "biasVoltage", "phaseOffset", "driveOn"),
    ),
    Terminal("measurement", "What the gyro reports", ("gyroAngle", "gyroRate", "valid")),
    Terminal(
        "telemetry",
        "What the loops know of the vibration",
        (
            "patternAngle",
            "amplitude",
            "quadrature",
            "amplitudeForce",
            "quadratureForce",
            "frequencyOffset",
        ),
    ),
)


def describe_terminals(dae: Dae) -> str:
    """terminalsAndIcons.xml; terminals hold those members that the model has."""
    known = {s.name for s in list_scalars(dae) if s.causality in ("input", "output")}
    root = ET.Element("fmiTerminalsAndIcons", fmiVersion="3.0")
    graphics = ET.SubElement(root, "GraphicalRepresentation")
    extent = {"x1": "-100", "y1": "-100", "x2": "100", "y2": "100"}
    ET.SubElement(graphics, "CoordinateSystem", extent, suggestedScalingFactorTo_mm="0.1")
    ET.SubElement(graphics, "Icon", extent)
    parent = ET.SubElement(root, "Terminals")
    for terminal in TERMINALS:
        members = [name for name in terminal.members if name in known]
        if members:
            _add_terminal(parent, terminal, members)
    return format_xml(root)


def _add_terminal(parent: ET.Element, terminal: Terminal, members: list[str]) -> None:
    entry = ET.SubElement(
        parent,
        "Terminal",
        name=terminal.name,
        matchingRule="plug",
        description=terminal.description,
    )
    for name in members:
        ET.SubElement(
            entry,
            "TerminalMemberVariable",
            variableName=name,
            memberName=name,
            variableKind="signal",
        )
