"""Compiled code on disk: one folder a state of the sources, and none where none can be."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import ins_eval
from ins_eval.common import earth
from pyhrg.common.caches import compiled

PACKAGES = Path(ins_eval.__file__).parents[1]
CALL = """
from ins_eval.common import earth
print(earth.meridian_radius(0.5))
"""


def start_process(
    cache: Path, packages: Path = PACKAGES, code: str = CALL
) -> subprocess.Popen[str]:
    """A process of its own that calls one compiled function."""
    environment = os.environ | {"XDG_CACHE_HOME": str(cache), "PYTHONPATH": str(packages)}
    return subprocess.Popen(
        [sys.executable, "-c", code],
        env=environment,
        text=True,
        cwd=packages,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def read_output(process: subprocess.Popen[str]) -> float:
    out, err = process.communicate(timeout=120)
    assert process.returncode == 0, err
    return float(out)


def list_folders(cache: Path) -> list[str]:
    return sorted(path.name for path in (cache / "hrg").iterdir())


def test_sources_are_all_files_with_compiled_functions() -> None:
    names = {path.name for path in compiled.list_sources()}
    assert {
        "site.py",
        "compiled.py",
        "earth.py",
        "algebra.py",
        "body_step.py",
        "kernel.py",
    } <= names


def test_two_processes_at_once_share_a_cold_cache(tmp_path: Path) -> None:
    both = [start_process(tmp_path), start_process(tmp_path)]
    assert [read_output(process) for process in both] == [earth.meridian_radius(0.5)] * 2
    assert len(list_folders(tmp_path)) == 1
    assert list(tmp_path.rglob("*.nbi"))


def test_a_changed_source_gets_a_new_folder(tmp_path: Path) -> None:
    """A constant of Earth changes, in a copy, and no stale code answers."""
    copy = tmp_path / "copy"
    skipped = shutil.ignore_patterns("__pycache__")
    for package in ("ins_eval", "pyhrg"):
        shutil.copytree(PACKAGES / package, copy / package, ignore=skipped)
    cache = tmp_path / "cache"
    before = read_output(start_process(cache, copy))
    source = copy / "ins_eval" / "common" / "earth.py"
    source.write_text(source.read_text().replace("SEMI_MAJOR = 6378137.0", "SEMI_MAJOR = 1.0"))
    after = read_output(start_process(cache, copy))
    assert after == pytest.approx(before / 6378137.0)
    assert len(list_folders(cache)) == 2


def test_a_copy_of_the_sources_compiles_nothing_anew(tmp_path: Path) -> None:
    cache, copy = tmp_path / "cache", tmp_path / "copy"
    skipped = shutil.ignore_patterns("__pycache__")
    for package in ("ins_eval", "pyhrg"):
        shutil.copytree(PACKAGES / package, copy / package, ignore=skipped)
    first = read_output(start_process(cache))
    kept = {path: path.stat().st_mtime_ns for path in cache.rglob("*.nb*")}
    assert kept
    assert read_output(start_process(cache, copy)) == first
    assert {path: path.stat().st_mtime_ns for path in cache.rglob("*.nb*")} == kept


def test_a_folder_that_cannot_be_written_does_no_harm(tmp_path: Path) -> None:
    """A file stands in the cache's way: no caching, not beside the sources either, and the same
    numbers."""
    (tmp_path / "hrg").write_text("in the way")
    assert read_output(start_process(tmp_path)) == earth.meridian_radius(0.5)
    assert not list(Path(ins_eval.__file__).parent.rglob("*.nbi"))
