"""A gyro that is no average over its carrier, where one that is is believed in."""

import numpy as np
import pytest

from fmu_build.bundle import build_fmu
from pyhrg.challenge import case
from pyhrg.challenge.campaigns.plans import TESTS, Plan, Variation
from pyhrg.challenge.case import Case, Fmus
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records.campaign import Campaign

NONE = Case("unit-0001", "none", 7, (6.0, 60.0))
FAST = ("rate_high_pos", "rate_high_neg")


def fast_plans(
    device: Device, generator: np.random.Generator, complete: bool = False, data: str = "full"
) -> list[Plan]:
    """A while at rest, and both ways at 100 deg/s."""
    vary = Variation(device, generator)
    still = Plan("static_fixed", "static", "fit", vary.programme(1.0).rest(900.0), 0.3)
    profiles = {test[0]: test[3] for test in TESTS}
    angles = generator.uniform(0, np.pi / 2, len(FAST))
    fast = [
        Plan(name, "rate", "fit", profiles[name](vary), angle)
        for name, angle in zip(FAST, angles.tolist(), strict=True)
    ]
    return [still, *fast]


@pytest.fixture(scope="module")
def fmus(simulation: Simulation) -> Fmus:
    carrier = GyroFmu(build_fmu("HRGCarrier"))
    carrier.prepare()
    return Fmus(carrier, simulation)


def test_short_tests_are_made_at_the_carrier(simulation: Simulation, fmus: Fmus) -> None:
    made = fast_plans(Device(), np.random.default_rng(1))
    assert {plan.id for plan in made if fmus.of(plan) is fmus.carrier} == set(FAST)
    assert {plan.id for plan in made if fmus.of(plan) is simulation.sampled} == {"static_fixed"}


@pytest.fixture(scope="module")
def campaign(simulation: Simulation, fmus: Fmus) -> Campaign:
    """Without a gap."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(case, "plan_tests", fast_plans)
        drawn = case.prepare_case(NONE, simulation)
    made = drawn.record_tests([(plan, fmus.of(plan)) for plan in drawn.plans], case.NOISE)
    return drawn.make_campaign([test for test, _ in made])


def test_what_the_average_leaves_out_is_no_gap(simulation: Simulation, campaign: Campaign) -> None:
    said = diagnose(campaign, simulation=simulation).diagnosis
    assert said.verdict == "no_gap"
    assert said.unknown_probability < 0.1


def test_it_would_be_one(
    simulation: Simulation, campaign: Campaign, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Were it not known of."""
    nothing = property(lambda part: dict.fromkeys(CHANNELS, 0 * part.where.pattern_angle))
    monkeypatch.setattr(LinearTest, "unmodelled", nothing)
    assert diagnose(campaign, simulation=simulation).diagnosis.unknown_probability > 0.9
