"""Which effects make the gap: a search around the simulated gyro, moved until it stands still.

Effects enter through the FMU. A first search is linear in them; the gyro is then simulated anew
with what was found, and the search is done again around it, in sizes that still count from the
believed gyro.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.device import Device
from pyhrg.gap.catalogue import DETERMINISTIC, Effect
from pyhrg.gap.channel_noise import ChannelNoise, angle_noise
from pyhrg.gap.design import Design, Evidence, Group
from pyhrg.gap.hypothesis import FIDELITY, Hypothesis, ranked_under, weighed
from pyhrg.gap.noise_search import NoiseFound, alike
from pyhrg.gap.observations import CHANNELS, Observed
from pyhrg.gap.search import Ranked
from pyhrg.gap.simulation import Answers, Simulation
from pyhrg.gap.unknown import coordinates

Array = NDArray[np.float64]

TOLERANCE = 0.1
"""Of an effect's scale, by which its secants are taken."""
ROUNDS = 10
SETTLED = 0.1
"""Move of the gyro, in deviations of the noise, that is none."""
CLOSE = 30.0
"""Move up to which what is left is no leftover of a linear search."""
STALE = 300.0
"""Distance of the gyro from where all secants were taken, from which they are taken anew."""
LINEAR = 1e-3
"""Share of a move's power that may be left because effects are not linear."""


@dataclass(frozen=True)
class Attribution:
    """What was found.

    device: with the named effects of the most probable set, where the search ended.
    ranked: sets, in sizes that count from the believed gyro.
    noise: of the output angle.
    design: around the device.
    parts: of each test, around the device.
    channel_noise: of all channels.
    believed_answers: of the believed gyro to each test.
    settled: whether the search came to rest, or was ended.
    """

    believed: Device
    device: Device
    ranked: Ranked
    noise: NoiseFound
    design: Design
    parts: tuple[Evidence, ...]
    channel_noise: ChannelNoise
    believed_answers: tuple[Answers, ...]
    settled: bool


