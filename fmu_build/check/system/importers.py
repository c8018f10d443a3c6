"""Other people's importers of a system (SSP), and the short run that each makes."""

from dataclasses import dataclass
from itertools import groupby

from fmu_build.archive.ssp import SPACES
from fmu_build.check.experiment import (
    STEPS,
    FailedError,
    Recording,
    Run,
    Trace,
    list_outputs,
    name_standard,
)
from fmu_build.check.importer import Importer
from fmu_build.check.importers import (
    COSIM_MODULES,
    ECOS_EXTRA,
    ECOS_MODULES,
    FMI,
    PYTHON_EXTRA,
    step_ecos,
)
from fmu_build.check.system.archive import System

SSP = ("SSP 1.0", "SSP 2.0")
OWN_CONNECTORS = "connectors of the system itself; FMPy does"
"""What no importer here runs: a parameter set or another FMU gives the value instead."""
BETWEEN = "::"
"""Between component and variable, as Ecos wants it."""
STEP_SHARE = 1e-2
"""Communication step as a share of the default experiment, where the archive names no step."""


@dataclass(frozen=True)
class SystemRun(Run):
    """Run of a system: real outputs of its components, each COMPONENT::VARIABLE.

    Attributes:
        sets: what the parameter sets are called.
    """

    sets: str


def plan_run(system: System) -> SystemRun:
    """From the start of the default experiment, by the step that the archive names."""
    experiment = system.structure.find("ssd:DefaultExperiment", SPACES)
    given = {} if experiment is None else experiment.attrib
    start = float(given.get("startTime", "0"))
    span = float(given.get("stopTime", start + 1)) - start
    named = [e.get("baseStepSize") for e in system.structure.iter() if "baseStepSize" in e.attrib]
    names = [v.get("name", "") for c in system.components for v in c.values.values()]
    outputs = {
        f"{component.name}{BETWEEN}{name}": reference
        for component in system.components
        for name, reference in list_outputs(system.fmus[component.source]).items()
    }
    needed = {name_standard(fmu) for fmu in system.fmus.values()}
    if system.connectors[None]:
        needed.add(OWN_CONNECTORS)
    return SystemRun(
        path=str(system.path.resolve()),
        standards=(f"SSP {system.structure.get('version')}", *sorted(needed)),
        start=start,
        step=float(named[0]) if named and named[0] else STEP_SHARE * span,
        steps=STEPS,
        outputs=outputs,
        sets=names[0] if names else "",
    )


def run_ecos(run: SystemRun) -> Recording:
    """Ecos."""
    from ecospy.EcosSimulation import EcosSimulation

    simulation = EcosSimulation(step_size=run.step, ssp_path=run.path)
    if not simulation.init(run.start, run.sets):
        raise FailedError("it could not initialize the system")
    return Recording(step_ecos(simulation, run))


def run_libcosimpy(run: SystemRun) -> Recording:
    """libcosimpy."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver

    execution = CosimExecution.from_ssp_file(run.path, step_size=round(run.step * 1e9))
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer=observer)
    trace: Trace = {name: [] for name in run.outputs}
    for _ in range(run.steps):
        if not execution.step():
            raise FailedError("a step failed")
        for component, names in groupby(run.outputs, lambda name: name.split(BETWEEN)[0]):
            listed = list(names)
            index = execution.slave_index_from_instance_name(component)
            last = observer.last_real_values(index, [run.outputs[name] for name in listed])
            for name, value in zip(listed, last, strict=True):
                trace[name].append(value)
    return Recording(trace)


IMPORTERS = (
    Importer("Ecos", "ecospy", ("SSP 1.0", *FMI), ECOS_EXTRA, ECOS_MODULES, run_ecos),
    Importer(
        "libcosimpy", "libcosimpy", (*SSP, *FMI[:1]), PYTHON_EXTRA, COSIM_MODULES, run_libcosimpy
    ),
)
