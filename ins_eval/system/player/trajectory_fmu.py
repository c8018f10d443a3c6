"""The trajectory's FMU: description, library and motion, packed."""

import hashlib
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Callable, Sequence
from pathlib import Path

from fmu_build.archive.description import format_xml, make_root
from fmu_build.archive.licences import list_licence_files
from fmu_build.archive.packing import pack_archive
from fmu_build.archive.units import add_unit_definitions
from fmu_build.binaries.libraries import fetch_library
from fmu_build.binaries.platforms import PLATFORMS, place_binaries
from ins_eval.system.player.motion import MAGIC
from ins_eval.system.player.variables import LEAD_IN, Variable, list_variables

SOURCE = Path(__file__).with_name("trajectory.c")
IDENTIFIER = "Trajectory"
CAPABILITIES = ("canHandleVariableCommunicationStepSize", "canNotUseMemoryManagementFunctions")


def build_trajectory_fmu(
    motion: bytes,
    interval: float,
    duration: float,
    platforms: Sequence[str],
    progress: Callable[[str], None],
) -> bytes:
    """FMU of FMI 2.0 that plays a motion (`format_motion`), as an archive's bytes.

    interval, duration: of the motion, s; platforms: names of those that it is to run on.
    """
    source = SOURCE.read_bytes()
    token = hashlib.sha256(source).hexdigest()[:32]
    header = f'#define TOKEN "{token}"\n'.encode()
    with tempfile.TemporaryDirectory(prefix="hrg-build-") as name:
        folder = Path(name)
        (folder / SOURCE.name).write_bytes(source)
        (folder / "token.h").write_bytes(header)
        libraries = {
            platform: fetch_library(
                folder, [SOURCE.name], IDENTIFIER, PLATFORMS[platform], progress
            )
            for platform in platforms
        }
    licences = list_licence_files(2, is_generated=False)
    content = {
        "modelDescription.xml": _describe(token, interval, duration).encode(),
        "resources/trajectory.bin": motion,
        "documentation/index.html": _document().encode(),
        f"sources/{SOURCE.name}": source,
        "sources/token.h": header,
        **place_binaries(libraries, IDENTIFIER, 2),
        **{f"documentation/licenses/{n}": text for n, text in licences.items()},
    }
    return pack_archive(content)


PAGE = """<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"/><title>Trajectory</title></head>
<body>
<h1>Trajectory</h1>
<p>Plays the motion of a vehicle. The file <code>resources/trajectory.bin</code> holds the eight
characters <code>{magic}</code>, then doubles in little-endian order: the interval in s, the number
n of intervals, and n + 1 rows of eight numbers: mean rotation rate (rad/s) and mean specific force
(m/s2) forward, right and down over the interval, height (m) and climb rate (m/s) at its begin. At
each communication point the outputs are those of the interval that begins there.
<code>leadIn</code> keeps the vehicle at rest, without any specific force, for so many intervals
first.</p>
<table>
<tr><th>variable</th><th>unit</th><th>meaning</th></tr>
{rows}
</table>
</body>
</html>
"""


def _document() -> str:
    rows = (
        f"<tr><td>{v.name}</td><td>{v.unit}</td><td>{v.description}</td></tr>"
        for v in list_variables()
    )
    return PAGE.format(magic=MAGIC.decode(), rows="\n".join(rows))


def _describe(token: str, interval: float, duration: float) -> str:
    root = make_root(
        "2.0",
        IDENTIFIER,
        "Motion of a vehicle, played from resources/trajectory.bin",
        CAPABILITIES,
        [SOURCE.name],
        guid=token,
    )
    variables = list_variables()
    add_unit_definitions(root, {(v.unit, "") for v in variables})
    categories = ET.SubElement(root, "LogCategories")
    ET.SubElement(categories, "Category", name="logStatusError", description="Refused calls")
    times = {"startTime": "0", "stopTime": repr(duration), "stepSize": repr(interval)}
    ET.SubElement(root, "DefaultExperiment", times)
    parent = ET.SubElement(root, "ModelVariables")
    for reference, variable in enumerate(variables):
        _describe_variable(parent, reference, variable)
    structure = ET.SubElement(root, "ModelStructure")
    for kind in ("Outputs", "InitialUnknowns"):
        listed = ET.SubElement(structure, kind)
        for reference, variable in enumerate(variables):
            if not variable.is_parameter:
                given = {"dependencies": ""} if kind == "Outputs" else {}
                ET.SubElement(listed, "Unknown", {"index": str(reference + 1), **given})
    return format_xml(root)


def _describe_variable(parent: ET.Element, reference: int, variable: Variable) -> None:
    head = {
        "name": variable.name,
        "valueReference": str(reference),
        "description": variable.description,
    }
    if not variable.is_parameter:
        head |= {"causality": "output", "variability": "discrete", "initial": "calculated"}
        entry = ET.SubElement(parent, "ScalarVariable", head)
        ET.SubElement(entry, "Real", unit=variable.unit)
        return
    head |= {"causality": "parameter", "variability": "fixed"}
    lowest = "0.0" if variable.name == LEAD_IN else repr(-variable.largest)
    entry = ET.SubElement(parent, "ScalarVariable", head)
    limits = {"min": lowest, "max": repr(variable.largest), "start": repr(variable.start)}
    ET.SubElement(entry, "Real", {"unit": variable.unit, **limits})
