"""Files and folders that appear whole or not at all."""

import errno
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
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


def write_whole(path: Path, data: bytes) -> None:
    """Write a file under another name, then rename it; nothing stays behind when that fails."""
    handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
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
    """Give a temporary folder that replaces `folder` and its content when the block succeeds."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    aside = Path(tempfile.mkdtemp(prefix=f".{folder.name}.", dir=folder.parent))
    try:
        yield aside
        aside.chmod(0o755)
        if folder.exists():
            shutil.rmtree(folder)
        aside.rename(folder)
    finally:
        shutil.rmtree(aside, ignore_errors=True)


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
        aside = Path(tempfile.mkdtemp(prefix=".partial-", dir=out))
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
