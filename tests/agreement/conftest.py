"""Closed forms hold in both fidelities that run for minutes: `fmu` is each in turn."""

import pytest

from fmu_build.bundle import built_fmu
from fmu_build.roots import ROOTS
from pyhrg.fmu import GyroFmu


@pytest.fixture(scope="session", params=["HRG", "HRGSlow"])
def fmu(request: pytest.FixtureRequest) -> GyroFmu:
    return GyroFmu(built_fmu(root=ROOTS[request.param]))
