"""`hrg build`: what it refuses, leaves out and says."""

import subprocess
import sys
from pathlib import Path

import platformdirs
import pytest

from fmu_build import bundle
from fmu_build.bundle import build_fmu
from fmu_build.roots import Root
from pyhrg.common import cli

HRG = str(Path(sys.executable).parent / "hrg")


def test_a_platform_without_a_folder_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "HRG.fmu"
    arguments = ["build", "--fmi", "2", "--platform", "aarch64-linux", "--out", str(out)]
    assert cli.main(arguments) == 2
    said = capsys.readouterr()
    assert said.err == "hrg: FMI 2.0 has no folder for aarch64-linux; use --fmi 3\n"
    assert said.out == ""
    assert not out.exists()


@pytest.mark.parametrize(("fmi", "count"), [(2, 4), (3, 5)])
def test_all_are_those_that_the_standard_knows(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    fmi: int,
    count: int,
) -> None:
    asked: list[list[str]] = []

    def record(path: Path, root: Root, fmi: int, platforms: list[str], progress: object) -> None:
        asked.append(platforms)
        path.parent.mkdir()
        path.touch()

    monkeypatch.setattr(bundle, "write_fmu", record)
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda name: tmp_path / name)
    out = str(tmp_path / "HRG.fmu")
    assert cli.main(["build", "--fmi", str(fmi), "--platform", "all", "--out", out]) == 0
    assert len(asked[0]) == count
    left_out = "aarch64-linux is left out: FMI 2.0 has no folder for it\n"
    assert capsys.readouterr().err == (left_out if fmi == 2 else "")


def test_a_folder_is_refused_before_anything_is_built(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(bundle, "write_fmu", lambda *args: pytest.fail("it was built"))
    assert cli.main(["build", "--out", str(tmp_path)]) == 2
    assert f"{tmp_path}: it is a folder" in capsys.readouterr().err


def test_what_is_unchanged_is_said_to_be(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    build_fmu()
    assert cli.main(["build", "--out", str(tmp_path / "HRG.fmu")]) == 0
    said = capsys.readouterr()
    assert said.err == "HRG.fmu: unchanged, from cache\n"
    assert said.out == f"{tmp_path / 'HRG.fmu'}\n"


def test_a_reader_that_leaves_is_no_error() -> None:
    process = subprocess.Popen(
        [HRG, "check", str(build_fmu())], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.readline()
    process.stdout.close()
    said = process.stderr.read()
    process.stderr.close()
    assert (process.wait(), said) == (141, b"")
