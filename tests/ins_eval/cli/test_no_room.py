"""A disk that is full, fills up or is read-only, with real workers: one line, nothing
half-written, and the same command succeeds when there is room."""

import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from ins_eval.study import study_file
from pyhrg.common.cli import main

Run = Callable[[str], tuple[int, str]]
PLAN = """\
fixed_runs = 2
positions = 16
segments = 1
fixed_segments = 2
periods = 1
"""
STUDY = f"""\
seed = 1
triads = 8
training = 2
interval_percent = 50
hours = 0.1
calibrations = ["mean"]
missions = [{{ name = "car", class = "car" }}]

[calibration]
runs = 1
{PLAN}
[bench]
runs = 2
{PLAN}"""
"""The smallest study that is scored."""
COMMANDS = {
    "validate": "validate --triads 6 --hours 0.1 --seed 1 --workers 1 --out {out}",
    "study": "study --workers 1 --out {out}",
    "study challenge": "study challenge --seed 1 --workers 1 --out {out}",
    "bench": "bench amplitude-sweep --seed 1 --workers 1 --out {out}",
    "gap challenge": "gap challenge --none 1 --single 0 --pairs 0 --outside 0 --data short "
    "--seed 1 --workers 1 --out {out}",
}
"""Arguments of `hrg` by name; {out} is the output folder."""
DISK_BYTES = 1 << 26
ROOM = 1 << 17
"""Room for a part of what each command writes, bytes."""


def run_here(name: str, out: Path, folder: Path, patch: pytest.MonkeyPatch) -> int:
    """Status of a command that writes into `out`, in a folder where the smallest study stands in
    for `small`, which takes minutes."""
    (folder / "small.toml").write_text(STUDY)
    patch.chdir(folder)
    patch.setattr(study_file, "_FOLDER", Path())
    return main([word.format(out=out) for word in COMMANDS[name].split()])


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


def fill(disk: Path, room: int = 0) -> Path:
    """Take all room that there is, but so many bytes."""
    filler, free = disk / "filler", os.statvfs(disk).f_bavail * os.statvfs(disk).f_bsize
    with filler.open("wb") as file:
        os.posix_fallocate(file.fileno(), 0, free - room)
    return filler


@pytest.fixture
def run(disk: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Run:
    """Gives status and standard error of a command that writes onto the disk."""

    def run_command(command: str) -> tuple[int, str]:
        capfd.readouterr()
        status = run_here(command, disk / "out", disk.parent, monkeypatch)
        return status, capfd.readouterr().err

    return run_command


def list_files(disk: Path) -> list[str]:
    return sorted(path.name for path in disk.rglob("*") if path.is_file())


def check_refusal(status: int, errors: str) -> None:
    assert status == 2, errors
    assert errors.splitlines()[-1].endswith("No space left on device")
    assert "Traceback" not in errors


@pytest.mark.parametrize("command", COMMANDS)
def test_a_full_disk(command: str, disk: Path, run: Run) -> None:
    filler = fill(disk)
    check_refusal(*run(command))
    assert list_files(disk) == [filler.name]


@pytest.mark.parametrize("command", ["bench", "study"])
def test_a_disk_that_fills_midway(command: str, disk: Path, run: Run) -> None:
    """What is whole may stay. The same command goes on when there is room. `validate` and
    `study challenge` write as `study` does."""
    filler = fill(disk, ROOM)
    check_refusal(*run(command))
    assert not list(disk.rglob(".*"))
    filler.unlink()
    status, errors = run(command)
    assert status == 0, errors


@pytest.mark.parametrize("command", COMMANDS)
def test_a_read_only_disk(command: str, disk: Path, run: Run) -> None:
    mount("-o", "remount,ro", str(disk))
    assert run(command) == (2, f"hrg: {disk}: it can't be written\n")
