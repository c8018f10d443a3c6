"""Files and folders appear whole or not at all, where the process is killed too."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

from pyhrg.common.files import check_output_folder, replace_folder, stage_files, write_whole

KILL = "os.kill(os.getpid(), signal.SIGKILL)"
START = """
import os, shutil, signal
from pathlib import Path
from pyhrg.common import files
"""
FILE = START + f"Path.replace = lambda *names: {KILL}; files.write_whole(Path('out'), b'new')"
UNFINISHED = START + (
    f"\nwith files.replace_folder(Path('out')) as aside:\n (aside / 'new').touch(); {KILL}"
)
BETWEEN = (
    START
    + f"""
rename = Path.rename
def kill_at_second(path, target):
    if path.name.endswith('.partial'):
        {KILL}
    return rename(path, target)
Path.rename = kill_at_second
with files.replace_folder(Path('out')) as aside:
    (aside / 'new').touch()
"""
)
DELETING = (
    START
    + f"""
shutil.rmtree = lambda *given, **more: {KILL}
with files.replace_folder(Path('out')) as aside:
    (aside / 'new').touch()
"""
)
STAGED = START + (
    f"\nwith files.stage_files(Path('out'), ('new',)) as aside:\n (aside / 'new').touch(); {KILL}"
)


def run_killed(code: str, folder: Path) -> None:
    run = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True)
    assert run.returncode == -signal.SIGKILL, run.stderr


def list_names(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def test_a_file_whose_writer_was_killed(tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.write_bytes(b"old")
    (tmp_path / ".out.toml").touch()  # the user's
    run_killed(FILE, tmp_path)
    assert out.read_bytes() == b"old"
    assert len(list_names(tmp_path)) == 3
    write_whole(out, b"newer")
    assert list_names(tmp_path) == [".out.toml", "out"]
    assert out.read_bytes() == b"newer"


@pytest.mark.parametrize("code", [UNFINISHED, BETWEEN, DELETING])
def test_a_folder_whose_writer_was_killed(code: str, tmp_path: Path) -> None:
    """The old or the new folder is there, or comes back with the next write, though that fails."""
    out = tmp_path / "out"
    out.mkdir()
    (out / "old").touch()
    run_killed(code, tmp_path)
    with pytest.raises(OSError, match="none"), replace_folder(out):
        raise OSError("none")
    assert list_names(tmp_path) == ["out", f"out/{'new' if code == DELETING else 'old'}"]
    with replace_folder(out) as aside:
        (aside / "newer").touch()
    assert list_names(tmp_path) == ["out", "out/newer"]


def test_staged_files_whose_writer_was_killed(tmp_path: Path) -> None:
    run_killed(STAGED, tmp_path)
    with stage_files(tmp_path / "out", ("new",)) as aside:
        (aside / "new").write_text("newer")
    assert list_names(tmp_path) == ["out", "out/new"]


def test_what_a_running_process_writes_is_no_leftover(tmp_path: Path) -> None:
    out = tmp_path / "out"
    with replace_folder(out) as aside:
        (aside / "first").touch()
        code = START + "\nwith files.replace_folder(Path('out')) as aside: pass"
        subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=True)
        assert (aside / "first").exists()
    assert list_names(tmp_path) == ["out", "out/first"]


def test_a_folder_that_cannot_be_exchanged_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, rename = tmp_path / "out", Path.rename

    def fail(path: Path, target: Path) -> Path:
        if path.name.endswith(".partial"):
            raise OSError("no room")
        return rename(path, target)

    out.mkdir()
    (out / "old").touch()
    monkeypatch.setattr(Path, "rename", fail)
    with pytest.raises(OSError, match="no room"), replace_folder(out):
        pass
    assert list_names(tmp_path) == ["out", "out/old"]


def test_a_folder_that_takes_no_files_is_named() -> None:
    """A file system of the kernel's own, which says of itself that it can be written."""
    folder = Path("/proc/self")
    if not folder.is_dir():
        pytest.skip("this system has no /proc")
    with pytest.raises(PermissionError, match="it can't be written: '/proc/self'"):
        check_output_folder(folder / "out")
    with pytest.raises(OSError, match=r"'/proc/self/mapping\.toml'$"):
        write_whole(folder / "mapping.toml", b"")
