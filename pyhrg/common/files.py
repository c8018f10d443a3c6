"""Files and folders that appear whole or not at all; files that are read or refused."""

import os
import shutil
import tempfile
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


def toml_of(path: Path, refused: type[Exception]) -> dict[str, Any]:
    """Content of a TOML file.

    Args:
        path: of the file.
        refused: what is raised, with one line about the file, where it can't be read or is none.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise refused(f"{path}: can't be read: {error.strerror or error}") from error
    except ValueError as error:
        raise refused(f"{path}: found what is no TOML: {error}") from error


def write_whole(path: Path, data: bytes) -> None:
    """Write aside, then rename; nothing is left behind when that fails.

    Raises:
        OSError: the folder can't be written.
    """
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
def replaced_folder(folder: Path) -> Iterator[Path]:
    """A folder aside, that takes the place of `folder` and what is in it when the block succeeds.

    Raises:
        OSError: its parent can't be written.
    """
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
def staging(out: Path, names: tuple[str, ...]) -> Iterator[Path]:
    """A folder aside, within `out`, whose files move up when the block succeeds.

    Args:
        out: output folder; made if it isn't there, and removed again if the block fails.
        names: of the files that the block is going to write.

    Raises:
        OSError: on entry, if the folder can't be written or a name is taken by a folder.
    """
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
