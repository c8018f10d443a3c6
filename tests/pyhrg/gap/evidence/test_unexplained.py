"""What no set explains is told from noise, and counted where more of it is left."""

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.gap.evidence.unexplained import find_excesses, measure_unexplained
from tests.pyhrg.gap.evidence.test_residual_features import rest

ROWS, TESTS = 1000, 3


def noise(seed: int, level: float = 1.0) -> Array:
    return level * np.random.default_rng(seed).standard_normal((TESTS, ROWS))


@pytest.mark.parametrize("level", [0.1, 1.0, 30.0])
def test_noise_of_any_level_is_no_excess(level: float) -> None:
    """Negative control, with a test of a few rows: seeds 0 to 99."""
    for seed in range(100):
        few = level * np.random.default_rng([seed, 1]).standard_normal(4)
        assert not list(find_excesses(rest([*noise(seed, level), few])))


def test_an_excess_is_measured_beside_the_quietest_test() -> None:
    """A curve of 5 sigma, in noise that is twice as loud as stated: an excess of (5/2)^2 / 2 a
    row, and less by as much as the noise may be louder still."""
    series = noise(1, 2.0)
    series[1] += 5 * np.sin(2 * np.pi * np.arange(ROWS) / ROWS)
    ((residual, excess),) = find_excesses(rest(list(series)))
    assert residual.test == "t1"
    assert 2 < excess / ROWS < 25 / 8


def test_components_of_an_excess_are_counted() -> None:
    """A constant is about two components, by the width of its line; white noise has half as many as
    rows."""
    constant, loud = noise(2), noise(3)
    constant[0] += 100
    loud[0] *= 100
    (one,) = measure_unexplained(rest(list(constant))).values()
    (many,) = measure_unexplained(rest(list(loud))).values()
    assert one / many == pytest.approx(ROWS / 2 / 1.93, rel=0.2)
