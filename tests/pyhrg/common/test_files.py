"""Files and folders that are whole or not there, also when the writer is killed."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from pyhrg.common.files import LEFTOVER_AGE, replace_folder, stage_files, write_whole

FOLDER_WRITER = """
import sys, time
from pathlib import Path
from pyhrg.common.files import replace_folder
with replace_folder(Path(sys.argv[1])) as aside:
    (aside / "half").write_text("half")
    print("writing", flush=True)
    time.sleep(60)
"""
STAGE_WRITER = FOLDER_WRITER.replace("replace_folder(Path(sys.argv[1]))", "stage").replace(
    "import replace_folder",
    'import stage_files\nstage = stage_files(Path(sys.argv[1]), ("half",))',
)


def write_folder(out: Path) -> None:
    with replace_folder(out) as aside:
        (aside / "file").write_text("new")


def write_staged(out: Path) -> None:
    with stage_files(out, ("file",)) as aside:
        (aside / "file").write_text("new")


def age(path: Path) -> None:
    old = path.stat().st_mtime - 2 * LEFTOVER_AGE
    os.utime(path, (old, old))


def list_hidden(folder: Path) -> list[str]:
    return [path.name for path in folder.rglob(".*")]


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGKILL")
@pytest.mark.parametrize(
    ("script", "write"), [(FOLDER_WRITER, write_folder), (STAGE_WRITER, write_staged)]
)
def test_what_a_killed_writer_leaves_goes_with_a_later_write(
    tmp_path: Path, script: str, write: Callable[[Path], None]
) -> None:
    out = tmp_path / "out"
    write(out)
    with subprocess.Popen(
        [sys.executable, "-c", script, str(out)], stdout=subprocess.PIPE
    ) as writer:
        assert writer.stdout is not None
        assert writer.stdout.readline() == b"writing\n"
        writer.send_signal(signal.SIGKILL)
    assert (out / "file").read_text() == "new"
    assert list_hidden(tmp_path)
    write(out)
    assert list_hidden(tmp_path)  # it may be that of a command which is at work
    for path in tmp_path.rglob(".*"):
        age(path)
    write(out)
    assert not list_hidden(tmp_path)
    assert [path.name for path in out.iterdir()] == ["file"]


def test_a_users_hidden_file_stays(tmp_path: Path) -> None:
    (tmp_path / ".out.toml").write_text("mine")
    age(tmp_path / ".out.toml")
    write_whole(tmp_path / "out", b"x")
    write_folder(tmp_path / "folder")
    assert list_hidden(tmp_path) == [".out.toml"]


def test_the_old_folder_is_there_until_the_new_one_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing is removed before the last step; where that fails, the old folder comes back."""
    out = tmp_path / "out"
    write_folder(out)
    rename = Path.rename

    def fail_on_new(self: Path, target: Path) -> Path:
        if self.name == "new":
            assert (self.parent / "old" / "file").read_text() == "new"
            raise OSError("disk full")
        return rename(self, target)

    monkeypatch.setattr(Path, "rename", fail_on_new)
    with pytest.raises(OSError, match="disk full"), replace_folder(out) as aside:
        (aside / "other").write_text("")
    assert [path.name for path in out.iterdir()] == ["file"]
    assert not list_hidden(tmp_path)
