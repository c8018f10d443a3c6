"""The FMUs that a diagnosis and a challenge run."""

from collections.abc import Callable

from fmu_build.bundle import built_fmu
from fmu_build.roots import ROOTS
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.simulation import Simulation


def model(name: str, say: Callable[[str], None] = lambda text: None) -> GyroFmu:
    """A gyro of `ROOTS`, ready to be run, built where it isn't yet.

    Args:
        name: of the root.
        say: told what is being done.

    Raises:
        TranslationError, BuildError, OSError.
    """
    fmu = GyroFmu(built_fmu(say, root=ROOTS[name]))
    fmu.prepare()
    return fmu


def simulation(say: Callable[[str], None] = lambda text: None) -> Simulation:
    """Both fidelities; arguments and errors as of `model`."""
    return Simulation(model("HRG", say), model("HRGSlow", say))
