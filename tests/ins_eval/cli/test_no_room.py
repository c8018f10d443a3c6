"""A disk that is full and one that is read-only, with real processes: one line, nothing written,
and the same command succeeds when there is room."""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

HRG = "import sys; from pyhrg.common.cli import main; sys.exit(main())"
COMMANDS = {
    "bench": ["bench", "fixed-position"],
    "validate": ["validate"],
    "study": ["study"],
    "study challenge": ["study", "challenge", "--seed", "1"],
    "gap challenge": ["gap", "challenge"],
}
DISK_BYTES = 1 << 26


def mount(*arguments: str) -> None:
    subprocess.run(["mount", *arguments], check=True, capture_output=True)


@pytest.fixture
def disk(tmp_path: Path) -> Iterator[Path]:
    """A small file system of its own."""
    place = tmp_path / "disk"
    place.mkdir()
    try:
        mount("-t", "tmpfs", "-o", f"size={DISK_BYTES}", "tmpfs", str(place))
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("no file system may be mounted here")
    yield place
    subprocess.run(["umount", str(place)], check=True)


def fill(disk: Path) -> Path:
    """Take all room that there is."""
    filler = disk / "filler"
    with filler.open("wb") as file:
        os.posix_fallocate(file.fileno(), 0, os.statvfs(disk).f_bavail * os.statvfs(disk).f_bsize)
    return filler


def run(command: str, out: Path) -> subprocess.CompletedProcess[str]:
    arguments = [*COMMANDS[command], "--out", str(out), "--workers", "1"]
    return subprocess.run(
        [sys.executable, "-c", HRG, *arguments], capture_output=True, text=True, timeout=100
    )


def list_files(disk: Path) -> list[str]:
    return sorted(path.name for path in disk.rglob("*") if path.is_file())


@pytest.mark.parametrize("command", COMMANDS)
def test_a_full_disk(command: str, disk: Path) -> None:
    filler = fill(disk)
    ended = run(command, disk / "out")
    assert ended.returncode == 2, ended.stderr
    assert ended.stderr.splitlines()[-1].endswith("No space left on device")
    assert "Traceback" not in ended.stderr
    assert list_files(disk) == [filler.name]
    if command == "bench":
        filler.unlink()
        assert run(command, disk / "out").returncode == 0
        assert "report.html" in list_files(disk)


@pytest.mark.parametrize("command", COMMANDS)
def test_a_read_only_disk(command: str, disk: Path) -> None:
    mount("-o", "remount,ro", str(disk))
    ended = run(command, disk / "out")
    assert ended.returncode == 2
    assert ended.stderr == f"hrg: {disk}: it can't be written\n"
    if command == "bench":
        mount("-o", "remount,rw", str(disk))
        assert run(command, disk / "out").returncode == 0
