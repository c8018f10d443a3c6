"""Shared: the FMU, built once."""

from pathlib import Path

import pytest

from fmu_build.bundle import built_fmu
from pyhrg.fmu import GyroFmu


@pytest.fixture(scope="session")
def fmu_path() -> Path:
    return built_fmu()


@pytest.fixture(scope="session")
def fmu(fmu_path: Path) -> GyroFmu:
    return GyroFmu(fmu_path)
