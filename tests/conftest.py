"""Shared: the FMU, built once."""

import zipfile
from pathlib import Path

import pytest

from fmu_build.bundle import built_fmu
from fmu_build.platforms import PLATFORMS
from pyhrg.fmu import GyroFmu


@pytest.fixture(scope="session")
def fmu_path() -> Path:
    return built_fmu()


@pytest.fixture(scope="session")
def fmu(fmu_path: Path) -> GyroFmu:
    return GyroFmu(fmu_path)


@pytest.fixture(scope="session")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """By FMI version: the FMU for every platform, extracted."""
    result = {}
    for fmi in (2, 3):
        result[fmi] = tmp_path_factory.mktemp(f"fmi{fmi}")
        with zipfile.ZipFile(built_fmu(fmi=fmi, platforms=list(PLATFORMS))) as archive:
            archive.extractall(result[fmi])
    return result
