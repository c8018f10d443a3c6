"""The smoother against a dense covariance, and what it leaves of a coarse quantization."""

import numpy as np

from pyhrg.common.units import ARCSEC, DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.gap.whitening.smoothing import smooth_readings, smooth_walk

ROWS = 60
WHITE, WALK = 0.7, 0.02


def test_the_smoother_is_the_conditional_mean() -> None:
    generator = np.random.default_rng(2)
    is_read = generator.random(ROWS) > 0.2
    series = generator.normal(size=(ROWS, 2))
    series[~is_read, 0] = np.nan
    walk = WALK * np.minimum.outer(np.arange(1, ROWS + 1), np.arange(1, ROWS + 1))
    noisy = walk[np.ix_(is_read, is_read)] + WHITE * np.eye(int(is_read.sum()))
    expected = walk[:, is_read] @ np.linalg.solve(noisy, series[is_read])
    np.testing.assert_allclose(smooth_walk(series, is_read, WHITE, WALK), expected, rtol=1e-10)


def test_the_error_of_quantization_is_no_motion() -> None:
    """An hour at rest, Earth's rate of 9.26 arcsec/s read in steps of 4 arcsec."""
    device = Device(
        angle_white_noise=0.04 * ARCSEC,
        angle_random_walk=3e-4 * DEG_PER_SQRT_H,
        quantization_step=4 * ARCSEC,
    )
    generator = np.random.default_rng(2)
    walk = np.cumsum(generator.normal(0.0, device.angle_random_walk, 3600))
    turned = 9.26 * ARCSEC * np.arange(1, 3601)
    step = device.quantization_step
    read = step * np.round((turned + walk) / step) - turned
    smoothed = smooth_readings(read[:, None], np.full(3600, True), 1.0, device)[:, 0]
    assert np.std(read - walk) > 1.1 * ARCSEC
    assert np.std(smoothed - walk) < 0.15 * ARCSEC
