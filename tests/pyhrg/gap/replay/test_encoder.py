"""An encoder's noise is what it shows and the gyro does not."""

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.replay.encoder import encoder_noise, encoder_notes

Array = NDArray[np.float64]

ROWS = 1400
GYRO = 0.036 * ARCSEC


def noise(size: float, seed: int) -> Array:
    return size * np.random.default_rng(seed).normal(size=ROWS)


def moved(rate: float) -> Array:
    """At rest, up to a rate, and on."""
    rates = np.clip(np.arange(ROWS) - 100, 0, 19) / 19 * rate
    return np.cumsum(rates * 0.1)


@pytest.mark.parametrize("rate", [0.0, 5 * DEG, -100 * DEG])
@pytest.mark.parametrize("size", [0.05 * ARCSEC, 1.0 * ARCSEC])
def test_noise_is_told_whatever_the_motion(rate: float, size: float) -> None:
    """To 10 %."""
    motion = moved(rate)
    found = encoder_noise(motion + noise(size, 1), motion + noise(GYRO, 2))
    assert found == pytest.approx(size, rel=0.1)


@pytest.mark.parametrize("seed", range(20))
def test_what_both_show_is_motion(seed: int) -> None:
    """A table that shakes by 0.3 arcsec, and one that rests."""
    shaken = moved(5 * DEG) + noise(0.3 * ARCSEC, seed)
    assert encoder_noise(shaken, shaken + noise(GYRO, 100 + seed)) == 0
    assert encoder_noise(np.zeros(ROWS), noise(GYRO, seed)) == 0


def test_an_error_that_lasts_for_rows_is_none() -> None:
    """An encoder's second harmonic of 2 arcsec at 100 deg/s."""
    motion = moved(100 * DEG)
    assert (
        encoder_noise(motion + 2 * ARCSEC * np.sin(2 * motion), motion + noise(GYRO, 3))
        < 0.01 * ARCSEC
    )


def test_rows_without_a_gyro_are_left_out() -> None:
    motion, angle = moved(5 * DEG), moved(5 * DEG) + noise(GYRO, 2)
    angle[200:260] = np.nan
    found = encoder_noise(motion + noise(ARCSEC, 1), angle)
    assert found == pytest.approx(ARCSEC, rel=0.1)
    assert encoder_noise(motion, np.full(ROWS, np.nan)) == 0
    assert encoder_noise(motion[:20] + noise(ARCSEC, 1)[:20], angle[:20]) == 0
    assert encoder_noise(motion[:3], angle[:3]) == 0


def test_it_is_told_where_it_is() -> None:
    assert encoder_notes({"still": 0.0}) == ()
    (told,) = encoder_notes({"still": 0.0, "pos": ARCSEC, "neg": 0.5 * ARCSEC})
    assert told.startswith(
        "table_angle_deg: scatters by up to 1 arcsec where the gyro does not, in pos, neg"
    )
