"""Noise that comes and goes, measured by what tells it from steady noise."""

import numpy as np
import pytest

from pyhrg.challenge.truths.unsteadiness import measure_unsteadiness

ROWS = 1 << 16


def noise(seed: int) -> np.ndarray:
    return np.random.default_rng(seed).standard_normal(ROWS)


def test_nothing_is_nothing() -> None:
    assert measure_unsteadiness([[np.zeros(ROWS)]]) == 0
    assert measure_unsteadiness([]) == 0


@pytest.mark.parametrize("size", [0.1, 1.0, 10.0])
def test_steady_noise_is_next_to_nothing(size: float) -> None:
    """Beside the same power in a tenth of the time."""
    loud = np.repeat(np.arange(ROWS // 1024) % 10 == 0, 1024)
    tenth = size * np.sqrt(10) * loud * noise(1)
    assert measure_unsteadiness([[size * noise(1)]]) < 0.2 * measure_unsteadiness([[tenth]])


def test_loud_in_half_the_rows_is_as_strong_as_the_divergence_says() -> None:
    """Power 0.4 in every other stretch: sum of r - 1 - ln r, r over the mean of 1.2."""
    loud = np.repeat(np.arange(ROWS // 1024) % 2 == 0, 1024)
    ratio = np.where(loud, 1.4, 1.0) / 1.2
    expected = np.sqrt(np.sum(ratio - 1 - np.log(ratio)))
    found = measure_unsteadiness([[np.sqrt(0.4) * loud * noise(2)]])
    assert found == pytest.approx(expected, rel=0.05)


def test_a_weak_one_known_by_its_realisation_alone_is_weak() -> None:
    """Its norm is 26 sigmas, which only who knows each value could see."""
    loud = np.repeat(np.arange(ROWS // 1024) % 2 == 0, 1024)
    weak = np.sqrt(0.02) * loud * noise(3)
    assert np.linalg.norm(weak) > 25
    assert measure_unsteadiness([[weak]]) < 3


def test_steady_noise_in_one_kind_of_two_is_steady() -> None:
    """As one kind it would be loud in one of two places."""
    kinds = [[noise(4)], [np.zeros(ROWS)]]
    assert measure_unsteadiness(kinds) < 10
    assert measure_unsteadiness([[series for kind in kinds for series in kind]]) > 50
