"""Other people's importers, each run in a process of its own, so that a crash is a finding.

Called as `python -m fmu_build.check.importers NAME`, it reads an experiment from standard input
and writes what it recorded to the file that the experiment names.
"""

import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import asdict, dataclass
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from fmu_build.check.experiment import (
    Experiment,
    FailedError,
    Recording,
    Trace,
    read_last_line,
)
from fmu_build.check.fmi_sim import run_fmi_sim
from pyhrg.common.reading.documents import parse_json, read_json

TIMEOUT = 60
"""Seconds after which an importer is taken to hang."""


MISSING_STATUS = 3
"""Exit status of the importer's process when the importer itself can't be loaded."""


class MissingError(Exception):
    """The importer isn't installed, or lacks a library; the message says how to install it."""


@dataclass(frozen=True)
class Importer:
    """An importer: what it is called, which versions of FMI it runs, and how to install it.

    `modules` are loaded before the FMU is: an error of theirs is no fault of the FMU.
    """

    name: str
    package: str
    fmi: tuple[int, ...]
    install: str
    modules: tuple[str, ...]
    run: Callable[[Experiment], Recording]

    def version(self) -> str:
        try:
            if self.run is not run_fmi_sim:
                return version(self.package)
            command = [self.package, "--version"]
            run = subprocess.run(command, capture_output=True, text=True, check=False)
            return (run.stdout + run.stderr).replace("Error:", "").split()[1]
        except (PackageNotFoundError, FileNotFoundError) as error:
            raise MissingError(f"{self.name} is missing: {self.install}") from error

    def recording(self, experiment: Experiment) -> Recording:
        """Run the experiment in another process."""
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
            if run.returncode == MISSING_STATUS:
                reason = read_last_line(run.stderr)
                raise MissingError(f"{self.name} can't be loaded ({reason}): {self.install}")
            if run.returncode or not result.exists():
                raise FailedError(read_last_line(run.stdout + run.stderr))
            return Recording(**read_json(result))


def run_fmpy(experiment: Experiment) -> Recording:
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


def run_ecos(experiment: Experiment) -> Recording:
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


def run_libcosimpy(experiment: Experiment) -> Recording:
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


FMI_SIM_VERSION = "0.7.0"
"""The version that the checks are known to pass with."""

PYTHON_EXTRA = "pip install 'hrg[check]'"

IMPORTERS = (
    Importer("FMPy", "fmpy", (2, 3), PYTHON_EXTRA, ("fmpy",), run_fmpy),
    Importer(
        "Ecos",
        "ecospy",
        (2, 3),
        f"{PYTHON_EXTRA}; apt-get install libtbb12",
        ("ecospy.EcosSimulation", "ecospy.EcosSimulationStructure"),
        run_ecos,
    ),
    Importer(
        "fmi-sim",
        "fmi-sim",
        (2, 3),
        f"apt-get install libclang-dev; cargo install fmi-sim --version {FMI_SIM_VERSION}",
        (),
        run_fmi_sim,
    ),
    Importer(
        "libcosimpy",
        "libcosimpy",
        (2,),
        PYTHON_EXTRA,
        ("libcosimpy.CosimExecution", "libcosimpy.CosimObserver"),
        run_libcosimpy,
    ),
)


def _main() -> None:
    name, result = sys.argv[1:]
    experiment = Experiment(**parse_json("experiment", sys.stdin.read()))
    (importer,) = (i for i in IMPORTERS if i.name == name)
    try:
        for module in importer.modules:
            import_module(module)
    except (ImportError, OSError) as error:
        print(error, file=sys.stderr)
        sys.exit(MISSING_STATUS)
    try:
        recording = importer.run(experiment)
    except Exception as error:  # an importer raises what it likes
        sys.exit(str(error) or type(error).__name__)
    Path(result).write_text(json.dumps(asdict(recording)))


if __name__ == "__main__":
    _main()
