"""Shared: the FMU, built once; programs that a test needs."""

import os
import signal
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fmu_build.binaries.platforms import list_platforms
from fmu_build.bundle import build_fmu
from fmu_build.roots import ROOTS
from pyhrg.fmu import GyroFmu
from tests.programs import (  # noqa: F401 (hooks of pytest)
    find_chromium,
    pytest_configure,
    pytest_runtest_setup,
    pytest_terminal_summary,
)


def pytest_xdist_auto_num_workers() -> int:
    """One worker more than processors, since some tests wait for programs that they start."""
    return (os.cpu_count() or 1) + 1


@pytest.fixture(scope="session", autouse=True)
def interruptible() -> None:
    """Interruptions reach these processes, also in a script's background job, whose shell ignores
    them."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    """A headless Chromium of playwright."""
    api = pytest.importorskip("playwright.sync_api")
    with api.sync_playwright() as playwright:
        running = playwright.chromium.launch(executable_path=find_chromium())
        yield running
        running.close()


@pytest.fixture(scope="session")
def fmu_path() -> Path:
    return build_fmu()


@pytest.fixture(scope="session")
def fmu(fmu_path: Path) -> GyroFmu:
    return GyroFmu(fmu_path)


@pytest.fixture(scope="session")
def slow_fmu() -> GyroFmu:
    """The gyro whose loops follow at once, at steps of 0.1 s."""
    return GyroFmu(build_fmu("HRGSlow"))


@pytest.fixture(scope="session")
def extracted(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """By FMI version: the FMU for this machine, extracted."""
    return {fmi: _extracted(build_fmu(fmi=fmi), tmp_path_factory) for fmi in (2, 3)}


@pytest.fixture(params=[2, 3], ids=["fmi2", "fmi3"])
def folder(request: pytest.FixtureRequest, extracted: dict[int, Path]) -> Path:
    """The extracted FMU of each standard in turn."""
    return extracted[request.param]


@pytest.fixture(
    scope="session",
    params=[(fmi, name) for name in ROOTS for fmi in (2, 3)],
    ids=lambda param: f"{param[1]}-fmi{param[0]}",
)
def model_folder(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The extracted FMU of each model and standard in turn."""
    fmi, name = request.param
    return _extracted(build_fmu(name, fmi=fmi), tmp_path_factory)


@pytest.fixture(scope="session")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """By FMI version: the FMU for every platform, extracted."""
    return {
        fmi: _extracted(build_fmu(fmi=fmi, platforms=list_platforms(fmi)), tmp_path_factory)
        for fmi in (2, 3)
    }


def _extracted(path: Path, factory: pytest.TempPathFactory) -> Path:
    folder = factory.mktemp("fmu")
    with zipfile.ZipFile(path) as archive:
        archive.extractall(folder)
    return folder
