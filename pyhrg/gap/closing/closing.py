"""The nominal device, the identified device with the causes put in, and the residuals of both."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import EFFECTS, NOISE_EFFECTS
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings.diagnosis import Diagnosis, DiagnosisError
from pyhrg.gap.findings.term import Term
from pyhrg.gap.replay.observations import CHANNELS, ObservedTest
from pyhrg.gap.replay.simulation import ChannelValues, Simulation, add_channels
from pyhrg.gap.soundness.fault import FAULT_NAMES

Residuals = Mapping[str, Array]
"""(n,) record less simulation by channel, SI; NaN where the two are not compared."""


@dataclass(frozen=True)
class Closing:
    """The identified device, and the residuals of each test before and after closing.

    terms: verified terms, which then act in the residuals after closing.
    """

    device: Device
    before: tuple[Residuals, ...]
    after: tuple[Residuals, ...]
    terms: tuple[Term, ...] = ()


def read_identified_device(nominal: Device, diagnosis: Diagnosis) -> Device:
    """The nominal device with the causes of a diagnosis, and what is off within its tolerance, put
    in; noise, and faults of bench and record, are left out. A `DiagnosisError` where the catalogue
    has no such effect, or a parameter is missing."""
    device = nominal
    changes = [("causes", cause.effect, cause.parameters) for cause in diagnosis.causes]
    changes += [("within_tolerance", k.name, k.parameters) for k in diagnosis.within_tolerance]
    for key, name, parameters in changes:
        if name in NOISE_EFFECTS or name in FAULT_NAMES:
            continue
        if name not in EFFECTS:
            names = ", ".join((*EFFECTS, *NOISE_EFFECTS, *FAULT_NAMES))
            raise DiagnosisError(f"{key}: {name}: expected one of {names}")
        missing = [k.name for k in EFFECTS[name].keys if k.name not in parameters]
        if missing:
            raise DiagnosisError(f"{key}: {name}: {missing[0]}: missing; expected a number")
        device = EFFECTS[name].put(device, EFFECTS[name].vector_of(parameters))
    return device


def close_gap(
    simulation: Simulation, attribution: Attribution, tests: Sequence[ObservedTest]
) -> Closing:
    """Simulate the identified device and compare both devices with the records.

    Tests are those that were fitted to, in the search's order, then the held-out ones. A search
    that did not converge may end at a device that the FMU refuses. The last device that could be
    simulated is then taken for the identified one.
    """
    levels: dict[str, Any] = {added.effect.field: added.total for added in attribution.noise.added}
    identified = replace(attribution.posterior.best.identify_device(attribution.nominal), **levels)
    try:
        return _compare(simulation, attribution, identified, tests)
    except GyroError:
        if attribution.settled:
            raise
        return _compare(simulation, attribution, attribution.device, tests)


def _compare(
    simulation: Simulation,
    attribution: Attribution,
    identified: Device,
    tests: Sequence[ObservedTest],
) -> Closing:
    """Residuals of both devices. The search already holds simulations of the fitted tests: of the
    nominal device, and of one next to the identified one."""
    nominal = attribution.nominal
    before, after = list(attribution.nominal_answers), list[ChannelValues]()
    for part in attribution.parts:
        change = simulation.compute_difference(part.device, identified, part.test)
        after.append(add_channels(part.simulated, change))
    is_unchanged = identified.without_noise() == nominal.without_noise()
    for test in tests[len(attribution.parts) :]:
        before.append(simulation.simulate(nominal, test))
        after.append(before[-1] if is_unchanged else simulation.simulate(identified, test))

    def compare(device: Device, answers: Sequence[ChannelValues]) -> tuple[Residuals, ...]:
        pairs = zip(tests, answers, strict=True)
        return tuple(compute_record_residuals(simulation, device, *pair) for pair in pairs)

    return Closing(identified, compare(nominal, before), compare(identified, after))


def compute_record_residuals(
    simulation: Simulation, device: Device, test: ObservedTest, answers: ChannelValues
) -> Residuals:
    """Record less simulation, channels other than the angle where the pattern is as measured."""
    by_angle = simulation.differentiate_by_angle(device, test)
    residuals = {name: getattr(test.log, name) - answers[name] for name in CHANNELS}
    turned = device.bryan_factor * residuals["gyro_angle"]
    for name in CHANNELS[1:]:
        at_angle = residuals[name] + by_angle.turn(name, turned, test.log)
        residuals[name] = at_angle - by_angle.bend(name, turned)
    return {name: np.where(test.rows[name], residuals[name], np.nan) for name in CHANNELS}
