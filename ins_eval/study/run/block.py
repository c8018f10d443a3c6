"""A study in blocks of triads: each a pure function of the study and its number."""

import io
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.run.errors import StudyRunError
from ins_eval.study.run.identity import Identity
from ins_eval.study.specification import Study
from pyhrg.common.made_by import difference, made_by

MOST = 20
"""Triads of a block: the bench takes a minute for them, which is what a kill may cost."""
BLOCKS = 16
"""Of a study that is small: for as many workers, and a bar that moves."""
MARK = "made_for"
"""Array of a block's file that says which block of which study it is."""

Arrays = Mapping[str, NDArray[Any]]
"""By name, numbers or text; along the first axis, triads."""
Made = Callable[[Study, range], Arrays]
"""What becomes of these triads: a pure function, sent to workers by its name."""


@dataclass(frozen=True)
class BlockWork:
    """What a worker does for one block; sent to it as it is."""

    study: Study
    identity: Identity
    made: Made

    def __call__(self, number: int) -> bytes:
        """The block's file.

        Raises:
            StudyRunError: this worker's code is not that of the command.
        """
        if differs := difference(made_by(), self.identity.made_by):
            key, found, expected = differs
            raise StudyRunError(
                f"a worker of another version: {key}: found {found}, expected {expected}"
            )
        arrays = self.made(self.study, triads_of(self.study, number))
        return packed(arrays, self.identity, number)


def size(study: Study) -> int:
    """Triads of each of its blocks but the last."""
    return min(MOST, -(-study.triads // BLOCKS))


def count(study: Study) -> int:
    """Of a study's blocks."""
    return -(-study.triads // size(study))


def triads_of(study: Study, number: int) -> range:
    """Triads of a block, both counted from 0."""
    first = number * size(study)
    return range(first, min(first + size(study), study.triads))


def packed(arrays: Arrays, identity: Identity, number: int) -> bytes:
    """A block's file, which knows which it is; the same bytes of the same arrays."""
    buffer = io.BytesIO()
    named: dict[str, Any] = {MARK: np.array(_mark(identity, number)), **arrays}
    np.savez(buffer, **named)
    return buffer.getvalue()


def unpacked(file: bytes, identity: Identity, number: int) -> Arrays | None:
    """What `packed` was given; None if the file is damaged or another's."""
    try:
        with np.load(io.BytesIO(file)) as stored:
            arrays = dict(stored.items())
    except (OSError, EOFError, ValueError, BadZipFile):
        return None
    mark = arrays.pop(MARK, None)
    return arrays if mark is not None and str(mark) == _mark(identity, number) else None


def joined(blocks: list[Arrays]) -> Arrays:
    """Of all triads, in the order of the blocks; some names may be of a few blocks alone."""
    names = dict.fromkeys(name for block in blocks for name in block)
    return {name: np.concatenate([b[name] for b in blocks if name in b]) for name in names}


def _mark(identity: Identity, number: int) -> str:
    return f"{identity.digest} {number}"
