"""The east gyro's bias, hidden by alignment, after a turn."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.alignment.hidden_bias import draw, growth, predicted
from ins_eval.common import earth
from pyhrg.common.units import DEG, DEG_PER_H

LATITUDE, BIAS = 40 * DEG, 0.01 * DEG_PER_H
HOURS_2 = 7200.0


def test_without_a_turn_the_bias_stays_hidden() -> None:
    """1 m of the kilometres that it is worth."""
    assert np.max(np.abs(growth(LATITUDE, BIAS, 0.0, HOURS_2).flown)) < 1.0


@pytest.mark.parametrize("turn", [90 * DEG, 180 * DEG])
def test_after_a_turn_it_grows_as_the_closed_form(turn: float) -> None:
    """To 0.2 % of its 2 to 4 km: the turn takes 20 s."""
    result = growth(LATITUDE, BIAS, turn, HOURS_2)
    radial = np.hypot(*result.predicted[-1])
    assert radial > 2500
    assert np.max(np.abs(result.flown - result.predicted)) < 0.002 * radial


def test_half_a_turn_counts_the_bias_twice() -> None:
    """Early on, before Earth's rotation matters: Schuler's oscillation under a drift of 2 e."""
    time = np.array([600.0])
    schuler = np.sqrt(earth.gravity(LATITUDE, 0.0) / earth.meridian_radius(LATITUDE))
    north = earth.meridian_radius(LATITUDE) * (time - np.sin(schuler * time) / schuler)
    found = predicted(LATITUDE, BIAS, 180 * DEG, time)[:, 0]
    assert found == pytest.approx(2 * BIAS * north, rel=0.01)


def test_figure(tmp_path: Path) -> None:
    draw(LATITUDE, BIAS, 1200.0, tmp_path / "hidden.png")
    assert (tmp_path / "hidden.png").stat().st_size > 10_000
