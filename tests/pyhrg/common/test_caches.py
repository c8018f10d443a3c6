"""The cache: verified before it is trusted, made anew where it is damaged, of the user alone."""

import os
import random
import shutil
from pathlib import Path

import platformdirs
import pytest

from fmu_build.bundle import build_fmu
from pyhrg.common.caches import files
from pyhrg.common.errors import HrgError
from pyhrg.fmu import GyroFmu
from tests.pyhrg.common.test_compiled import CALL, read_output, start_process

TURN = """
import numpy as np
from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu
with GyroFmu(build_fmu()).power_on({}, seed=1, start_angle=0.0) as gyro:
    print(gyro.record({"angularRate": np.ones((1, 1))}, {}, 0.1, ["gyroAngle"])[0].item())
"""


def test_a_file_reads_back(tmp_path: Path) -> None:
    path = tmp_path / "folder" / "file"
    files.write_cached(path, b"data")
    assert files.read_cached(path) == b"data"
    assert files.read_cached(tmp_path / "nowhere") is None


def test_a_damaged_file_is_none(tmp_path: Path) -> None:
    path = tmp_path / "file"
    files.write_cached(path, bytes(range(64)))
    kept = path.read_bytes()
    for place in range(len(kept)):
        path.write_bytes(kept[:place] + bytes([kept[place] ^ 1]) + kept[place + 1 :])
        assert files.read_cached(path) is None, place
        path.write_bytes(kept[:place])
        assert files.read_cached(path) is None, place


@pytest.mark.parametrize("mode", [0o777, 0o775])
def test_a_folder_that_others_may_write_is_refused(
    mode: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda name: tmp_path / name)
    folder = files.find_cache_folder()
    assert folder.stat().st_mode & 0o777 == 0o700
    folder.chmod(mode)
    with pytest.raises(HrgError, match=rf"mode {mode:o}, expected a cache that user \d+ alone"):
        files.find_cache_folder()


def test_another_users_folder_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda name: tmp_path / name)
    mine = os.geteuid()
    files.find_cache_folder()
    monkeypatch.setattr(os, "geteuid", lambda: mine + 1)
    with pytest.raises(HrgError, match=f"found owner {mine}"):
        files.find_cache_folder()


def test_damaged_compiled_code_is_made_anew(tmp_path: Path) -> None:
    """Every file of one function's, index and code, with one byte changed or cut off."""
    right = read_output(start_process(tmp_path))
    chance = random.Random(1)
    kept = {path: path.read_bytes() for path in sorted(tmp_path.rglob("*.nb[ic]"))}
    assert {path.suffix for path in kept} == {".nbi", ".nbc"}
    for path, data in kept.items():
        place = chance.randrange(len(data))
        path.write_bytes(data[:place] + bytes([data[place] ^ 255]) + data[place + 1 :])
        assert read_output(start_process(tmp_path)) == right
        assert files.read_cached(path) is not None  # written anew
        path.write_bytes(data[:place])
        assert read_output(start_process(tmp_path)) == right


def prepare_cache(folder: Path) -> Path:
    """A cache that holds compiled libraries alone; returns the file where its FMU will be."""
    original = build_fmu()
    shutil.copytree(original.parents[1] / "libraries", folder / "hrg" / "libraries")
    (folder / "hrg").chmod(0o700)
    return folder / "hrg" / original.parent.name / original.name


def test_two_processes_at_once_build_and_load_one_fmu(tmp_path: Path) -> None:
    cached = prepare_cache(tmp_path)
    both = [start_process(tmp_path, code=TURN) for _ in range(2)]
    first, second = (read_output(process) for process in both)
    assert first == second != 0.0
    assert files.is_intact(cached)
    assert not list(cached.parent.glob(".*"))


def test_a_damaged_fmu_is_built_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cached = prepare_cache(tmp_path)
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda name: tmp_path / name)
    assert build_fmu() == cached
    right = cached.read_bytes()
    cached.write_bytes(right[:100] + b"x" + right[101:])
    said: list[str] = []
    assert build_fmu(progress=said.append).read_bytes() == right
    assert said[0].startswith("translating")
    said.clear()
    build_fmu(progress=said.append)
    assert said == ["HRG.fmu: unchanged, from cache"]


def test_a_damaged_library_of_an_extracted_fmu_is_extracted_anew(tmp_path: Path) -> None:
    path = Path(shutil.copy(build_fmu(), tmp_path))
    (library,) = GyroFmu(path).folder.rglob("*.so")
    right = library.read_bytes()
    library.write_bytes(right[:5000] + b"x" + right[5001:])
    assert GyroFmu(path).folder in library.parents
    assert library.read_bytes() == right


def test_no_home_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the user has no entry either, the home's name is not expanded."""
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda name: Path("~/.cache") / name)
    with pytest.raises(HrgError, match=r"found no home folder, expected \$HOME"):
        files.find_cache_folder()


def test_a_full_disk_does_no_harm(tmp_path: Path) -> None:
    """No file can be longer than 100 bytes: nothing half-written is left, the number is right."""
    code = f"import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))\n{CALL}"
    found = read_output(start_process(tmp_path, code=code))
    assert not list(tmp_path.rglob("*.nb?*"))
    assert found == read_output(start_process(tmp_path))
    assert list(tmp_path.rglob("*.nbc"))
