"""Noise of the table encoder: what the encoder shows and the gyro does not."""

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.replay.instruments import describe_encoder_noise, estimate_encoder_noise

Array = NDArray[np.float64]

ROWS = 1400
GYRO_NOISE = 0.036 * ARCSEC


def draw_noise(size: float, seed: int) -> Array:
    return size * np.random.default_rng(seed).normal(size=ROWS)


def make_motion(rate: float) -> Array:
    """(n,) angle of a table at rest, accelerated to a rate, and at that rate, rad."""
    rates = np.clip(np.arange(ROWS) - 100, 0, 19) / 19 * rate
    return np.cumsum(rates * 0.1)


@pytest.mark.parametrize("rate", [0.0, 5 * DEG, -100 * DEG])
@pytest.mark.parametrize("size", [0.05 * ARCSEC, 1.0 * ARCSEC])
def test_noise_is_estimated_under_any_motion(rate: float, size: float) -> None:
    """To 10 %, with a stated standard deviation."""
    motion = make_motion(rate)
    estimate = estimate_encoder_noise(
        motion + draw_noise(size, 1), motion + draw_noise(GYRO_NOISE, 2)
    )
    assert estimate == pytest.approx(size, rel=0.1)


@pytest.mark.parametrize("seed", range(20))
def test_common_scatter_is_motion(seed: int) -> None:
    """A table that shakes by 0.3 arcsec, and one at rest, have no encoder noise."""
    shaken = make_motion(5 * DEG) + draw_noise(0.3 * ARCSEC, seed)
    assert estimate_encoder_noise(shaken, shaken + draw_noise(GYRO_NOISE, 100 + seed)) == 0
    assert estimate_encoder_noise(np.zeros(ROWS), draw_noise(GYRO_NOISE, seed)) == 0


def test_an_error_that_lasts_for_rows_is_no_noise() -> None:
    """An encoder's second harmonic of 2 arcsec at 100 deg/s."""
    motion = make_motion(100 * DEG)
    assert (
        estimate_encoder_noise(
            motion + 2 * ARCSEC * np.sin(2 * motion), motion + draw_noise(GYRO_NOISE, 3)
        )
        < 0.01 * ARCSEC
    )


def test_rows_without_a_gyro_are_left_out() -> None:
    motion, angle = make_motion(5 * DEG), make_motion(5 * DEG) + draw_noise(GYRO_NOISE, 2)
    angle[200:260] = np.nan
    estimate = estimate_encoder_noise(motion + draw_noise(ARCSEC, 1), angle)
    assert estimate == pytest.approx(ARCSEC, rel=0.1)
    assert estimate_encoder_noise(motion, np.full(ROWS, np.nan)) == 0
    assert estimate_encoder_noise(motion[:20] + draw_noise(ARCSEC, 1)[:20], angle[:20]) == 0
    assert estimate_encoder_noise(motion[:3], angle[:3]) == 0


def test_the_note_names_the_noisy_tests() -> None:
    assert describe_encoder_noise({"still": 0.0}) == ()
    (note,) = describe_encoder_noise({"still": 0.0, "pos": ARCSEC, "neg": 0.5 * ARCSEC})
    assert note.startswith(
        "table_angle_deg: scatters by up to 1 arcsec where the gyro does not, in pos, neg"
    )
