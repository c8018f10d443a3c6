"""A case of a challenge: a campaign and its truth."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.bench.programme import make_course
from pyhrg.challenge.campaigns.gyro import TrueGyro
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.challenge.campaigns.laboratory import (
    ENCODER_NOISE,
    LEVELS,
    Laboratory,
    draw_laboratory,
    vary_each,
)
from pyhrg.challenge.campaigns.nominal import draw_nominal, draw_site
from pyhrg.challenge.campaigns.plans import Plan, plan_further_tests, plan_tests
from pyhrg.challenge.truths.meter import Meter, make_measured_course
from pyhrg.challenge.truths.truth import Drawing, TrueState, Truth
from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.common.units import ARCSEC
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.effects.catalogue import EFFECT_NAMES
from pyhrg.gap.replay.sampled import is_short
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records.campaign import Campaign, Test

STEPS = 100
"""Communication steps in a row of the true gyro."""


@dataclass(frozen=True)
class Case:
    """One case. Its name does not depend on its kind.

    Attributes:
        strengths: range that strengths of effects are drawn from, sigmas.
        without: effects that are removed from the diagnosis' catalogue; the true effect is one of
            them.
        level: key of `LEVELS`: how far nominal values and bench are off.
        data: key of `AMOUNTS`: how many tests there are, how long, and in which rows.
    """

    name: str
    kind: str
    seed: int
    strengths: tuple[float, float]
    without: tuple[str, ...] = ()
    level: str = "ideal"
    data: str = "full"


@dataclass(frozen=True)
class Fmus:
    """The models of the gyro: `HRGCarrier` makes the logs of short tests, `HRG` those of all
    others; `HRG` and `HRGSlow` measure strengths."""

    carrier: GyroFmu
    simulation: Simulation

    def of(self, plan: Plan) -> GyroFmu:
        """The model of a test's truth."""
        short = is_short(len(plan.programme), plan.programme.interval)
        return self.carrier if short else self.simulation.sampled


@dataclass(frozen=True)
class PreparedCase:
    """A case that is drawn but not simulated."""

    case: Case
    nominal: Mapping[str, float]
    site: Site
    device: Device
    own: Instruments
    plans: list[Plan]
    state: TrueState
    laboratory: Laboratory

    def record_tests(
        self, plans: Sequence[tuple[Plan, GyroFmu]], stream: int
    ) -> list[tuple[Test, Array]]:
        """Tests of the true gyro, each by its model, and (n,) the part of noise in each output
        angle, rad."""
        noise, state, laboratory = _make_generator(self.case, stream), self.state, self.laboratory
        faults = _make_generator(self.case, stream + len(STREAMS))
        device, reference = laboratory.true_device(state.device), self.device.reference_temperature
        shown = state.disturbance.shown
        disturbance = replace(
            state.disturbance, shown=lambda log: laboratory.read(shown(log), reference)
        )
        made = []
        for plan, fmu in plans:
            gyro = TrueGyro(fmu, device, self.own, disturbance)
            course = make_course(plan.programme, plan.programme.interval / STEPS)
            log, angle_noise = gyro.log(plan.id, course, plan.start_angle, noise)
            log = laboratory.record(log, faults)
            made.append((Test(plan.id, plan.kind, plan.role, log), angle_noise))
        return made

    def make_campaign(self, tests: Sequence[Test]) -> Campaign:
        """A campaign of tests with its nominal device."""
        return Campaign(self.case.name, self.site, self.nominal, tuple(tests))


STREAMS = range(7)
GYRO, BENCH, EFFECT, NOISE, NEXT_BENCH, NEXT_NOISE, LABORATORY = STREAMS
"""Random streams. Gyro, tests and noise have streams of their own, so that they carry no
information about the effect."""


def prepare_case(case: Case, simulation: Simulation) -> PreparedCase:
    """Draw a case from its seed."""
    gyro = _make_generator(case, GYRO)
    nominal, site = draw_nominal(gyro), draw_site(gyro)
    device = replace(device_file.from_table(nominal, "nominal"), site=site)
    own = Instruments().draw_another(gyro)
    made = plan_tests(device, _make_generator(case, BENCH), bool(case.without), case.data)
    fitted = [(make_measured_course(p.programme), p.start_angle) for p in made if p.role == "fit"]
    level = LEVELS[case.level]
    meter = Meter(simulation, device, fitted, own, vary_each(device, level))
    effects = case.without or EFFECT_NAMES
    drawing = Drawing(meter, _make_generator(case, EFFECT), case.strengths, effects)
    laboratory = draw_laboratory(device, level, _make_generator(case, LABORATORY))
    state = drawing.draw_state(case.kind)
    return PreparedCase(case, nominal, site, device, own, made, state, laboratory)


def generate_case(case: Case, fmus: Fmus) -> tuple[Campaign, Truth]:
    """Simulate a case; the same seed gives the same bytes."""
    drawn = prepare_case(case, fmus.simulation)
    made = drawn.record_tests([(plan, fmus.of(plan)) for plan in drawn.plans], NOISE)
    noise = np.concatenate([noise for test, noise in made if test.is_holdout])
    encoder = drawn.laboratory.level * ENCODER_NOISE
    rms = float(np.sqrt(np.mean(noise**2) + encoder**2)) / ARCSEC
    campaign = drawn.make_campaign([test for test, _ in made])
    beyond = drawn.laboratory.list_beyond(drawn.device)
    return campaign, replace(drawn.state.truth, holdout_noise_arcsec=rms, beyond=beyond)


def add_next_test(case: Case, campaign: Campaign, kind: str, hours: float, fmus: Fmus) -> Campaign:
    """A case's campaign with further tests of one kind, simulated by `HRG`: the carrier would take
    too long.

    Raises:
        ValueError: no such kind of test.
    """
    drawn = prepare_case(case, fmus.simulation)
    more = plan_further_tests(kind, hours, drawn.device, _make_generator(case, NEXT_BENCH))
    made = drawn.record_tests([(plan, fmus.simulation.sampled) for plan in more], NEXT_NOISE)
    return drawn.make_campaign((*campaign.tests, *(test for test, _ in made)))


def _make_generator(case: Case, stream: int) -> np.random.Generator:
    return np.random.default_rng(np.random.SeedSequence(case.seed, spawn_key=(stream,)))
