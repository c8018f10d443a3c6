"""From a campaign to its diagnosis: quantify, localise, attribute, close, verify."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.closing.closing import believed_device, closed_device
from pyhrg.gap.closing.gap_figures import gap_figures
from pyhrg.gap.effects.catalogue import WHOLE, Catalogue, NoiseEffect
from pyhrg.gap.effects.design import design
from pyhrg.gap.evidence.attribution import Attribution, attributed
from pyhrg.gap.evidence.hypothesis import Hypothesis, angles_left
from pyhrg.gap.evidence.noise.noise_search import NoiseFound, told_apart
from pyhrg.gap.evidence.noise.quantization import counted, is_rough
from pyhrg.gap.evidence.noise.unstated_noise import with_noise
from pyhrg.gap.evidence.residuals import Remainder, remainders
from pyhrg.gap.evidence.unsteady import unsteady
from pyhrg.gap.findings.diagnosis import Diagnosis, Where
from pyhrg.gap.findings.localisation import Place, located
from pyhrg.gap.findings.quantity import Size, sizes
from pyhrg.gap.findings.verdict import judged, unnamed
from pyhrg.gap.next_test.next_test import suggested
from pyhrg.gap.next_test.rivals import rivals
from pyhrg.gap.next_test.standing_still import standing_still
from pyhrg.gap.replay.encoder import encoder_notes
from pyhrg.gap.replay.free_pattern import steady
from pyhrg.gap.replay.observations import CHANNELS, Observed, observed
from pyhrg.gap.replay.replay import tells_start
from pyhrg.gap.replay.simulation import Answers, Simulation, added
from pyhrg.gap.soundness import sound
from pyhrg.gap.whitening.channel_noise import ChannelNoise, angle_noise
from pyhrg.records.campaign import Campaign, CampaignError

Array = NDArray[np.float64]
Residuals = Mapping[str, Array]

NO_START = "{}: not used: gyro_angle_deg and wave_angle_deg are needed, to tell the start angle"


@dataclass(frozen=True)
class Diagnosed:
    """A diagnosis and what it rests on.

    believed: the gyro before.
    closed: the gyro with what was found.
    tests: all that were looked at, held-out ones last.
    before, after: (n,) residual by channel for each test, record less simulation, SI; NaN where
        they are not compared.
    """

    diagnosis: Diagnosis
    attribution: Attribution
    believed: Device
    closed: Device
    tests: tuple[Observed, ...]
    before: tuple[Residuals, ...]
    after: tuple[Residuals, ...]

    @property
    def noise(self) -> ChannelNoise:
        """Of all channels, with what was found of the output angle's."""
        return replace(self.attribution.channel_noise, angle=self.attribution.noise.noise)


def diagnosed(
    campaign: Campaign,
    simulation: Simulation,
    catalogue: Catalogue = WHOLE,
    say: Callable[[str], None] = lambda text: None,
) -> Diagnosed:
    """Diagnose a campaign.

    Args:
        campaign: as it was read.
        simulation: both fidelities.
        catalogue: all of it, unless one is left out to be missed.
        say: told how far it is.

    Raises:
        CampaignError: nothing can be said of it.
        DeviceError: its nominal values are no gyro's.
        LogError: a log can't be used.
        GyroError: a gyro that the FMU refuses.
    """
    usable, excluded = sound(campaign)
    believed = believed_device(usable)
    told = [test for test in usable.tests if tells_start(test.log)]
    excluded += tuple(NO_START.format(test.id) for test in usable.tests if test not in told)
    to_fit = [observed(test, believed) for test in told if not test.is_holdout]
    if not to_fit:
        raise CampaignError("; ".join(["no test can be fitted to", *excluded]))
    believed, notes = with_noise(simulation, believed, to_fit)
    excluded += (*notes, *encoder_notes({t.test.id: t.encoder for t in to_fit}))
    tests = [steady(simulation, believed, observed(test, believed)) for test in told]
    fitted = [t for t in tests if not t.test.is_holdout]
    found = attributed(simulation, believed, fitted, catalogue, say)
    found = found.with_noises(partial(_noise, found, fitted, catalogue.noises))
    say("closing")
    ordered = (*fitted, *(t for t in tests if t.test.is_holdout))
    closed, before, after = _closed(simulation, found, ordered)
    rest = unsteady(_rest(found), {(b.test, b.channel): b.wrong for b in found.design.blocks})
    say("verifying, and looking for the next test")
    return Diagnosed(
        Diagnosis(
            campaign.device,
            *judged(found, catalogue.effects, rest),
            where=_where(found),
            sizes=_sizes(found, before, after),
            gap=gap_figures(ordered, _angles(before), _angles(after), found),
            next_test=suggested(simulation, found, rivals(found, catalogue.effects))
            or standing_still(found.noise, angle_noise(believed)),
            unnamed=unnamed(found, rest),
            excluded=excluded,
            settled=found.settled,
        ),
        found,
        believed,
        closed,
        ordered,
        before,
        after,
    )


