"""Steps of the angle are found at their rows, a few of them, and not in noise."""

import numpy as np
import pytest

from pyhrg.gap.effects.jump import evaluate_step
from pyhrg.gap.evidence.jump_search import MAX_STEPS, find_steps
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import NoiseModel

ROWS = 2000
TIME = np.arange(1.0, ROWS + 1)
WALKING = NoiseModel(1.0, angle_random_walk=0.3)
NOISES = [WALKING, NoiseModel(1.0), NoiseModel(1.0, angle_random_walk=0.05, rate_random_walk=1e-3)]
SIZE = 12.0


def left(
    seed: int, test: str, times: list[float], noise: NoiseModel = WALKING, louder: float = 1.0
) -> Residual:
    generator = np.random.default_rng(seed)
    rate = np.cumsum(generator.normal(0.0, noise.rate_random_walk, ROWS))
    walk = np.cumsum(generator.normal(0.0, noise.angle_random_walk, ROWS) + rate)
    values = louder * (walk + generator.normal(0.0, noise.angle_white_noise, ROWS))
    values += SIZE * evaluate_step(TIME, np.array(times)).sum(axis=1)
    return Residual(test, "gyro_angle", values, np.ones(ROWS), 1.0, noise)


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("time", [5.0, 1300.0, 1997.0])
def test_a_step_is_found_at_its_row(noise: NoiseModel, time: float) -> None:
    found = find_steps([left(1, "still", [], noise), left(2, "stepped", [time], noise)])
    assert [(one.times, one.kind) for one in found] == [
        ((("stepped", time),), kind) for kind in ("pattern", "output")
    ]


def test_steps_are_one_explanation() -> None:
    each = find_steps([left(1, "first", [300.0, 1500.0]), left(2, "second", [40.0])])
    assert [len(one.times) for one in each] == [1, 1, 2, 2, 3, 3]
    assert each[-1].times == (("first", 300.0), ("first", 1500.0), ("second", 40.0))
    assert each[-1].words.count("in first") == 2


def test_noise_makes_no_step() -> None:
    """In less than one set of records of forty: that many are expected."""
    assert (
        sum(bool(find_steps([left(100 * k + i, f"{i}", []) for i in range(3)])) for k in range(40))
        <= 1
    )


def test_many_are_noise() -> None:
    often = np.linspace(100.0, 1900.0, MAX_STEPS + 1).round().tolist()
    assert not find_steps([left(1, "often", often)])
    assert not find_steps([left(1, "loud", [], louder=4.0)])


def test_a_step_of_a_quantum_is_none() -> None:
    stepped = [left(1, "stepped", [1300.0])]
    assert find_steps(stepped, 0.8 * SIZE)
    assert not find_steps(stepped, 1.2 * SIZE)


def test_too_little_tells_nothing() -> None:
    short = Residual("short", "gyro_angle", np.ones(3), np.ones(3), 1.0, WALKING)
    assert not find_steps([short])
    assert not find_steps([])
