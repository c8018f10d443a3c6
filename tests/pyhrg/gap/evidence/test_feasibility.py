"""Sets with infeasible sizes are refused."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.evidence.hypothesis import make_feasibility_check
from pyhrg.gap.evidence.search import rank_sets
from tests.pyhrg.gap.made_up import design_of

DELAY, MISALIGNMENT = EFFECTS["loop_delay"], EFFECTS["input_axis_misalignment"]
ROWS = 400


@pytest.mark.parametrize(
    ("delay", "nominal", "is_named"),
    [(1e-3, 0.0, True), (-1e-3, 0.0, False), (-1e-3, 2e-3, True)],
)
def test_a_negative_delay_is_refused(delay: float, nominal: float, is_named: bool) -> None:
    per_second = np.full((ROWS, 1), 1e3)
    noise = np.random.default_rng(1).normal(size=ROWS)
    design = design_of({DELAY: per_second}, per_second[:, 0] * delay + noise)
    device = replace(Device(), loop_delay=nominal)
    best = rank_sets(design, make_feasibility_check(device, [DELAY])).best
    assert (DELAY in best.named) is is_named


def test_a_size_outside_by_less_than_its_interval_is_kept() -> None:
    per_second = np.full((ROWS, 1), 1e3)
    design = design_of({DELAY: per_second}, np.full(ROWS, -0.05))
    possible = make_feasibility_check(Device(), [DELAY])
    assert all(possible(fit) for fit in rank_sets(design).fits)


def test_a_magnitude_beyond_its_bound_is_refused() -> None:
    high = MISALIGNMENT.bounds[1]
    turns = np.linspace(0, 6, ROWS)
    per_rad = 1e3 * np.column_stack([np.cos(turns), np.sin(turns)])
    possible = make_feasibility_check(Device(), [MISALIGNMENT])
    for size, is_named in ((0.9 * high, True), (1.1 * high, False)):
        design = design_of({MISALIGNMENT: per_rad}, per_rad @ [0.0, -size])
        assert (MISALIGNMENT in rank_sets(design, possible).best.named) is is_named
