"""Blocks of a study: each result is a pure function of the study and the block's number. The
identity of a study is everything that determines its results to the last bit: the study, the code,
its libraries."""

import hashlib
import io
import json
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.specification import Study
from pyhrg.common.errors import HrgError
from pyhrg.common.made_by import find_difference, list_versions


@dataclass(frozen=True)
class Identity:
    """What determines a study's results.

    Attributes:
        study: all its fields, as JSON values.
        made_by: versions of libraries, and the digest of our own code.
    """

    study: dict[str, Any]
    made_by: dict[str, str]

    @property
    def digest(self) -> str:
        return hashlib.sha256(self.text.encode()).hexdigest()[:32]

    @property
    def text(self) -> str:
        return json.dumps({"study": self.study, "made_by": self.made_by}, indent=1) + "\n"


def identify_study(study: Study) -> Identity:
    """The identity of a study that this machine's code runs."""
    return Identity(_describe_study(study), list_versions())


def _describe_study(study: Study) -> dict[str, Any]:
    """Fields of a study as JSON values; a mission's file is replaced by its digest."""
    values = asdict(study)
    for mission in values["missions"]:
        mission["content"] = f"sha256 {hashlib.sha256(mission['content']).hexdigest()}"
    return dict(json.loads(json.dumps(values)))


LARGEST_BLOCK = 2
"""Largest number of triads of a block. Chosen: with nine missions of two hours their co-simulation
takes a core five minutes, which is the work that a killed command loses."""
SMALL_STUDY_BLOCKS = 32
"""Number of blocks of a small study. Chosen: enough for many workers and for visible progress."""
MARK = "made_for"
"""Name of the array in a block's file that identifies the study and the block."""

Arrays = Mapping[str, NDArray[Any]]
"""Results by name; the first axis counts triads."""
BlockComputation = Callable[[Study, range], Arrays]
"""Computes the results of these triads: a pure function, sent to workers by its name."""


@dataclass(frozen=True)
class BlockWork:
    """The work of a worker on one block; it is pickled and sent to the worker."""

    study: Study
    identity: Identity
    compute: BlockComputation

    def __call__(self, number: int) -> bytes:
        """The block's file.

        Raises:
            HrgError: this worker's code differs from the command's.
        """
        if differs := find_difference(list_versions(), self.identity.made_by):
            key, found, expected = differs
            raise HrgError(
                f"a worker of another version: {key}: found {found}, expected {expected}"
            )
        arrays = self.compute(self.study, list_triads(self.study, number))
        return pack_block(arrays, self.identity, number)


def count_block_triads(study: Study) -> int:
    """Number of triads of each block but the last."""
    return min(LARGEST_BLOCK, -(-study.triads // SMALL_STUDY_BLOCKS))


def count_blocks(study: Study) -> int:
    return -(-study.triads // count_block_triads(study))


def list_triads(study: Study, number: int) -> range:
    """Triads of a block; triads and blocks are counted from 0."""
    first = number * count_block_triads(study)
    return range(first, min(first + count_block_triads(study), study.triads))


def pack_block(arrays: Arrays, identity: Identity, number: int) -> bytes:
    """A block's file, with its identity; the same arrays give the same bytes."""
    buffer = io.BytesIO()
    named: dict[str, Any] = {MARK: np.array(_make_mark(identity, number)), **arrays}
    np.savez(buffer, **named)
    return buffer.getvalue()


def unpack_block(file: bytes, identity: Identity, number: int) -> Arrays | None:
    """Arrays of a block's file; None if it belongs to another block or study."""
    with np.load(io.BytesIO(file)) as stored:
        arrays = dict(stored.items())
    mark = arrays.pop(MARK, None)
    return arrays if mark is not None and str(mark) == _make_mark(identity, number) else None


def join_blocks(blocks: list[Arrays]) -> Arrays:
    """Arrays of all triads, in the order of the blocks; a name may be missing in some blocks."""
    names = dict.fromkeys(name for block in blocks for name in block)
    return {name: np.concatenate([b[name] for b in blocks if name in b]) for name in names}


def _make_mark(identity: Identity, number: int) -> str:
    return f"{identity.digest} {number}"
