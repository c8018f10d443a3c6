"""Signals that maps follow."""

import numpy as np
import pytest

from ins_eval.error_model.motion import sample_motion
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.signals import (
    COUNT,
    CROSS_AXES,
    ENVIRONMENT,
    SIGNALS,
    STEADY,
    WARMING,
    Signal,
    slice_coefficients,
)

MOTION = sample_motion(plan_mission("car", 0.1).trajectory(), -300.0, 1.0, 600)


@pytest.mark.parametrize("signal", SIGNALS, ids=[signal.name for signal in SIGNALS])
def test_rate_is_the_derivative(signal: Signal) -> None:
    """Its integral is the value: 0.5 % of the range, or nothing."""
    value, rate = signal.value(MOTION), signal.rate(MOTION)
    step = MOTION.step / 4
    swept = step * np.cumsum((rate[1:] + rate[:-1]) / 2, axis=0)
    change = value[1:] - value[0]
    np.testing.assert_allclose(swept, change, atol=0.005 * np.ptp(value) + 1e-12)


def test_gyros_feel_what_is_along_and_across_them() -> None:
    """Standing level: only the gyro that points down has gravity along it, none has it across."""
    across, along_axis = (signal.value(MOTION)[0] for signal in SIGNALS[4:6])
    assert np.abs(across).max() < 0.01
    assert along_axis == pytest.approx(np.array([0.0, 0.0, -9.81]), abs=0.02)
    assert np.diag(CROSS_AXES) == pytest.approx(np.zeros(3))


def test_parts_are_all() -> None:
    parts = [slice_coefficients(of) for of in (STEADY, WARMING, ENVIRONMENT)]
    assert [p.start for p in parts] + [parts[-1].stop] == [0, parts[0].stop, parts[1].stop, COUNT]
