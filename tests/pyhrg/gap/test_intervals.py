"""Intervals of parameters, from the covariance of a vector."""

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.findings.verdict import _intervals

AXIS = EFFECTS["damping_anisotropy"]


def axis_at(degrees: float, magnitude: float = 1e-6) -> Array:
    angle = np.radians(4 * degrees)
    return magnitude * np.array([np.cos(angle), np.sin(angle)])


@pytest.mark.parametrize("degrees", [0.0, 0.01, 45.0, 89.99])
def test_an_axis_has_its_spread_wherever_the_turn_begins(degrees: float) -> None:
    found = _intervals(AXIS, axis_at(degrees), np.eye(2) * 1e-8**2)
    low, high = found["damping_axis_deg"]
    assert high - low == pytest.approx(2 * 1.96 * np.degrees(1e-2) / 4, rel=1e-6)
    assert (low + high) / 2 % 90 == pytest.approx(degrees % 90, abs=1e-6)
    assert found["damping_anisotropy_per_s"] == pytest.approx((0.9804e-6, 1.0196e-6), rel=1e-6)


def test_an_axis_that_can_not_be_told_may_be_anywhere() -> None:
    low, high = _intervals(AXIS, axis_at(10.0, 1e-9), np.eye(2) * 1e-8**2)["damping_axis_deg"]
    assert high - low == pytest.approx(90)
    found = _intervals(AXIS, np.zeros(2), np.eye(2) * 1e-8**2)
    assert found["damping_anisotropy_per_s"][0] == 0.0


def test_correlation_counts() -> None:
    """Along and across the vector, by draws."""
    covariance = np.array([[4.0, 1.5], [1.5, 1.0]]) * 1e-16
    vector = axis_at(12.0)
    low, high = _intervals(AXIS, vector, covariance)["damping_axis_deg"]
    drawn = np.random.default_rng(1).multivariate_normal(vector, covariance, 20000)
    angles = np.degrees(np.arctan2(drawn[:, 1], drawn[:, 0])) / 4
    assert (high - low) / 3.92 == pytest.approx(float(np.std(angles)), rel=0.02)


def test_a_delay_near_zero_has_its_whole_spread() -> None:
    found = _intervals(EFFECTS["loop_delay"], np.array([1e-6]), np.array([[1e-8]]))
    low, high = found["loop_delay_s"]
    assert high - low == pytest.approx(2 * 1.96e-4)
