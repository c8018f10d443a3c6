"""Reference results inside the archive, computed by the FMU itself: fmi-ls-ref, and a figure."""

import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import fmpy
import numpy as np
from fmpy.model_description import ModelVariable
from numpy.typing import NDArray

from fmu_build.archive.description import format_xml
from fmu_build.binaries.libraries import fetch_library
from fmu_build.binaries.platforms import PLATFORMS, find_host_platform

FOLDER = "extra/org.fmi-standard.fmi-ls-ref"

MANIFEST_NAMESPACE = "http://fmi-standard.org/fmi-ls-manifest"

STIMULUS = {
    "angularRate": ((0.0, 0.0), (0.1, 0.0), (0.3, 0.6), (0.6, -0.4), (0.8, 0.0), (1.0, 0.0))
}
"""Inputs that are driven: time over the experiment's length, and value; straight in between."""

POINTS = 200
"""Communication steps of the run."""


@dataclass(frozen=True)
class Reference:
    """Inputs and outputs of one run, as named columns that begin with `time`."""

    inputs: NDArray[np.void]
    outputs: NDArray[np.void]

    @property
    def driven(self) -> list[str]:
        """Inputs that don't stay at their start values."""
        return [name for name in STIMULUS if name in (self.inputs.dtype.names or ())]

    def files(self, name: str) -> dict[str, bytes]:
        """Content of the layered standard's folder, by path in the archive."""
        return {
            f"{FOLDER}/fmi-ls-manifest.xml": _manifest(name).encode(),
            f"{FOLDER}/{name}_in.csv": _text(self.inputs).encode(),
            f"{FOLDER}/{name}_out.csv": _text(self.outputs).encode(),
        }


def simulate_reference(name: str, content: Mapping[str, bytes]) -> Reference:
    """Run an FMU over its default experiment: its description, sources and binaries, by path. Where
    this machine's binary isn't among them, it is compiled."""
    with tempfile.TemporaryDirectory(prefix="hrg-reference-") as folder:
        root = Path(folder)
        for path, data in content.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_bytes(data)
        described = fmpy.read_model_description(folder)
        _complete(root, name, described.fmiVersion)
        stop = float(described.defaultExperiment.stopTime)
        inputs = _inputs(stop, described.modelVariables)
        outputs = fmpy.simulate_fmu(
            folder,
            stop_time=stop,
            output_interval=stop / POINTS,
            input=inputs,
            output=[v.name for v in described.modelVariables if v.causality == "output"],
        )
    return Reference(inputs, outputs)


def _complete(root: Path, name: str, fmi_version: str) -> None:
    """Compile for this machine, unless that is done."""
    platform = PLATFORMS[find_host_platform()]
    known = {"2.0": platform.fmi2_folder, "3.0": platform.name}[fmi_version]
    library = root / "binaries" / (known or platform.name) / f"{name}{platform.suffix}"
    if not library.exists():
        sources = root / "sources"
        listed = sorted(file.name for file in sources.glob("*.c"))
        library.parent.mkdir(parents=True, exist_ok=True)
        library.write_bytes(fetch_library(sources, listed, name, platform))


def _inputs(stop: float, variables: Sequence[ModelVariable]) -> NDArray[np.void]:
    """Every input at each communication point, at its start value unless it is driven; a Boolean as
    1 or 0."""
    inputs = [v for v in variables if v.causality == "input"]
    columns = ["time", *(v.name for v in inputs)]
    table = np.zeros(POINTS + 1, dtype=[(column, np.float64) for column in columns])
    table["time"] = np.arange(POINTS + 1) * (stop / POINTS)
    for variable in inputs:
        table[variable.name] = {"true": 1.0, "false": 0.0}.get(variable.start, variable.start)
        if variable.name in STIMULUS:
            times, values = zip(*STIMULUS[variable.name], strict=True)
            table[variable.name] = np.interp(np.arange(POINTS + 1) / POINTS, times, values)
    return table


def _manifest(name: str) -> str:
    ET.register_namespace("fmi-ls", MANIFEST_NAMESPACE)
    root = ET.Element("fmiReferences")
    root.set(f"{{{MANIFEST_NAMESPACE}}}fmi-ls-name", "org.fmi-standard.fmi-ls-ref")
    root.set(f"{{{MANIFEST_NAMESPACE}}}fmi-ls-version", "1.0.0-alpha.1")
    root.set(f"{{{MANIFEST_NAMESPACE}}}fmi-ls-description", "References to other files")
    inputs = "Inputs of the default experiment, at its communication points"
    outputs = f"Outputs of the default experiment with these inputs, in {POINTS} steps"
    for file, role, text in (("in", "input", inputs), ("out", "result", outputs)):
        given = {"type": "text/csv", "source": f"{name}_{file}.csv", "role": role}
        ET.SubElement(root, "Related", given, description=text)
    return format_xml(root)


def _text(table: NDArray[np.void]) -> str:
    """Shortest digits that read back as the same number."""
    rows = ([repr(float(value)) for value in row] for row in table)
    return "".join(f"{','.join(row)}\n" for row in (table.dtype.names or (), *rows))
