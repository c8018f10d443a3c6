"""Other people's importers of an SSP, run to a time: the navigator's outputs there."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from zipfile import ZipFile

OUTPUTS = ("latitude", "longitude", "height", "navigationTime", "valid")
COMPONENTS = ("trajectory", "gyro1", "gyro2", "gyro3", "accelerometers", "navigator")


def run_ssp(importer: str, path: Path, step: float, steps: int) -> dict[str, float]:
    """Run a system by an importer in a process of its own, since they keep what they loaded.

    importer: a key of `IMPORTERS`; step: communication step, s.
    """
    command = [sys.executable, "-m", __name__, importer, str(path), repr(step), str(steps)]
    with tempfile.TemporaryFile("w+") as told:
        run = subprocess.run(command, stdout=told, stderr=told, check=False)
        told.seek(0)
        text = told.read()
    assert run.returncode == 0, text
    return json.loads(text.splitlines()[-1])


def run_ecos(path: Path, step: float, steps: int) -> list[float]:
    from ecospy.EcosSimulation import EcosSimulation

    simulation = EcosSimulation(step_size=step, ssp_path=str(path))
    assert simulation.init(0.0, "initialValues")
    for _ in range(steps):
        simulation.step()
    values = [simulation.get_real(f"navigator::{name}") for name in OUTPUTS]
    simulation.terminate()
    return values


def run_libcosimpy(path: Path, step: float, steps: int) -> list[float]:
    """The step is the one that the archive names."""
    import fmpy
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimObserver import CosimObserver

    log_output_level(CosimLogLevel.WARNING)
    execution = CosimExecution.from_ssp_file(ssp_path=str(path))
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer)
    assert execution.step(steps)
    with tempfile.TemporaryDirectory() as folder, ZipFile(path) as archive:
        fmu = archive.extract("resources/Navigator.fmu", folder)
        variables = fmpy.read_model_description(fmu).modelVariables
    references = {v.name: v.valueReference for v in variables}
    index = execution.slave_index_from_instance_name("navigator")
    return list(observer.last_real_values(index, [references[name] for name in OUTPUTS]))


def run_fmpy(path: Path, step: float, steps: int) -> list[float]:
    """FMPy hands over nothing before the first step, and applies no parameter set by itself."""
    from fmpy.ssp.simulation import simulate_ssp
    from fmpy.ssp.ssd import Parameter, ParameterSet, read_ssv

    values = ParameterSet(name="all")
    with tempfile.TemporaryDirectory() as folder, ZipFile(path) as archive:
        for component in COMPONENTS:
            own = read_ssv(archive.extract(f"resources/{component}.ssv", folder))
            for parameter in own.parameters:
                parameter.name = f"{component}.{parameter.name}"
                values.parameters.append(parameter)
    values.parameters.append(Parameter(name="trajectory.leadIn", value="1"))
    result = simulate_ssp(
        path, stop_time=(steps + 0.5) * step, step_size=step, parameter_set=values
    )
    return [float(result[f"navigator.{name}"][-1]) for name in OUTPUTS]


IMPORTERS = {"ecos": run_ecos, "libcosimpy": run_libcosimpy, "fmpy": run_fmpy}

if __name__ == "__main__":
    name, file, seconds, count = sys.argv[1:]
    found = IMPORTERS[name](Path(file), float(seconds), int(count))
    print(f"\n{json.dumps(dict(zip(OUTPUTS, found, strict=True)))}", flush=True)
