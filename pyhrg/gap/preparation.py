"""From a campaign to what a diagnosis works on: the nominal device and the tests that are used."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from pyhrg.common.units import ZERO_CELSIUS
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import NoiseEffect
from pyhrg.gap.evidence.noise.noise_hypothesis import AddedNoise
from pyhrg.gap.evidence.noise.quantization import find_quantization, put_quantization
from pyhrg.gap.evidence.noise.unstated_noise import complete_stated_noise, require_noise
from pyhrg.gap.replay.free_pattern import truncate_free_pattern
from pyhrg.gap.replay.inputs.inputs import has_start_angle, settle_inputs
from pyhrg.gap.replay.noise_growth import add_noise_growth
from pyhrg.gap.replay.observations import ObservedTest, add_reading_noise, observe_test
from pyhrg.gap.replay.reading_noise import (
    ReadingNoise,
    describe_reading_noise,
    estimate_reading_noise,
)
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.soundness import build_nominal_device, screen_campaign
from pyhrg.gap.soundness.fault import Fault, list_reading_faults
from pyhrg.records.campaign import Campaign, CampaignError, Test
from pyhrg.records.table import merge_sources

CUT = "{}: rows from time_s {:g} on not compared: a free pattern multiplies any earlier turn"
SOAKED = (
    "{}: the resonator had settled to {:.1f} degC before the log began, as the loop frequency shows"
)
UNCOMPARED = "{}: the output angle is compared in no row: its amplitude never settles"
NO_START = "{}: not used: no row with both gyro_angle_deg and wave_angle_deg: no start angle"


class Preparation(NamedTuple):
    """What a diagnosis works on.

    tests: that can be used, held-out ones last; sentences: one on each thing that was left out,
    mended or assumed; faults: of bench and record; quantization: that the readings show and the
    nominal device does not state.
    """

    nominal: Device
    tests: list[ObservedTest]
    sentences: tuple[str, ...]
    faults: tuple[Fault, ...]
    quantization: AddedNoise | None

    @property
    def quantized_device(self) -> Device:
        """The nominal device with the quantization that the readings show."""
        return put_quantization(self.nominal, self.quantization)


def prepare_campaign(
    campaign: Campaign, simulation: Simulation, noises: Sequence[NoiseEffect]
) -> Preparation:
    """Screen a campaign, complete the noise that its nominal device states, and select what each
    test has to compare. `noises` are those that may be named.

    Raises:
        CampaignError: no test can be fitted, or none of these has an output angle to compare.
    """
    nominal, started, excluded, faults = _select_tests(campaign)
    noise = estimate_reading_noise([t.log for t in started if not t.is_holdout])
    observed = observe_tests(started, nominal, noise.encoder.value)
    to_fit = [test for test in observed if not test.test.is_holdout]
    if not any(test.rows["gyro_angle"].any() for test in to_fit):
        raise CampaignError("; ".join(UNCOMPARED.format(test.test.id) for test in to_fit))
    excluded += _describe_uncompared(observed)
    nominal, notes = complete_stated_noise(simulation, nominal, to_fit)
    quantization = find_quantization(to_fit, nominal.quantization_step, noises)
    excluded += (*notes, *describe_reading_noise(noise))
    whole, observed = observed, [_complete_test(simulation, nominal, t, noise) for t in observed]
    excluded += (*_describe_soaked(observed), *_describe_cut(whole, observed))
    tests = list(add_noise_growth(observed, nominal))
    tests.sort(key=lambda test: test.test.is_holdout)
    faults = (*faults, *list_reading_faults(noise))
    return Preparation(nominal, tests, excluded, faults, quantization)


def describe_preparation(campaign: Campaign) -> str:
    """What a diagnosis would leave out of a campaign or take for granted, in words."""
    refusal = "a diagnosis would refuse it: {}"
    try:
        nominal, started, excluded, _ = _select_tests(campaign)
    except CampaignError as error:
        return refusal.format(error)
    observed = observe_tests(started, nominal)
    excluded += _describe_soaked(observed)
    text = "a diagnosis would use all of it"
    if excluded:
        sentences = "\n".join(f"  {sentence}" for sentence in merge_sources(excluded))
        text = f"a diagnosis would leave out, or take for granted:\n{sentences}"
    try:
        require_noise(nominal, [t for t in observed if not t.test.is_holdout])
    except CampaignError as error:
        text += "\n" + refusal.format(error)
    return text


def _select_tests(
    campaign: Campaign,
) -> tuple[Device, list[Test], tuple[str, ...], tuple[Fault, ...]]:
    """The nominal device, the tests that have a start angle, a sentence on what was left out,
    mended or assumed, and faults."""
    usable, excluded, faults = screen_campaign(campaign)
    started = [test for test in usable.tests if has_start_angle(test.log)]
    excluded += tuple(NO_START.format(test.id) for test in usable.tests if test not in started)
    if all(test.is_holdout for test in started):
        raise CampaignError("; ".join(["no test can be fitted to", *excluded]))
    return build_nominal_device(usable), started, excluded, faults


def observe_tests(
    tests: Sequence[Test], nominal: Device, encoder_noise: float = 0.0
) -> list[ObservedTest]:
    """What each test has to compare; `encoder_noise`, rad, is that of all logs. Where one begins
    with a settled resonator, all may: a laboratory that waits before one log waits before
    others."""
    observed = [observe_test(test, nominal, encoder_noise) for test in tests]
    if not any(test.inputs.is_soaked for test in observed):
        return observed
    return [replace(test, inputs=settle_inputs(test.inputs, nominal)) for test in observed]


def _describe_uncompared(observed: list[ObservedTest]) -> tuple[str, ...]:
    """A sentence on each held-out test without an output angle to compare."""
    tests = [t for t in observed if t.test.is_holdout and not t.rows["gyro_angle"].any()]
    return tuple(UNCOMPARED.format(t.test.id) for t in tests)


def _describe_soaked(observed: list[ObservedTest]) -> tuple[str, ...]:
    """A sentence on each test whose log begins with a resonator at the case's temperature."""
    tests = [t.test for t in observed if t.inputs.is_soaked]
    return tuple(SOAKED.format(t.id, t.log.temperature[0] - ZERO_CELSIUS) for t in tests)


def _describe_cut(whole: list[ObservedTest], kept: list[ObservedTest]) -> tuple[str, ...]:
    """A sentence on each test that ends where the angle of a free pattern is known no more."""
    ends = [
        (before.test.id, float(before.log.time[len(after.log.time)]))
        for before, after in zip(whole, kept, strict=True)
        if len(after.log.time) < len(before.log.time)
    ]
    return tuple(CUT.format(name, time) for name, time in ends)


def _complete_test(
    simulation: Simulation, nominal: Device, test: ObservedTest, noise: ReadingNoise
) -> ObservedTest:
    """A test without rows of a free pattern that grew, and with the noise of the bench's
    readings."""
    observed = truncate_free_pattern(simulation, nominal, test)
    if noise == ReadingNoise():
        return observed
    by_pattern = simulation.differentiate_by_angle(nominal, observed).slopes
    by_output = {name: nominal.bryan_factor * slope for name, slope in by_pattern.items()}
    return add_reading_noise(observed, noise, by_output)
