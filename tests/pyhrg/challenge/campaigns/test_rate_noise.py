"""Rate noise drawn outside the FMU, against its coefficients."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from pyhrg.challenge.campaigns.gyro import draw_rate_noise
from pyhrg.device.device import Device
from pyhrg.noise.fitting import estimate_noise

N, B, K = 3e-6, 2e-7, 2e-8
COUNT = 20_000


@pytest.mark.parametrize(
    ("field", "name", "value"),
    [
        ("angle_random_walk", "angle_random_walk", N),
        ("bias_instability", "bias_instability", B),
        ("rate_random_walk", "rate_random_walk", K),
    ],
)
def test_coefficients_are_found_again(field: str, name: str, value: float) -> None:
    """By the estimator of `noise_model`, within its interval widened to four deviations."""
    base = Device(angle_random_walk=1e-6)
    changed: dict[str, Any] = {field: value}
    device = replace(base, **changed)
    rate = draw_rate_noise(device, COUNT, 1.0, np.random.default_rng(3))
    found = getattr(estimate_noise(np.cumsum(rate), 1.0), name)
    assert found.low - (found.value - found.low) <= value <= 2 * found.high - found.value
    assert found.present


def test_no_noise_is_none() -> None:
    assert not draw_rate_noise(Device(), 100, 0.01, np.random.default_rng(1)).any()


def test_coefficients_leave_the_draws_as_they_are() -> None:
    """So that what a case is can't be told from the noise of another."""
    quiet, loud = Device(angle_random_walk=N), Device(angle_random_walk=N, rate_random_walk=K)
    generators = [np.random.default_rng(1) for _ in range(2)]
    for device, generator in zip((quiet, loud), generators, strict=True):
        draw_rate_noise(device, 50, 1.0, generator)
    assert generators[0].random() == generators[1].random()