def _noise(
    found: Attribution,
    tests: Sequence[Observed],
    noises: Sequence[NoiseEffect],
    one: Hypothesis,
) -> NoiseFound:
    """Of a hypothesis; of the likeliest, with those that records can't tell from each."""
    noise, believed = one.noise, found.believed
    if one is found.weighed.best:
        left = angles_left(found.parts, found.ranked.best.sizes, found.channel_noise, believed)
        noise = told_apart(noise, left, angle_noise(believed), noises)
    return counted(noise, tests, believed.angle_quantum, noises)


def _closed(
    simulation: Simulation, found: Attribution, tests: Sequence[Observed]
) -> tuple[Device, tuple[Residuals, ...], tuple[Residuals, ...]]:
    """The gyro with what was found, and residuals before and after; a search that did not come to
    rest may end at a gyro that the FMU refuses: then it is the last that could be simulated."""
    closed = closed_device(found)
    try:
        return closed, *_left(simulation, found, closed, tests)
    except GyroError:
        if found.settled:
            raise
        return found.device, *_left(simulation, found, found.device, tests)


def _left(
    simulation: Simulation, found: Attribution, closed: Device, tests: Sequence[Observed]
) -> tuple[tuple[Residuals, ...], tuple[Residuals, ...]]:
    """Residuals of the believed gyro and of the closed one. Tests that were fitted to come first:
    both were simulated, or next to it, when the search ended."""
    believed = found.believed
    before, after = list(found.believed_answers), list[Answers]()
    for part in found.parts:
        change = simulation.difference(part.device, closed, part.test)
        after.append(added(part.answers, change))
    as_believed = closed.without_noise() == believed.without_noise()
    for test in tests[len(found.parts) :]:
        before.append(simulation.answers(believed, test))
        after.append(before[-1] if as_believed else simulation.answers(closed, test))
    return (
        tuple(_residuals(simulation, believed, *pair) for pair in zip(tests, before, strict=True)),
        tuple(_residuals(simulation, closed, *pair) for pair in zip(tests, after, strict=True)),
    )


def _residuals(
    simulation: Simulation, device: Device, test: Observed, answers: Answers
) -> Residuals:
    """As evidence compares them: channels beside the angle where the pattern is as measured."""
    around = simulation.over_angle(device, test)
    residuals = {name: getattr(test.log, name) - answers[name] for name in CHANNELS}
    turned = device.bryan_factor * residuals["gyro_angle"]
    for name in CHANNELS[1:]:
        at_angle = residuals[name] + around.slopes[name] * turned
        residuals[name] = at_angle - around.bent(name, turned)
    return {name: np.where(test.rows[name], residuals[name], np.nan) for name in CHANNELS}


def _rest(found: Attribution) -> list[Remainder]:
    noise = replace(found.channel_noise, angle=found.noise.noise)
    channels = CHANNELS[1:] if is_rough(found.noise, found.believed) else CHANNELS
    left = remainders(found.parts, found.ranked.best.sizes, noise, found.believed, channels)
    return [r for r in left if not (r.channel in noise.per_kelvin and noise.reading_steps[r.test])]


def _where(found: Attribution) -> tuple[Where, ...]:
    noise = replace(found.channel_noise, angle=angle_noise(found.believed))
    places = located(design(found.parts, noise))
    return tuple(_told(place) for place in places)


def _sizes(
    found: Attribution, before: Sequence[Residuals], after: Sequence[Residuals]
) -> tuple[Size, ...]:
    noise = replace(found.channel_noise, angle=angle_noise(found.believed))
    count = len(found.parts)
    return sizes(found.parts, before[:count], after[:count], noise)


def _told(place: Place) -> Where:
    return Where(
        place.test, place.channel, place.coordinate, place.share, place.sigmas, place.harmonic
    )


def _angles(residuals: Sequence[Residuals]) -> list[Array]:
    return [of["gyro_angle"] for of in residuals]
