"""Other people's importers, each run in a process of its own, so that a crash is a finding.

Called as `python -m fmu_build.check.importers NAME`, it reads an experiment from standard input
and writes what it recorded to the file that the experiment names.
"""

import csv
import json
import re
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable
from dataclasses import asdict, dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from shutil import which

from fmu_build.check.experiment import Experiment

Trace = dict[str, list[float]]
"""Recorded outputs by name, one value a communication point after the start."""


@dataclass(frozen=True)
class Recording:
    """What an importer recorded; `remark` says what had to be done for it."""

    trace: Trace
    remark: str = ""


TIMEOUT = 120
"""Seconds after which an importer is taken to hang."""


class MissingError(Exception):
    """The importer isn't installed; the message says how to install it."""


class FailedError(Exception):
    """The importer refused the FMU, failed or crashed."""


@dataclass(frozen=True)
class Importer:
    """An importer: what it is called, which versions of FMI it runs, and how to install it."""

    name: str
    package: str
    fmi: tuple[int, ...]
    install: str
    run: Callable[[Experiment], Recording]

    def version(self) -> str:
        """Installed version.

        Raises:
            MissingError: none is.
        """
        try:
            return _program_version(self.package) if self.run is fmi_sim else version(self.package)
        except (PackageNotFoundError, FileNotFoundError) as error:
            raise MissingError(f"{self.name} is missing: {self.install}") from error

    def recording(self, experiment: Experiment) -> Recording:
        """Run the experiment in another process.

        Raises:
            FailedError: with the importer's words.
        """
        with tempfile.TemporaryDirectory(prefix="hrg-check-") as folder:
            result = Path(folder) / "recording.json"
            command = [sys.executable, "-m", __spec__.name, self.name, str(result)]
            text = json.dumps(asdict(experiment))
            try:
                run = subprocess.run(
                    command,
                    input=text,
                    capture_output=True,
                    text=True,
                    timeout=TIMEOUT,
                    check=False,
                )
            except subprocess.TimeoutExpired as error:
                raise FailedError(f"no end within {TIMEOUT} s") from error
            if run.returncode < 0:
                raise FailedError(f"it crashed by signal {-run.returncode}")
            if run.returncode or not result.exists():
                raise FailedError(_last_words(run.stdout + run.stderr))
            return Recording(**json.loads(result.read_text()))


def _last_words(text: str) -> str:
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "it ended without a word"


def fmpy(experiment: Experiment) -> Recording:
    """FMPy, by `simulate_fmu`."""
    import fmpy

    result = fmpy.simulate_fmu(
        experiment.path,
        fmi_type="CoSimulation",
        start_time=experiment.start,
        stop_time=experiment.start + experiment.steps * experiment.step,
        output_interval=experiment.step,
        start_values=experiment.inputs,
        output=list(experiment.outputs),
    )
    return Recording({name: result[name][1:].tolist() for name in experiment.outputs})


def ecos(experiment: Experiment) -> Recording:
    """Ecos, by its structure of one instance."""
    from ecospy.EcosSimulation import EcosSimulation
    from ecospy.EcosSimulationStructure import EcosSimulationStructure

    structure = EcosSimulationStructure()
    structure.add_model("fmu", experiment.path)
    inputs = {f"fmu::{name}": value for name, value in experiment.inputs.items()}
    structure.add_parameter_set("inputs", inputs)
    simulation = EcosSimulation(step_size=experiment.step, structure=structure)
    if not simulation.init(experiment.start, "inputs"):
        raise FailedError("it could not initialize the FMU")
    trace: Trace = {name: [] for name in experiment.outputs}
    for _ in range(experiment.steps):
        simulation.step()
        for name, values in trace.items():
            values.append(simulation.get_real(f"fmu::{name}"))
    simulation.terminate()
    return Recording(trace)


def libcosimpy(experiment: Experiment) -> Recording:
    """libcosimpy: libcosim by its algorithm of fixed step."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    execution = CosimExecution.from_step_size(step_size=round(experiment.step * 1e9))
    slave = CosimLocalSlave(fmu_path=experiment.path, instance_name="fmu")
    index = execution.add_local_slave(local_slave=slave)
    for name, value in experiment.inputs.items():
        execution.real_initial_value(index, experiment.references[name], value)
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer=observer)
    trace: Trace = {name: [] for name in experiment.outputs}
    for _ in range(experiment.steps):
        if not execution.step():
            raise FailedError("a step failed")
        last = observer.last_real_values(index, list(experiment.outputs.values()))
        for values, value in zip(trace.values(), last, strict=True):
            values.append(value)
    return Recording(trace)


def fmi_sim(experiment: Experiment) -> Recording:
    """fmi-sim; where its version can't read a base unit of FMI 3.0, with a copy of the FMU."""
    try:
        return Recording(_fmi_sim(experiment, Path(experiment.path)))
    except FailedError as error:
        if 'in element "BaseUnit"' not in str(error):
            raise
        with tempfile.TemporaryDirectory(prefix="hrg-check-") as folder:
            copy = Path(folder) / Path(experiment.path).name
            _lower_case_base_units(Path(experiment.path), copy)
            remark = f"{error}: its reader takes A and K in lower case, so it got a copy with these"
            return Recording(_fmi_sim(experiment, copy), remark)


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
            words = [line for line in run.stderr.splitlines() if line.startswith("Error: ")]
            raise FailedError(words[0][7:] if words else _last_words(run.stderr))
        with output.open(newline="") as file:
            rows = list(csv.DictReader(file))[1:]
    return {name: [float(row[name]) for row in rows] for name in experiment.outputs}


def _lower_case_base_units(path: Path, copy: Path) -> None:
    with zipfile.ZipFile(path) as source, zipfile.ZipFile(copy, "w") as target:
        for name in source.namelist():
            data = source.read(name)
            if name == "modelDescription.xml":
                data = re.sub(rb"<BaseUnit\b[^>]*>", lambda m: _lower_case(m.group()), data)
            target.writestr(name, data)


def _lower_case(element: bytes) -> bytes:
    return re.sub(rb"\b([AK])(?=\s*=)", lambda m: m.group().lower(), element)


def _program_version(name: str) -> str:
    if which(name) is None:
        raise FileNotFoundError(name)
    run = subprocess.run([name, "--version"], capture_output=True, text=True, check=False)
    return (run.stdout + run.stderr).replace("Error:", "").split()[1]


PYTHON_EXTRA = "pip install 'hrg[check]'"

IMPORTERS = (
    Importer("FMPy", "fmpy", (2, 3), PYTHON_EXTRA, fmpy),
    Importer("Ecos", "ecospy", (2, 3), f"{PYTHON_EXTRA}; apt-get install libtbb12", ecos),
    Importer(
        "fmi-sim",
        "fmi-sim",
        (2, 3),
        "apt-get install libclang-dev; cargo install fmi-sim --version 0.7.0",
        fmi_sim,
    ),
    Importer("libcosimpy", "libcosimpy", (2,), PYTHON_EXTRA, libcosimpy),
)


def _main() -> None:
    name, result = sys.argv[1:]
    experiment = Experiment(**json.load(sys.stdin))
    (importer,) = (i for i in IMPORTERS if i.name == name)
    try:
        recording = importer.run(experiment)
    except Exception as error:
        sys.exit(str(error))
    Path(result).write_text(json.dumps(asdict(recording)))


if __name__ == "__main__":
    _main()
