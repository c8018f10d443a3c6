"""Competitors: no false evidence on white numbers, each finds its own."""

import numpy as np
import pytest
from scipy.fft import dct

from pyhrg.gap.static_record.fit.unknowns import assess_unknowns, split_octaves

N = 2047


def white(seed: int) -> np.ndarray:
    return np.random.default_rng([7, seed]).standard_normal(N)


def test_ratios_average_to_one_or_less() -> None:
    """n = 300, seed 7: Markov's inequality then bounds false alarms."""
    ratios = np.exp([[u.log_ratio for u in assess_unknowns(white(seed))] for seed in range(300)])
    error = np.std(ratios, axis=0) / np.sqrt(len(ratios))
    assert np.all(np.mean(ratios, axis=0) < 1 + 3 * error)
    assert np.mean(ratios > 50) <= 0.02


@pytest.mark.parametrize("kind", ["excess in the spectrum", "periodic signal"])
def test_each_finds_its_own(kind: str) -> None:
    values = white(0)
    if kind == "periodic signal":
        values[1200] += 9.0
    else:
        values[256:512] *= 1.5
    found = assess_unknowns(values)
    best = max(found, key=lambda u: u.log_ratio)
    assert best.name == kind
    assert best.log_ratio > 5


def test_noise_that_grows_is_seen_in_time() -> None:
    """White numbers twice as large in the second half of the record, of the same mean power."""
    series = np.random.default_rng(3).standard_normal(N)
    series[N // 2 :] *= 2.0
    series /= np.std(series)
    found = {u.name: u.log_ratio for u in assess_unknowns(dct(series, norm="ortho"))}
    assert found["noise that changes with time"] > 20
    assert found["noise that changes with time"] > found["excess in the spectrum"] + 10


def test_octaves_cover_all_once() -> None:
    covered = np.concatenate([np.arange(N)[band] for band in split_octaves(N)])
    np.testing.assert_array_equal(np.sort(covered), np.arange(N))
