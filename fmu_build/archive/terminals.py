"""terminalsAndIcons.xml: inputs and outputs in the groups that a system is wired by."""

import xml.etree.ElementTree as ET

from fmu_build.archive.description import format_xml
from fmu_build.equations.dae import Dae
from fmu_build.equations.scalars import list_scalars

TERMINALS = (
    (
        "caseMotion",
        "Motion of the case: from a trajectory, a rate table or a vehicle",
        (
            "angularRate",
            "caseAngle",
            "accelerationX",
            "accelerationY",
            "accelerationZ",
            "vibration",
            "specificForce[1]",
            "specificForce[2]",
            "specificForce[3]",
        ),
    ),
    ("sequence", "Which interval of a motion begins", ("row",)),
    ("environment", "Temperature of the case", ("caseTemperature",)),
    (
        "commands",
        "Commands to the electronics",
        ("virtualRotation", "amplitudeSetpoint", "biasVoltage", "phaseOffset", "driveOn"),
    ),
    (
        "readings",
        "What gyros and accelerometers have summed up",
        (*(f"gyroAngle[{i}]" for i in (1, 2, 3)), *(f"velocity[{i}]" for i in (1, 2, 3))),
    ),
    ("heightReference", "What holds the height", ("referenceHeight", "referenceClimbRate")),
    (
        "exchange",
        "Between resonator and electronics, every control period",
        (
            *(f"reading[{i}]" for i in range(1, 5)),
            *(f"force[{i}]" for i in range(1, 5)),
            *("pump", "reference", "commandedRate", "isHeld"),
        ),
    ),
    (
        "measurement",
        "What the gyro reports, or the navigator",
        (
            "gyroAngle",
            "gyroRate",
            "latitude",
            "longitude",
            "height",
            "velocityNorth",
            "velocityEast",
            "velocityDown",
            "heading",
            "pitch",
            "roll",
            "navigationTime",
            "valid",
        ),
    ),
    (
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
"""Name, description and members of each plug; members are matched by name."""


def describe_terminals(dae: Dae) -> str:
    """terminalsAndIcons.xml; terminals hold those members that the model has."""
    known = {s.name for s in list_scalars(dae) if s.causality in ("input", "output")}
    root = ET.Element("fmiTerminalsAndIcons", fmiVersion="3.0")
    graphics = ET.SubElement(root, "GraphicalRepresentation")
    extent = {"x1": "-100", "y1": "-100", "x2": "100", "y2": "100"}
    ET.SubElement(graphics, "CoordinateSystem", extent, suggestedScalingFactorTo_mm="0.1")
    ET.SubElement(graphics, "Icon", extent)
    parent = ET.SubElement(root, "Terminals")
    for terminal, description, names in TERMINALS:
        members = [name for name in names if name in known]
        if members:
            given = {"name": terminal, "matchingRule": "plug", "description": description}
            entry = ET.SubElement(parent, "Terminal", given)
            for name in members:
                given = {"variableName": name, "memberName": name, "variableKind": "signal"}
                ET.SubElement(entry, "TerminalMemberVariable", given)
    return format_xml(root)
