"""A study's folder: its identity, its finished blocks; one command works in it at a time."""

import os
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from ins_eval.study.run.block import Arrays, Identity, unpack_block
from pyhrg.common.caches.files import read_cached, write_cached
from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.common.made_by import find_difference
from pyhrg.common.reading.documents import read_json

IDENTITY = "identity.json"
BLOCK_FOLDER = "blocks"
LOCK = ".lock"
"""File in the folder that is locked on Windows, where a folder can't be."""


@dataclass(frozen=True)
class StudyFolder:
    """The folder of a study with this identity."""

    path: Path
    identity: Identity

    def keep(self, number: int, file: bytes) -> None:
        """Write a block's file, whole or not at all."""
        write_cached(self.block(number), file)

    def load_block(self, number: int) -> Arrays | None:
        """Arrays of a block; None where it does not exist or is damaged."""
        file = read_cached(self.block(number))
        return None if file is None else unpack_block(file, self.identity, number)

    def forget_blocks(self) -> None:
        """Delete the blocks, once the study is complete."""
        shutil.rmtree(self.blocks, ignore_errors=True)

    @property
    def blocks(self) -> Path:
        """Folder of the blocks until the study is complete."""
        return self.path / BLOCK_FOLDER

    def block(self, number: int) -> Path:
        return self.blocks / f"{number:06d}.npz"


@contextmanager
def claim_folder(path: Path, identity: Identity) -> Iterator[StudyFolder]:
    """A study's folder, for this command alone inside the context; made where it does not exist.

    Raises:
        HrgError: the folder holds something else, another study or one of another version; or
            another command works in it. Nothing is changed then.
        OSError: the folder can't be written.
    """
    path.mkdir(parents=True, exist_ok=True)
    handle = _lock(path)
    try:
        _check(path, identity)
        yield StudyFolder(path, identity)
    finally:
        os.close(handle)


def _lock(path: Path) -> int:
    """A handle that keeps other commands out of a folder until it is closed."""
    if sys.platform == "win32":
        import msvcrt

        handle = os.open(path / LOCK, os.O_RDWR | os.O_CREAT)
    else:
        import fcntl

        handle = os.open(path, os.O_RDONLY)
    try:
        if sys.platform == "win32":
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        else:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(handle)
        raise HrgError(f"{path}: found another command at work there") from None
    return handle


def _check(path: Path, identity: Identity) -> None:
    """Write the identity into a new folder, or compare it with the one that is there."""
    file = path / IDENTITY
    if not file.exists():
        if others := sorted(p.name for p in path.iterdir() if not p.name.startswith(".")):
            raise HrgError(f"{path}: found {others[0]}, expected an empty folder or a study's")
        write_whole(file, identity.text.encode())
        return
    made = read_json(file)
    if differs := find_difference(made.get("study"), identity.study):
        key, here, asked = differs
        raise HrgError(
            f"{file}: another study: {key}: found {here!r}, expected {asked!r}; "
            "choose another folder"
        )
    if differs := find_difference(made.get("made_by"), identity.made_by):
        key, here, asked = differs
        raise HrgError(
            f"{file}: a study of another version: {key}: found {here}, expected {asked}; "
            "choose another folder"
        )
