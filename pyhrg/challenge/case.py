"""One case of a challenge: a campaign, and its truth."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.challenge.campaigns.course import Course, course_of
from pyhrg.challenge.campaigns.gyro import TrueGyro
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.challenge.campaigns.nominal import believed, drawn_nominal, drawn_site
from pyhrg.challenge.campaigns.plans import Plan, further, plans
from pyhrg.challenge.truths.meter import Meter, measured
from pyhrg.challenge.truths.truth import Drawing, TrueState, Truth
from pyhrg.common.site import Site
from pyhrg.common.units import ARCSEC
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.effects.catalogue import NAMES
from pyhrg.gap.replay.simulation import Simulation, is_short
from pyhrg.records.campaign import Campaign, Test

Array = NDArray[np.float64]
STEPS = 100
"""Communication steps in a row of the true gyro."""


@dataclass(frozen=True)
class Case:
    """One case: its name says nothing of its kind.

    strengths: sigmas that effects are drawn from.
    without: effects that the diagnosis' catalogue lacks; of these the case's effect is drawn.
    """

    name: str
    kind: str
    seed: int
    strengths: tuple[float, float]
    without: tuple[str, ...] = ()


@dataclass(frozen=True)
class Fmus:
    """The gyro's models.

    carrier: `HRGCarrier`, of the truth of a campaign's short tests.
    simulation: `HRG`, of that of all others; with `HRGSlow`, of the strengths.
    """

    carrier: GyroFmu
    simulation: Simulation

    def of(self, plan: Plan) -> GyroFmu:
        """The model of a test's truth."""
        programme = plan.programme
        short = is_short(len(programme), programme.interval)
        return self.carrier if short else self.simulation.sampled


@dataclass(frozen=True)
class Prepared:
    """A case before its tests are made."""

    case: Case
    nominal: Mapping[str, float]
    site: Site
    device: Device
    own: Instruments
    plans: list[Plan]
    state: TrueState

    def recorded(
        self, plans: Sequence[tuple[Plan, GyroFmu]], stream: int
    ) -> list[tuple[Test, Array]]:
        """Tests of the true gyro, each by its model, and (n,) what noise makes of each one's output
        angle, rad."""
        noise, state = _generator(self.case, stream), self.state
        made = []
        for plan, fmu in plans:
            gyro = TrueGyro(fmu, state.device, self.own, state.disturbance)
            log, off = gyro.log(plan.id, _course(plan), plan.start_angle, noise)
            made.append((Test(plan.id, plan.kind, plan.role, log), off))
        return made

    def campaign(self, tests: Sequence[Test]) -> Campaign:
        """Tests, with what is believed of the gyro."""
        return Campaign(self.case.name, self.site, self.nominal, tuple(tests))


GYRO, BENCH, EFFECT, NOISE, NEXT_BENCH, NEXT_NOISE = range(6)
"""Streams of random numbers: gyro, tests and noise are drawn apart from the effect, so that they
tell nothing of it."""


def prepared(case: Case, simulation: Simulation) -> Prepared:
    """Draw a case: the same wherever it is done."""
    gyro = _generator(case, GYRO)
    nominal, site = drawn_nominal(gyro), drawn_site(gyro)
    device, own = believed(nominal, site), Instruments().drawn(gyro)
    made = plans(device, _generator(case, BENCH), complete=bool(case.without))
    fitted = [(measured(p.programme), p.start_angle) for p in made if p.role == "fit"]
    meter = Meter(simulation, device, fitted, own)
    effects = case.without or NAMES
    drawing = Drawing(meter, _generator(case, EFFECT), case.strengths, effects)
    return Prepared(case, nominal, site, device, own, made, drawing.state(case.kind))


def generated(case: Case, fmus: Fmus) -> tuple[Campaign, Truth]:
    """Simulate a case: the same bytes wherever it is done."""
    drawn = prepared(case, fmus.simulation)
    made = drawn.recorded([(plan, fmus.of(plan)) for plan in drawn.plans], NOISE)
    noise = np.concatenate([noise for test, noise in made if test.is_holdout])
    rms = float(np.sqrt(np.mean(noise**2))) / ARCSEC
    campaign = drawn.campaign([test for test, _ in made])
    return campaign, replace(drawn.state.truth, holdout_noise_arcsec=rms)


def with_next_test(case: Case, campaign: Campaign, kind: str, hours: float, fmus: Fmus) -> Campaign:
    """A case's campaign with so many hours more of the tests of one kind, all by `HRG`: hours at
    the carrier would take as long.

    Raises:
        ValueError: no such kind of test.
    """
    drawn = prepared(case, fmus.simulation)
    more = further(kind, hours, drawn.device, _generator(case, NEXT_BENCH))
    made = drawn.recorded([(plan, fmus.simulation.sampled) for plan in more], NEXT_NOISE)
    return drawn.campaign((*campaign.tests, *(test for test, _ in made)))


def _generator(case: Case, stream: int) -> np.random.Generator:
    return np.random.default_rng(np.random.SeedSequence(case.seed, spawn_key=(stream,)))


def _course(plan: Plan) -> Course:
    return course_of(plan.programme, plan.programme.interval / STEPS)
