"""Triads are those of their seeds, in whatever block they are drawn."""

from dataclasses import fields

import numpy as np
import pytest

from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study.gyros.bench_plan import BenchPlan
from ins_eval.study.gyros.drawn_triad import (
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from pyhrg.common.errors import HrgError
from pyhrg.fmu import GyroFmu
from tests.ins_eval.conftest import KIND, SEED


def same(one: TriadBlock, other: TriadBlock) -> bool:
    return all(
        np.array_equal(getattr(one, f.name), getattr(other, f.name)) for f in fields(TriadBlock)
    )


def test_triad_is_the_same_in_any_block(slow_fmu: GyroFmu, triads: TriadBlock) -> None:
    second = tabulate_triads(slow_fmu, [draw_triad(slow_fmu, KIND, make_triad_seed(SEED, 1))])
    assert same(second, triads.select([1]))
    assert not same(second, triads.select([0]))


def test_one_power_on_shows_no_scatter() -> None:
    with pytest.raises(HrgError, match="bench: found 1 power-on of each test, expected 2 or more"):
        TriadDistribution(bench=BenchPlan(runs=1))
