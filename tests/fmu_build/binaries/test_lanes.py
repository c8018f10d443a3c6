"""The library for gyros side by side, and its cache."""

import shutil
from pathlib import Path

import pytest

from fmu_build.binaries import libraries
from fmu_build.binaries.lanes import build_lanes
from fmu_build.binaries.platforms import BuildError
from pyhrg.fmu import GyroFmu


def test_it_is_compiled_once(fmu: GyroFmu, monkeypatch: pytest.MonkeyPatch) -> None:
    sources = fmu.folder / "sources"
    library = build_lanes(sources, 4)
    monkeypatch.setattr(libraries, "compile_library", None)
    assert build_lanes(sources, 4) == library


def test_it_follows_from_the_model(fmu: GyroFmu, tmp_path: Path) -> None:
    sources = shutil.copytree(fmu.folder / "sources", tmp_path / "sources")
    assert build_lanes(sources, 4) == build_lanes(fmu.folder / "sources", 4)
    with (sources / "model.c").open("a") as model:
        model.write("no C\n")
    with pytest.raises(BuildError):
        build_lanes(sources, 4)
