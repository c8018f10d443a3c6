"""Both fidelities of the gyro."""

import pytest

from pyhrg.fmu import GyroFmu
from pyhrg.gap.simulation import Simulation


@pytest.fixture(scope="session")
def simulation(fmu: GyroFmu, slow_fmu: GyroFmu) -> Simulation:
    for model in (fmu, slow_fmu):
        model.prepare()
    return Simulation(fmu, slow_fmu)
