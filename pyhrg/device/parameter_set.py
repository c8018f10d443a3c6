"""A device as a parameter set of the SSP standard, by which tools set an FMU's parameters."""

import xml.etree.ElementTree as ET
from collections.abc import Mapping

from fmu_build.archive.description import format_xml
from fmu_build.archive.parameter_sets import join_arrays
from fmu_build.archive.ssp import SPACES
from fmu_build.bundle import list_arrays
from fmu_build.equations.modelica import list_integers
from pyhrg.common.made_by import find_modelica
from pyhrg.device.device import Device

SET_NAME = "initialValues"
"""What every set is called: importers apply the sets of one name to a system."""


def format_parameter_set(device: Device, fmi: int = 2) -> str:
    """Text of a file of SystemStructureParameterValues 1.0 (`.ssv`): the start angle, and the FMU's
    parameters that differ from its defaults, by the FMU's names, in its units.

    Args:
        fmi: version of the FMU's standard. In FMI 3 vectors and maps are arrays; a set with one
            is of SSP 2.0.
    """
    values = {"startAngle": device.power_on_angle, **device.fmu_parameters()}
    text = format_values(values, device.name)
    return join_arrays(text, list_arrays()) if fmi == 3 else text


def format_values(values: Mapping[str, float], description: str = "") -> str:
    """Text of such a file: values by an FMU's names, in its units, and what the set is of."""
    ET.register_namespace("ssv", SPACES["ssv"])
    root = ET.Element(f"{{{SPACES['ssv']}}}ParameterSet", version="1.0", name=SET_NAME)
    if description:
        root.set("description", description)
    parameters = ET.SubElement(root, f"{{{SPACES['ssv']}}}Parameters")
    for key, value in sorted(values.items()):
        parameter = ET.SubElement(parameters, f"{{{SPACES['ssv']}}}Parameter", name=key)
        typed = convert_value(key, value)
        kind = "Integer" if isinstance(typed, int) else "Real"
        ET.SubElement(parameter, f"{{{SPACES['ssv']}}}{kind}", value=repr(typed))
    return format_xml(root)


def convert_value(name: str, value: float) -> int | float:
    """A value of an FMU's parameter in the type that the library declares: Integer or Real."""
    integers = list_integers(find_modelica())
    return int(value) if name.rpartition(".")[2] in integers else float(value)
