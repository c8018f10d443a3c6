"""Files and folders that appear whole or not at all.

What is being written has a hidden name beside its place, and is locked until it is renamed. A
killed process leaves it unlocked: the next write to the same place removes it. On Windows, and
where a file system knows no locks, it stays.
"""

import difflib
import errno
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from pyhrg.common.errors import HrgError

if sys.platform != "win32":
    import fcntl

PAGE = "report.html"
"""Name of the page that most commands write into their output folder."""
NEW, OLD = ".partial", ".old"
"""Ends of hidden names: of what is being written, then of the folder that it replaces."""


def check_output_folder(out: Path) -> None:
    """Refuse an output folder that can't be made or written, before any long work."""
    nearest = next(path for path in (out, *out.absolute().parents) if path.exists())
    if not nearest.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, "it is no folder", str(nearest))
    try:
        with tempfile.TemporaryFile(dir=nearest):
            pass
    except OSError:
        raise PermissionError(errno.EACCES, "it can't be written", str(nearest)) from None


def make_missing_error(name: str | Path, kind: str, ready: Sequence[str]) -> HrgError:
    """The error about a name that is neither a file nor a ready thing of a kind; it proposes the
    ready one that resembles it, or all."""
    close = difflib.get_close_matches(str(name).lower().replace("_", "-"), ready, n=1) or ready
    found = f"found no such file and no ready {kind} of this name"
    return HrgError(f"{name}: {found}, expected a file or {', '.join(close)}")


def check_output_file(out: Path) -> None:
    """Refuse a file that can't be written because a folder has its name.

    Raises:
        HrgError: it is a folder.
    """
    if out.is_dir():
        raise HrgError(f"can't write {out}: it is a folder; expected the name of a file")


def check_page(out: Path, is_ours: bool) -> None:
    """Refuse to replace the report of another command in an output folder.

    Raises:
        HrgError: there is one.
    """
    if (out / PAGE).exists() and not is_ours:
        raise HrgError(
            f"{out / PAGE}: found the report of another command; choose another folder, or replace "
            "what is there with --force"
        )


def is_file(path: str | Path) -> bool:
    """Whether a file is there; false for a name that no file can have."""
    try:
        return Path(path).is_file()
    except OSError:  # too long
        return False


def write_whole(path: Path, data: bytes) -> None:
    """Write a file under another name, then rename it; nothing stays behind when that fails."""
    with make_aside(path, _make_file) as aside:
        aside.write_bytes(data)
        aside.chmod(0o644)
        aside.replace(path)


@contextmanager
def replace_folder(folder: Path) -> Iterator[Path]:
    """Give a temporary folder that replaces `folder` and its content when the block succeeds."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    with make_aside(folder) as aside:
        yield aside
        aside.chmod(0o755)
        if folder.exists():
            _exchange(aside, folder)
        else:
            aside.rename(folder)


@contextmanager
def stage_files(out: Path, names: tuple[str, ...]) -> Iterator[Path]:
    """Give a temporary folder within `out`, whose files of these names move up to it when the block
    succeeds. `out` is made if it does not exist, and removed again if the block fails."""
    made = [p for p in (out, *out.parents) if not p.exists()]
    try:
        out.mkdir(parents=True, exist_ok=True)
        for name in names:
            if (out / name).is_dir():
                raise IsADirectoryError(21, f"{name} is a folder")
        with make_aside(out / "files") as aside:
            yield aside
            for name in names:
                (aside / name).replace(out / name)
    except BaseException:
        for folder in made:
            if folder.is_dir():
                folder.rmdir()
        raise


def write_files(folder: Path, writers: Mapping[str, Callable[[Path], object]]) -> None:
    """Write files, each by its own function, into a folder: all or none.

    writers: by the file's name.

    Raises:
        OSError: the folder can't be written.
    """
    with stage_files(folder, tuple(writers)) as aside:
        for name, write in writers.items():
            write(aside / name)


def _exchange(aside: Path, folder: Path) -> None:
    """Put a folder in the place of another. The old one has a hidden name in between, under which
    the next write finds it where this process is killed."""
    old = aside.with_name(aside.name + OLD)
    with _lock(folder, wait=False):
        try:
            folder.rename(old)
            aside.rename(folder)
        finally:
            if not folder.exists():
                old.rename(folder)
        _remove(old)


@contextmanager
def make_aside(
    path: Path, make: Callable[[str, str, Path], str] = tempfile.mkdtemp
) -> Iterator[Path]:
    """Give a new, locked folder (or file) of a hidden name beside `path`; removed at the end if it
    is still there. What killed processes left of theirs is cleared first."""
    _clear_leftovers(path)
    while True:
        try:
            aside = Path(make(NEW, f".{path.name}.", path.parent))
        except OSError as error:  # it names a hidden file
            raise type(error)(error.errno, error.strerror, str(path)) from None
        with _lock(aside, wait=True):
            if not aside.exists():  # another process took it for a leftover
                continue
            try:
                yield aside
            finally:
                _remove(aside)
            return


def _make_file(suffix: str, prefix: str, folder: Path) -> str:
    """As `tempfile.mkdtemp`, an empty file."""
    handle, name = tempfile.mkstemp(suffix, prefix, folder)
    os.close(handle)
    return name


def _clear_leftovers(path: Path) -> None:
    """Remove what killed processes left beside `path`; a folder that they were replacing goes back
    to its place where nothing is there."""
    ends = f"{re.escape(NEW)}({re.escape(OLD)})?"
    pattern = re.compile(rf"\.{re.escape(path.name)}\.[a-z0-9_]{{8}}{ends}")
    with suppress(OSError):
        for name in filter(pattern.fullmatch, [each.name for each in path.parent.iterdir()]):
            leftover = path.with_name(name)
            with _lock(leftover, wait=False) as held:
                if held and name.endswith(OLD) and not path.exists():
                    leftover.rename(path)
                elif held:
                    _remove(leftover)


@contextmanager
def _lock(path: Path, wait: bool) -> Iterator[bool]:
    """Lock a file or folder until the block ends, at the latest until this process does; says
    whether it is locked: not where it is gone, another process has it, or there are no locks."""
    if sys.platform == "win32":
        yield False
        return
    try:
        handle = os.open(path, os.O_RDONLY)
    except OSError:
        yield False
        return
    try:
        held = True
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
        except OSError:
            held = False
        yield held
    finally:
        os.close(handle)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)
