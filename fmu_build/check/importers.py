"""Other people's importers of an FMU, and what installs them."""

from typing import TYPE_CHECKING

from fmu_build.check.experiment import Experiment, FailedError, Recording, Run, Trace
from fmu_build.check.fmi_sim import run_fmi_sim
from fmu_build.check.importer import Importer

if TYPE_CHECKING:
    from ecospy.EcosSimulation import EcosSimulation


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
    return Recording(step_ecos(simulation, experiment, "fmu::"))


def step_ecos(simulation: "EcosSimulation", run: Run, prefix: str = "") -> Trace:
    """What an initialized simulation puts out at each step; the prefix says of which instance."""
    trace: Trace = {name: [] for name in run.outputs}
    for _ in range(run.steps):
        simulation.step()
        for name, values in trace.items():
            values.append(simulation.get_real(prefix + name))
    simulation.terminate()
    return trace


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
ECOS_EXTRA = f"{PYTHON_EXTRA}; apt-get install libtbb12"
ECOS_MODULES = ("ecospy.EcosSimulation", "ecospy.EcosSimulationStructure")
COSIM_MODULES = ("libcosimpy.CosimExecution", "libcosimpy.CosimObserver")

FMI = ("FMI 2.0", "FMI 3.0")

IMPORTERS = (
    Importer("FMPy", "fmpy", FMI, PYTHON_EXTRA, ("fmpy",), run_fmpy),
    Importer("Ecos", "ecospy", FMI, ECOS_EXTRA, ECOS_MODULES, run_ecos),
    Importer(
        "fmi-sim",
        "fmi-sim",
        FMI,
        f"apt-get install libclang-dev; cargo install fmi-sim --version {FMI_SIM_VERSION}",
        (),
        run_fmi_sim,
    ),
    Importer("libcosimpy", "libcosimpy", FMI[:1], PYTHON_EXTRA, COSIM_MODULES, run_libcosimpy),
)
