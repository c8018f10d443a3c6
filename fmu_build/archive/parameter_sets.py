"""Parameter sets of the SSP standard for archives of FMI 3."""

import xml.etree.ElementTree as ET
from collections.abc import Iterable

from fmu_build.archive.description import format_xml
from fmu_build.archive.ssp import SPACES
from fmu_build.equations.scalars import Scalar
from pyhrg.common.reading.documents import parse_xml


def join_arrays(text: str, arrays: Iterable[Scalar]) -> str:
    """A set of SSP 1.0 by the names of FMI 2, as one for FMI 3: elements of an array become the
    array, the others at their defaults. A set that has any is of SSP 2.0, which knows arrays.

    Args:
        text: content of the file.
        arrays: the arrays of the FMU.
    """
    ssv, ssc = (f"{{{SPACES[prefix]}}}" for prefix in ("ssv", "ssc"))
    for prefix in ("ssv", "ssc"):
        ET.register_namespace(prefix, SPACES[prefix])
    root = parse_xml("parameter set", text.encode())
    (parameters,) = root.findall(f"{ssv}Parameters")
    given = {parameter.get("name", ""): parameter for parameter in parameters}
    for array in arrays:
        values = array.attributes["start"].split()
        places = [place for place, name in enumerate(array.elements) if name in given]
        for place in places:
            parameter = given.pop(array.elements[place])
            values[place] = parameter[0].attrib["value"]
        if places:
            given[array.name] = ET.Element(f"{ssv}Parameter", name=array.name)
            ET.SubElement(given[array.name], f"{ssv}Real", value=" ".join(values))
            ET.SubElement(given[array.name], f"{ssc}Dimension", size=str(len(values)))
            root.set("version", "2.0")
    parameters[:] = [given[name] for name in sorted(given)]
    return format_xml(root)
