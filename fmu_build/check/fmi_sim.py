"""fmi-sim, a program in Rust."""

import csv
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
        with output.open(newline="") as file:
            rows = list(csv.DictReader(file))[1:]
    return {name: [float(row[name]) for row in rows] for name in experiment.outputs}


def _copy_without(attributes: Iterable[tuple[str, str]], path: Path, copy: Path) -> None:
    """Copy an FMU, without some attributes (name, element) of its description."""
    with zipfile.ZipFile(path) as source, zipfile.ZipFile(copy, "w") as target:
        for name in source.namelist():
            data = source.read(name)
            if name == "modelDescription.xml":
                root = ET.fromstring(data)
                for attribute, element in attributes:
                    for found in root.iter(element):
                        found.attrib.pop(attribute, None)
                data = ET.tostring(root)
            target.writestr(name, data)
