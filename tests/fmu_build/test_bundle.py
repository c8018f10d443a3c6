"""The archive: same sources, same bytes; built once; sound by FMPy's rules."""

import os
import subprocess
import sys
import warnings
import zipfile
from pathlib import Path

import fmpy
import fmpy.validation
import numpy as np
import platformdirs
import pytest

from fmu_build import bundle
from fmu_build.binaries.platforms import BuildError
from tests.fmu_build.c import native


@pytest.mark.parametrize("fmi", [2, 3])
def test_same_sources_same_bytes(tmp_path: Path, fmi: int) -> None:
    """In another process, whose hashes fall differently and which finds nothing compiled."""
    code = "import pathlib, sys, fmu_build.bundle as b; "
    code += f"b.write_fmu(pathlib.Path(sys.argv[1]), fmi={fmi})"
    command = [sys.executable, "-c", code, str(tmp_path / "again.fmu")]
    environment = {**os.environ, "PYTHONHASHSEED": "12345", "XDG_CACHE_HOME": str(tmp_path)}
    subprocess.run(command, check=True, env=environment)
    assert (tmp_path / "again.fmu").read_bytes() == bundle.build_fmu(fmi=fmi).read_bytes()


@pytest.mark.parametrize("fmi", [2, 3])
def test_packed_sources_are_what_the_modelica_gives_now(tmp_path: Path, fmi: int) -> None:
    """All of them, equations included; and the description that belongs to them."""
    description = bundle.write_sources(native.flat(), tmp_path, fmi)
    with zipfile.ZipFile(bundle.build_fmu(fmi=fmi)) as archive:
        packed = {n: archive.read(n) for n in archive.namelist() if n.endswith((".c", ".h"))}
        assert archive.read("modelDescription.xml").decode() == description
    assert packed.keys() > {"sources/model.c", "sources/limits.c", "sources/model_constants.h"}
    for name, content in packed.items():
        assert content == (tmp_path / Path(name).name).read_bytes(), name


def test_what_is_built_is_not_built_again(fmu_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*args: object, **kwargs: object) -> None:
        raise AssertionError("a compiler was called")

    monkeypatch.setattr(subprocess, "run", refuse)
    monkeypatch.setattr(bundle, "translate", refuse)
    assert bundle.build_fmu() == fmu_path


def test_failed_build_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bundle, "generate_source", lambda dae, integrator: "this is no C")
    with pytest.raises(BuildError, match="this is no C"):
        bundle.write_fmu(tmp_path / "out" / "HRG.fmu")
    assert not (tmp_path / "out").exists()


def test_equations_hold_no_fmi_and_the_shell_no_physics(fmu_path: Path) -> None:
    with zipfile.ZipFile(fmu_path) as archive:
        assert "fmi" not in archive.read("sources/model.c").decode().lower()
        shell = archive.read("sources/fmi2.c").decode().lower()
    assert not any(word in shell for word in ("pattern", "damping", "angle", "amplitude"))


def test_fmpy_finds_nothing(fmu_path: Path) -> None:
    assert fmpy.validation.validate_fmu(str(fmu_path)) == []


def test_fmpy_runs_it_without_a_warning(fmu_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = fmpy.simulate_fmu(
            str(fmu_path),
            stop_time=1.0,
            output_interval=0.1,
            start_values={
                "resonator.material.dampingAnisotropy": 1e-6,
                "startAngle": 0.4,
                "seed": 5,
            },
            output=["gyroAngle", "amplitude"],
        )
    assert len(result) == 11
    assert np.all(np.isfinite(result["gyroAngle"]))
    captured = capfd.readouterr()
    assert captured.out + captured.err == ""


def test_every_variable_is_described_and_has_a_unit(fmu_path: Path) -> None:
    description = fmpy.read_model_description(str(fmu_path))
    assert len(description.modelVariables) > 100
    for variable in description.modelVariables:
        assert variable.description, variable.name
        if variable.type == "Real":
            assert variable.unit, variable.name


def test_only_what_changed_is_compiled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A second build compiles nothing; a second standard compiles anew, since its shell differs."""
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda name: tmp_path / name)
    said: list[str] = []
    for fmi in (2, 2, 3):
        bundle.write_fmu(tmp_path / "HRG.fmu", fmi=fmi, progress=said.append)
    compiled = [line.split()[0] for line in said if " for " in line]
    assert compiled == ["compiling", "unchanged", "compiling"]
