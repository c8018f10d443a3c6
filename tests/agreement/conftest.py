"""Closed forms hold in both fidelities that run for minutes: `fmu` is each in turn."""

import pytest

from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu


@pytest.fixture(scope="session", params=["HRG", "HRGSlow"])
def fmu(request: pytest.FixtureRequest) -> GyroFmu:
    return GyroFmu(build_fmu(request.param))