def attributed(
    simulation: Simulation,
    believed: Device,
    tests: Sequence[Observed],
    effects: Sequence[Effect] = DETERMINISTIC,
    say: Callable[[str], None] = lambda text: None,
) -> Attribution:
    """Find the effects of a campaign.

    What a linear search leaves of a large effect is neither noise nor another effect: noise and all
    that stands out of it are looked for once the gyro has come close.

    Args:
        simulation: both fidelities.
        believed: the gyro before the diagnosis.
        tests: that may be fitted to.
        effects: the catalogue.
        say: told how far it is.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    device, taken, close = believed, believed, False
    share = LINEAR
    noise = NoiseFound(angle_noise(believed), ())
    parts: list[Evidence] = []
    first: tuple[Answers, ...] = ()
    fresh = list(effects)
    heard: tuple[Group, ...] | None = None
    for round_ in range(1, ROUNDS + 1):
        say(f"round {round_}: simulating")
        parts = evidence(simulation, believed, device, tests, effects, parts, fresh)
        first = first or tuple(part.answers for part in parts)
        say(f"round {round_}: searching")
        hypothesis = ranked_under(noise, believed, parts, share)
        if share > FIDELITY and _step(believed, device, hypothesis) < CLOSE:
            share, hypothesis = FIDELITY, ranked_under(noise, believed, parts)
        close = close or (share == FIDELITY and _step(believed, device, hypothesis) < CLOSE)
        if close and hypothesis.ranked.best.groups != heard:
            hypothesis = weighed(hypothesis, believed, parts)
            heard = hypothesis.ranked.best.groups
        found, summed = hypothesis.ranked, hypothesis.design
        moved = _moved(believed, device, found, summed)
        step = _distance(device, moved, summed)
        say(f"round {round_}: moved by {step:.3g} deviations")
        there = _distance(taken, device, summed) < STALE
        settled = step < SETTLED and alike(noise.noise, hypothesis.noise.noise) and there
        noise = hypothesis.noise
        if settled:
            break
        fresh = [] if there else [g for g in found.best.groups if isinstance(g, Effect)]
        if step < CLOSE and _distance(taken, moved, summed) >= STALE:
            taken, fresh = moved, list(effects)
        device = moved
    channels = hypothesis.channel_noise
    return Attribution(
        believed, device, found, noise, summed, tuple(parts), channels, first, settled
    )


def evidence(
    simulation: Simulation,
    believed: Device,
    device: Device,
    tests: Sequence[Observed],
    effects: Sequence[Effect],
    before: Sequence[Evidence] = (),
    fresh: Collection[Effect] = (),
) -> list[Evidence]:
    """Residuals and secants around a device; residuals as they would be around the believed one if
    effects were linear.

    Args:
        simulation: both fidelities.
        believed: the gyro before the diagnosis.
        device: the gyro that is simulated.
        tests: observed.
        effects: that have secants.
        before: around another device, for what needn't be taken anew.
        fresh: effects whose secants are, where there is a before.
    """
    return [
        _evidence(
            simulation,
            believed,
            device,
            test,
            {
                effect: before[i].secants[effect]
                if before and effect not in fresh
                else secants(simulation, device, test, effect)
                for effect in effects
            },
        )
        for i, test in enumerate(tests)
    ]


def _evidence(
    simulation: Simulation,
    believed: Device,
    device: Device,
    test: Observed,
    columns: Mapping[Effect, Mapping[str, Array]],
) -> Evidence:
    answers = simulation.answers(device, test)
    residual = {name: getattr(test.log, name) - answers[name] for name in CHANNELS}
    for effect, own in columns.items():
        away = effect.vector(device) - effect.vector(believed)
        for name in CHANNELS:
            residual[name] = residual[name] + own[name] @ away
    where = coordinates(test, answers["wave_angle"], believed)
    slopes = simulation.slope_over_angle(device, test)
    return Evidence(test, device, answers, residual, columns, where, slopes, believed.bryan_factor)


def secants(
    simulation: Simulation, device: Device, test: Observed, effect: Effect
) -> Mapping[str, Array]:
    """(n, d) by channel: change of the answer per unit of an effect's vector around a device.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    here = effect.vector(device)
    columns: dict[str, list[Array]] = {name: [] for name in CHANNELS}
    for i in range(effect.size):
        step = np.zeros(effect.size)
        step[i] = TOLERANCE * effect.scale
        low, high = (effect.put(device, here + sign * step) for sign in (-1, 1))
        apart = (effect.vector(high) - effect.vector(low))[i]
        change = simulation.difference(low, high, test)
        for name in CHANNELS:
            columns[name].append(change[name] / apart)
    return {name: np.column_stack(found) for name, found in columns.items()}


def _moved(believed: Device, device: Device, found: Ranked, summed: Design) -> Device:
    """The believed gyro with the named effects of the most probable set, as far as they stand out
    of what a move this far may leave behind because effects are not linear."""
    named = [
        (group, group.vector(believed) + value)
        for group, value in zip(found.best.groups, found.best.values, strict=True)
        if isinstance(group, Effect)
    ]
    aim = believed
    for effect, vector in named:
        aim = effect.put(aim, vector)
    left = LINEAR * _distance(device, aim, summed) ** 2
    moved = believed
    for effect, vector in named:
        if _distance(believed, effect.put(believed, vector), summed) ** 2 > left:
            moved = effect.put(moved, vector)
    return moved


def _step(believed: Device, device: Device, hypothesis: Hypothesis) -> float:
    moved = _moved(believed, device, hypothesis.ranked, hypothesis.design)
    return _distance(device, moved, hypothesis.design)


def _distance(old: Device, new: Device, summed: Design) -> float:
    """How far apart two gyros are, in deviations of the noise."""
    unit = np.zeros(len(summed.pull))
    for effect in (group for group in summed.places if isinstance(group, Effect)):
        where = summed.places[effect]
        unit[where] = (effect.vector(new) - effect.vector(old)) * summed.lengths[where]
    return float(np.sqrt(max(float(unit @ summed.gram @ unit), 0.0)))
