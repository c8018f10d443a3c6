"""The FMUs that a diagnosis and a challenge run."""

from collections.abc import Callable

from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.simulation import Simulation


def load_model(name: str, progress: Callable[[str], None] = lambda text: None) -> GyroFmu:
    """An FMU ready to be run, built first if there is no current build.

    Args:
        name: "HRG", "HRGSlow" or "HRGCarrier".
        progress: called with a sentence on each step of a build.

    Raises:
        TranslationError, BuildError, OSError.
    """
    fmu = GyroFmu(build_fmu(name, progress=progress))
    fmu.prepare()
    return fmu


def load_simulation(progress: Callable[[str], None] = lambda text: None) -> Simulation:
    """Both fidelities that a replay needs; arguments and errors as of `load_model`."""
    return Simulation(load_model("HRG", progress), load_model("HRGSlow", progress))
