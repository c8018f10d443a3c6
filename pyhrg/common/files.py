"""Files and folders that appear whole or not at all."""

import errno
import glob
import os
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path


def check_output_folder(out: Path) -> None:
    """Refuse an output folder that can't be made or written, before any long work."""
    nearest = next(path for path in (out, *out.absolute().parents) if path.exists())
    if not nearest.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, "it is no folder", str(nearest))
    if not os.access(nearest, os.W_OK | os.X_OK):
        raise PermissionError(errno.EACCES, "it can't be written", str(nearest))


def is_file(path: str | Path) -> bool:
    """Whether a file is there; false for a name that no file can have."""
    try:
        return Path(path).is_file()
    except OSError:  # too long
        return False


ASIDE = ".hrg-"
"""Part of the name of what is being written, after the name that it will have."""
STAGE = ".hrg-partial-"
"""Begin of the name of a folder in which the files of an output folder are made."""
LEFTOVER_AGE = 86_400.0
"""Age, s, above which what a killed command left behind is removed. Chosen: no command takes as
long to fill a file or a folder."""


def write_whole(path: Path, data: bytes) -> None:
    """Write a file under another name, then rename it; nothing stays behind when that fails. What
    a killed command left here goes with a later write."""
    prefix = f".{path.name}{ASIDE}"
    _remove_leftovers(path.parent, prefix)
    handle, name = tempfile.mkstemp(prefix=prefix, dir=path.parent)
    aside = Path(name)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        aside.chmod(0o644)
        aside.replace(path)
    except BaseException:
        aside.unlink(missing_ok=True)
        raise


@contextmanager
def replace_folder(folder: Path) -> Iterator[Path]:
    """Give a temporary folder that replaces `folder` and its content when the block succeeds. The
    old folder is moved aside first and removed last, so that no kill loses both."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    prefix = f".{folder.name}{ASIDE}"
    _remove_leftovers(folder.parent, prefix)
    aside = Path(tempfile.mkdtemp(prefix=prefix, dir=folder.parent))
    new, old = aside / "new", aside / "old"
    try:
        new.mkdir()
        yield new
        new.chmod(0o755)
        if folder.exists():
            folder.rename(old)
        try:
            new.rename(folder)
        except BaseException:
            if old.exists():
                old.rename(folder)
            raise
    finally:
        shutil.rmtree(aside, ignore_errors=True)


def _remove_leftovers(folder: Path, prefix: str) -> None:
    """Remove old files and folders whose names begin so: those of commands that were killed."""
    oldest = time.time() - LEFTOVER_AGE
    for path in folder.glob(f"{glob.escape(prefix)}*"):
        with suppress(OSError):
            if path.lstat().st_mtime > oldest:
                continue
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path, ignore_errors=True)
            else:
                path.unlink()


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
        _remove_leftovers(out, STAGE)
        aside = Path(tempfile.mkdtemp(prefix=STAGE, dir=out))
        try:
            yield aside
            for name in names:
                (aside / name).replace(out / name)
        finally:
            shutil.rmtree(aside, ignore_errors=True)
    except BaseException:
        for folder in made:
            if folder.is_dir():
                folder.rmdir()
        raise
