"""Parking angles against closed form."""

import numpy as np
import pytest

from ins_eval.parking.gyro import REACH, find_flattest_extreme, find_flattest_zero
from pyhrg.common.units import DEG, DEG_PER_H

AXIS = 11.0 * DEG


def fourth(angle: np.ndarray) -> np.ndarray:
    """The map of a damping anisotropy, and a mean."""
    return (0.03 - 0.1 * np.sin(4 * (angle - AXIS))) * DEG_PER_H


def nearest(angle: float, first: float) -> float:
    """Distance to the nearest of angles that come every 45 deg, rad."""
    return abs((angle - first + 22.5 * DEG) % (45 * DEG) - 22.5 * DEG)


def test_fourth_harmonic_is_parked_at_a_zero_or_at_an_extreme() -> None:
    assert nearest(find_flattest_zero(fourth), AXIS) < 0.1 * DEG
    assert nearest(find_flattest_extreme(fourth), AXIS + 22.5 * DEG) < 0.1 * DEG


def test_extreme_leaves_less_within_reach_than_a_zero() -> None:
    """1 - cos against sin of four times the reach."""
    zero, extreme = find_flattest_zero(fourth), find_flattest_extreme(fourth)
    crept = abs(float(fourth(zero + REACH) - 0.03 * DEG_PER_H))
    stayed = abs(float(fourth(extreme + REACH) - fourth(extreme)))
    expected = np.tan(2 * REACH)
    assert stayed / crept == pytest.approx(expected, abs=0.01)


def test_of_several_zeros_the_flattest_is_taken() -> None:
    """A second harmonic makes the zeros differ; the one chosen beats any other angle."""

    def bias(angle: np.ndarray) -> np.ndarray:
        return fourth(angle) + 0.05 * np.cos(2 * angle) * DEG_PER_H

    around = np.linspace(-REACH, REACH, 25)
    left = [
        np.mean((bias(angle + around) - 0.03 * DEG_PER_H) ** 2)
        for angle in np.arange(0.0, 180.0, 1.0) * DEG
    ]
    chosen = np.mean((bias(find_flattest_zero(bias) + around) - 0.03 * DEG_PER_H) ** 2)
    assert chosen <= min(left)
    assert chosen < 0.5 * np.median(left)
