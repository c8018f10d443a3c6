"""A study's folder: whose it is, which of its blocks are done; one command at a time."""

import fcntl
import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ins_eval.study.run.block import Arrays, unpacked
from ins_eval.study.run.errors import StudyRunError
from ins_eval.study.run.identity import Identity
from pyhrg.common.files import write_whole
from pyhrg.common.made_by import difference

IDENTITY = "identity.json"
BLOCKS = "blocks"
PARTIAL = ".partial-*"
"""What a command that was killed leaves of files that were not whole."""


@dataclass(frozen=True)
class StudyFolder:
    """path: of the folder; identity: of the study that it holds."""

    path: Path
    identity: Identity

    def keep(self, number: int, file: bytes) -> None:
        """Keep a block's file, whole."""
        self.blocks.mkdir(exist_ok=True)
        write_whole(self.block(number), file)

    def arrays(self, number: int) -> Arrays | None:
        """Of a block; None if it isn't there whole."""
        try:
            return unpacked(self.block(number).read_bytes(), self.identity, number)
        except FileNotFoundError:
            return None

    def forget_blocks(self) -> None:
        """Once the study is complete."""
        shutil.rmtree(self.blocks, ignore_errors=True)

    @property
    def blocks(self) -> Path:
        """Where blocks are kept until the study is complete."""
        return self.path / BLOCKS

    def block(self, number: int) -> Path:
        """Where a block is kept."""
        return self.blocks / f"{number:06d}.npz"


@contextmanager
def claimed(path: Path, identity: Identity) -> Iterator[StudyFolder]:
    """A study's folder, made if it isn't there, for this command alone until the block ends.

    Raises:
        StudyRunError: it holds something else, or a study that differs, or one of another version;
            or another command is at work there. Nothing is changed then.
        OSError: it can't be written.
    """
    path.mkdir(parents=True, exist_ok=True)
    handle = os.open(path, os.O_RDONLY)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise StudyRunError(f"{path}: found another command at work there") from None
        _check(path, identity)
        for left in path.glob(PARTIAL):
            shutil.rmtree(left)
        yield StudyFolder(path, identity)
    finally:
        os.close(handle)


def _check(path: Path, identity: Identity) -> None:
    """Write down whose folder it is, or hold it to what is written there."""
    file = path / IDENTITY
    if not file.exists():
        if others := sorted(p.name for p in path.iterdir() if not p.name.startswith(".")):
            raise StudyRunError(f"{path}: found {others[0]}, expected an empty folder or a study's")
        write_whole(file, identity.text.encode())
        return
    found = _read(file)
    if differs := difference(found.get("study"), identity.study):
        key, here, asked = differs
        raise StudyRunError(
            f"{file}: another study: {key}: found {here!r}, expected {asked!r}; "
            "choose another folder"
        )
    if differs := difference(found.get("made_by"), identity.made_by):
        key, here, asked = differs
        raise StudyRunError(
            f"{file}: a study of another version: {key}: found {here}, expected {asked}; "
            "choose another folder"
        )


def _read(file: Path) -> dict[str, Any]:
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except ValueError as error:
        raise StudyRunError(f"{file}: found what is no JSON: {error}") from error
    if not isinstance(found, dict):
        raise StudyRunError(f"{file}: found no object, expected a study's identity")
    return found
