"""Blocks of triads: only groups, and files of them."""

from dataclasses import fields
from pathlib import Path

import numpy as np

from ins_eval.mission_model.triads import Triads
from ins_eval.study.block import block
from pyhrg.fmu import GyroFmu
from tests.ins_eval.conftest import KIND, SEED


def same(one: Triads, other: Triads) -> bool:
    return all(np.array_equal(getattr(one, f.name), getattr(other, f.name)) for f in fields(Triads))


def test_blocks_only_group(slow_fmu: GyroFmu, triads: Triads) -> None:
    alone = [block(slow_fmu, KIND, SEED, number, 1) for number in range(2)]
    assert same(Triads.joined(alone), triads)
    assert not same(Triads.joined(alone[::-1]), triads)


def test_saved_and_loaded_the_same(triads: Triads, tmp_path: Path) -> None:
    for name in ("one", "two"):
        triads.save(tmp_path / name)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()
    assert same(Triads.load(tmp_path / "one"), triads)
