"""Sizes that no gyro can have are no explanation."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.evidence.feasibility import Possible
from pyhrg.gap.evidence.search import ranked
from tests.pyhrg.gap.made_up import design_of

DELAY, MISALIGNMENT = EFFECTS["loop_delay"], EFFECTS["input_axis_misalignment"]
ROWS = 400


@pytest.mark.parametrize(
    ("delay", "believed", "is_named"),
    [(1e-3, 0.0, True), (-1e-3, 0.0, False), (-1e-3, 2e-3, True)],
)
def test_no_loop_answers_before_it_is_asked(delay: float, believed: float, is_named: bool) -> None:
    per_second = np.full((ROWS, 1), 1e3)
    noise = np.random.default_rng(1).normal(size=ROWS)
    design = design_of({DELAY: per_second}, per_second[:, 0] * delay + noise)
    device = replace(Device(), loop_delay=believed)
    best = ranked(design, Possible(device, [DELAY])).best
    assert (DELAY in best.named) is is_named


def test_a_size_next_to_its_bound_may_be_noise() -> None:
    per_second = np.full((ROWS, 1), 1e3)
    design = design_of({DELAY: per_second}, np.full(ROWS, -0.05))
    possible = Possible(Device(), [DELAY])
    assert all(possible(fit) for fit in ranked(design).fits)


def test_an_axis_leans_no_further_than_it_can() -> None:
    high = MISALIGNMENT.bounds[1]
    turns = np.linspace(0, 6, ROWS)
    per_rad = 1e3 * np.column_stack([np.cos(turns), np.sin(turns)])
    possible = Possible(Device(), [MISALIGNMENT])
    for size, is_named in ((0.9 * high, True), (1.1 * high, False)):
        design = design_of({MISALIGNMENT: per_rad}, per_rad @ [0.0, -size])
        assert (MISALIGNMENT in ranked(design, possible).best.named) is is_named
