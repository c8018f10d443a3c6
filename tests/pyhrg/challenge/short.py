"""Short tests of a plain gyro, for tests that need a simulation."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.programme import Course, Programme, make_course
from pyhrg.challenge import case
from pyhrg.challenge.campaigns.plans import Plan
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_SQRT_H, HZ
from pyhrg.device.device import Device

GYRO = replace(
    Device(),
    damping_anisotropy=1e-6,
    damping_axis=20 * DEG,
    frequency_split=5e-4 * HZ,
    stiffness_axis=65 * DEG,
    frequency_per_kelvin=8.5e-5,
    decay_time_per_kelvin=-3e-3,
    angle_random_walk=3e-4 * DEG_PER_SQRT_H,
    angle_white_noise=0.036 * ARCSEC,
)
GRAVITY = 9.8015


def turning(duration: float = 60.0, rate: float = 5 * DEG) -> Course:
    """The table at a rate, from rest."""
    return make_course(Programme(1.0, GRAVITY).spin(rate, duration), 0.01)


def resting(duration: float = 60.0) -> Course:
    """The table at rest."""
    return make_course(Programme(1.0, GRAVITY).rest(duration), 0.01)


def short_plans(
    device: Device, generator: np.random.Generator, complete: bool = False, data: str = "full"
) -> list[Plan]:
    """Two tests of half a minute."""
    spin = Programme(1.0, GRAVITY).spin(5 * DEG, 30.0)
    rest = Programme(1.0, GRAVITY).rest(30.0)
    return [
        Plan("rate", "rate", "fit", spin, generator.uniform(0, 1)),
        Plan("manoeuvre", "manoeuvre", "holdout", rest, generator.uniform(0, 1)),
    ]


@pytest.fixture
def quick_cases(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cases of two short tests, none of them at the carrier."""
    monkeypatch.setattr(case, "plan_tests", short_plans)
