"""A device as a parameter set of the SSP standard, which tools set an FMU's parameters by."""

import xml.etree.ElementTree as ET
from collections.abc import Mapping

from fmu_build.archive.description import format_xml
from pyhrg.device.device import Device

NAMESPACE = "http://ssp-standard.org/SSP1/SystemStructureParameterValues"

INTEGERS = frozenset({"seed", "controller.forceToRebalance"})
"""Parameters of the FMU that are integers."""


def format_parameter_set(device: Device) -> str:
    """Text of a file of SystemStructureParameterValues 1.0 (`.ssv`): the start angle, and the FMU's
    parameters that differ from its defaults, by the FMU's names, in its units."""
    return format_values(
        device.name, {"startAngle": device.power_on_angle, **device.fmu_parameters()}
    )


def format_values(name: str, values: Mapping[str, float]) -> str:
    """Text of such a file: the name of the set, and its values by an FMU's names, in its units."""
    ET.register_namespace("ssv", NAMESPACE)
    root = ET.Element(f"{{{NAMESPACE}}}ParameterSet", version="1.0", name=name)
    parameters = ET.SubElement(root, f"{{{NAMESPACE}}}Parameters")
    for key, value in sorted(values.items()):
        parameter = ET.SubElement(parameters, f"{{{NAMESPACE}}}Parameter", name=key)
        if key in INTEGERS:
            ET.SubElement(parameter, f"{{{NAMESPACE}}}Integer", value=str(int(value)))
        else:
            ET.SubElement(parameter, f"{{{NAMESPACE}}}Real", value=repr(float(value)))
    return format_xml(root)
