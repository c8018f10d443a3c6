"""fmi-sim, an importer written in Rust."""

import re
import subprocess
import tempfile
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterable
from pathlib import Path

from fmu_build.check.experiment import (
    Experiment,
    FailedError,
    Recording,
    Trace,
    read_last_line,
)
from pyhrg.common.reading.archives import open_archive
from pyhrg.common.reading.documents import parse_csv, parse_xml
from pyhrg.common.reading.files import decode, read_bytes
from pyhrg.common.reading.limits import LOG_BYTES

DESCRIPTIVE = {"A", "K", "unit", "displayUnit", "quantity", "relativeQuantity", "nominal"}
"""Attributes without which an FMU computes the same numbers."""


def run_fmi_sim(experiment: Experiment) -> Recording:
    """fmi-sim. Where its reader doesn't know an attribute of the standard that only describes,
    it gets a copy of the FMU without, and the remark says so."""
    removed: list[tuple[str, str]] = []
    with tempfile.TemporaryDirectory(prefix="hrg-check-") as folder:
        path = Path(experiment.path)
        while True:
            try:
                trace = _fmi_sim(experiment, path)
            except FailedError as error:
                unknown = re.match(r'unknown field "(\w+)" in element "(?:Fmi)?(\w+)"', str(error))
                pair = (unknown.group(1), unknown.group(2)) if unknown else ("", "")
                if pair[0] not in DESCRIPTIVE or pair in removed:
                    raise
                removed.append(pair)
                path = Path(folder) / Path(experiment.path).name
                _copy_without(removed, Path(experiment.path), path)
            else:
                listed = ", ".join(f"{attribute} of {element}" for attribute, element in removed)
                remark = (
                    f"its reader doesn't know {listed}: it got a copy without" if listed else ""
                )
                return Recording(trace, remark)


def _fmi_sim(experiment: Experiment, path: Path) -> Trace:
    """By its command line; it writes the shortest digits that give the same number."""
    with tempfile.TemporaryDirectory(prefix="hrg-check-") as folder:
        output = Path(folder) / "output.csv"
        stop = experiment.start + experiment.steps * experiment.step
        command = ["fmi-sim", "-q", "--model", str(path), "-o", str(output), "co-simulation"]
        command += ["-s", repr(experiment.start), "-f", repr(stop)]
        command += ["--output-interval", repr(experiment.step)]
        for name, value in experiment.inputs.items():
            command += ["--init-values", f"{name}={value!r}"]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        if run.returncode:
            # the error with its causes, without the trace of the stack
            head = run.stderr.partition("Stack backtrace")[0].rpartition("Error: ")[2]
            raise FailedError(" ".join(head.split()) or read_last_line(run.stderr))
        text = decode(output, read_bytes(output, LOG_BYTES))
        (_, header), _, *rows = parse_csv("output", text)
    places = {name: header.index(name) for name in experiment.outputs}
    return {name: [float(row[place]) for _, row in rows] for name, place in places.items()}


def _copy_without(attributes: Iterable[tuple[str, str]], path: Path, copy: Path) -> None:
    """Copy an FMU, without some attributes (name, element) of its description."""
    with open_archive(path) as source, zipfile.ZipFile(copy, "w") as target:
        for name in (entry.filename for entry in source.entries):
            data = source.read(name)
            if name == "modelDescription.xml":
                root = parse_xml(name, data)
                for attribute, element in attributes:
                    for matching in root.iter(element):
                        matching.attrib.pop(attribute, None)
                data = ET.tostring(root)
            target.writestr(name, data)
