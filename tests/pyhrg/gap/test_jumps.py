"""Jumps are found at their moments, together where every test has one, and not in noise."""

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.gap.closing.equation.proposal import list_coefficients
from pyhrg.gap.effects.jump import integrate_jump, make_bias_jump, make_step, parse_times
from pyhrg.gap.evidence.jump_search import MOMENTS, find_jumps
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import NoiseModel

ROWS = 2000
TIME = np.arange(1.0, ROWS + 1)
NOISE = NoiseModel(1.0, angle_random_walk=0.05)
SIZE = 0.03


def left(seed: int, test: str, added: Array) -> Residual:
    generator = np.random.default_rng(seed)
    walk = np.cumsum(generator.normal(0.0, NOISE.angle_random_walk, ROWS))
    values = walk + generator.normal(0.0, NOISE.angle_white_noise, ROWS) + added
    return Residual(test, "gyro_angle", values, np.ones(ROWS), 1.0, NOISE)


def test_a_jump_is_found_at_its_moment() -> None:
    planted = SIZE * integrate_jump(TIME, np.array([1300.0]))[:, 0]
    (found,) = find_jumps([left(1, "still", 0 * TIME), left(2, "jumped", planted)])
    ((test, time),) = found.times
    assert test == "jumped"
    assert time == pytest.approx(1300.0, abs=ROWS / MOMENTS)


def test_jumps_of_every_test_are_one_explanation() -> None:
    moments = {"first": 500.0, "second": 900.0, "third": 1500.0}
    found = find_jumps(
        [
            left(i, name, SIZE * integrate_jump(TIME, np.array([moment]))[:, 0])
            for i, (name, moment) in enumerate(moments.items())
        ]
    )
    each = next(dict(jump.times) for jump in found if len(jump.times) == 3)
    assert each == pytest.approx(moments, abs=ROWS / MOMENTS)


def test_noise_does_not_jump() -> None:
    """In less than one set of records of twenty: prior odds of a jump are 0.025."""
    alarms = [
        bool(find_jumps([left(100 * k + i, f"{i}", 0 * TIME) for i in range(3)])) for k in range(40)
    ]
    assert sum(alarms) <= 2


def test_a_jump_is_written_with_its_tests_and_times() -> None:
    times = [("still", 1300.0), ("a second, at rest", 40.5)]
    jump = make_bias_jump(times, 0.0)
    assert parse_times(jump.function.removeprefix("bias: a jump ")) == times
    names = [(c.name, c.basis.test) for c in list_coefficients(jump)]
    assert names == [("bias_jump1_deg_h", "still"), ("bias_jump2_deg_h", "a second, at rest")]


def test_a_step_of_the_pattern_has_no_place_in_a_class() -> None:
    pattern, output = (make_step([("still", 3.0)], 0.0, kind) for kind in ("pattern", "output"))
    assert list_coefficients(pattern) == ()
    assert [c.name for c in list_coefficients(output)] == ["readout_jump1_arcsec"]
