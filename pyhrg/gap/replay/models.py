"""The FMUs that a diagnosis and a challenge run."""

from collections.abc import Callable

from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.simulation import Simulation


def load_model(name: str, progress: Callable[[str], None] = lambda text: None) -> GyroFmu:
    """The FMU "HRG", "HRGSlow" or "HRGCarrier", ready to be run; it is built first if there is no
    current build. `progress` is called with a sentence on each step of a build."""
    fmu = GyroFmu(build_fmu(name, progress=progress))
    fmu.prepare()
    return fmu


def load_simulation(progress: Callable[[str], None] = lambda text: None) -> Simulation:
    """Both fidelities that a replay needs."""
    return Simulation(load_model("HRG", progress), load_model("HRGSlow", progress))
