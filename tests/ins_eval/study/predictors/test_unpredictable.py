"""Noise, accelerometers and mounting against flights that have nothing else."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from tests.ins_eval.study.predictors import cases, flights

COUNT = 4000


@pytest.mark.parametrize("noisy", [0.0, 1.0])
@pytest.mark.parametrize("biased", [0.0, 1.0])
def test_covariance_of_flights_without_maps(noisy: float, biased: float) -> None:
    """Of 4000 triads at three times: products of errors within five sigmas."""
    weights, triads = cases.mission(seed=1, times=3), cases.triads(seed=2, count=COUNT)
    none = np.zeros_like(triads.in_flight)
    noise = noisy * np.abs(np.random.default_rng(3).normal(size=triads.noise.shape)) * cases.WALK
    bare = replace(
        triads,
        in_flight=none,
        noise=noise,
        accelerometers=biased * triads.accelerometers,
        mounting=biased * triads.mounting,
    )
    errors = flights.errors(bare, weights)
    sheets = (biased * sheet for sheet in cases.SHEETS)
    found = compute_unpredictable_covariance(weights, noise, *sheets).mean(axis=0)
    products = errors[..., :, None] * errors[..., None, :]
    scatter = products.std(axis=0) / np.sqrt(COUNT)
    assert np.all(np.abs(products.mean(axis=0) - found) <= 5 * scatter)
