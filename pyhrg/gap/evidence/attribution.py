"""Which effects make the gap: a search around the simulated gyro, moved until it stands still.

Effects enter through the FMU. A first search is linear in them; the gyro is then simulated anew
with what was found, and the search is done again around it, in sizes that still count from the
believed gyro.
"""

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import WHOLE, Catalogue, Effect
from pyhrg.gap.effects.design import Design, Group, LinearTest, response_power
from pyhrg.gap.effects.sensitivities import linear_test, secants
from pyhrg.gap.evidence.hypothesis import Hypothesis, noise_as_believed, ranked_under
from pyhrg.gap.evidence.noise.noise_levels import alike
from pyhrg.gap.evidence.noise.noise_search import NoiseFound
from pyhrg.gap.evidence.search import Ranked
from pyhrg.gap.evidence.weighing import Weighed, weighed
from pyhrg.gap.replay.observations import Observed
from pyhrg.gap.replay.simulation import Answers, Simulation, added
from pyhrg.gap.whitening.channel_noise import ChannelNoise, angle_noise

Array = NDArray[np.float64]

ROUNDS = 20
"""Of moves, at most."""
SETTLED = 0.1
"""Move of the gyro, in deviations of the noise, that is none."""
CLOSE = 30.0
"""Move up to which what is left is no leftover of a linear search."""
STALE = 300.0
"""Distance of the gyro from where all secants were taken, from which they are taken anew."""
FAR = 10.0
"""The same of the one that was simulated with running loops where they move."""
HALVINGS = 8
"""Of a move to a gyro that the FMU refuses."""
LINEAR = 1e-3
"""Share of a move's power that may be left because effects are not linear: what is yet to be moved
the first time, what was moved last from then on."""
EASED = 4.0
"""By which that comes down from round to round at least: what takes turns at explaining is told
apart by all that the records say."""
LITTLE = 1.0
"""Of it, in deviations of the noise squared, that is none."""


@dataclass(frozen=True)
class Attribution:
    """What was found.

    device: with the named effects of the most probable set, where the search ended.
    weighed: noises with their sets, in sizes that count from the believed gyro.
    parts: of each test, around the device.
    believed_answers: of the believed gyro to each test.
    settled: whether the search came to rest, or was ended.
    """

    believed: Device
    device: Device
    weighed: Weighed
    parts: tuple[LinearTest, ...]
    believed_answers: tuple[Answers, ...]
    settled: bool

    @property
    def ranked(self) -> Ranked:
        """Sets under the likeliest noise."""
        return self.weighed.best.ranked

    @property
    def noise(self) -> NoiseFound:
        """The likeliest of the output angle."""
        return self.weighed.best.noise

    @property
    def design(self) -> Design:
        """Around the device, under the likeliest noise."""
        return self.weighed.best.design

    @property
    def channel_noise(self) -> ChannelNoise:
        """Of all channels."""
        return self.weighed.best.channel_noise

    def with_noises(self, change: Callable[[Hypothesis], NoiseFound]) -> "Attribution":
        """The same with other noises found."""
        return replace(self, weighed=self.weighed.with_noises(change))


def attributed(
    simulation: Simulation,
    believed: Device,
    tests: Sequence[Observed],
    catalogue: Catalogue = WHOLE,
    say: Callable[[str], None] = lambda text: None,
) -> Attribution:
    """Find the effects of a campaign.

    Args:
        simulation: both fidelities.
        believed: the gyro before the diagnosis.
        tests: that may be fitted to.
        catalogue: of what may be named.
        say: told how far it is.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    approach = _Approach(simulation, believed, tests, catalogue)
    for round_ in range(1, ROUNDS + 1):
        say(f"round {round_}: simulating")
        approach.simulate()
        say(f"round {round_}: searching")
        hypothesis = approach.searched()
        say(f"round {round_}: moved by {approach.step(hypothesis):.3g} deviations")
        settled = approach.settles(hypothesis)
        approach.noise = hypothesis.noise
        if settled or round_ == ROUNDS:
            break
        approach.move(hypothesis)
    return Attribution(
        believed,
        approach.device,
        approach.weighed,
        tuple(approach.parts),
        approach.believed_answers,
        settled,
    )


class _Approach:
    """The way from the believed gyro to the one that makes the records.

    What a linear search leaves of a large effect is neither noise nor another effect: noise and all
    that stands out of it are looked for once the gyro has come close.
    """

    def __init__(
        self,
        simulation: Simulation,
        believed: Device,
        tests: Sequence[Observed],
        catalogue: Catalogue,
    ) -> None:
        self._simulation = simulation
        self._believed = believed
        self._tests = tests
        self._catalogue = catalogue
        self._fresh: Collection[Effect] = catalogue.effects
        self._taken = believed
        self._simulated: Device | None = None
        self._leftover = self._most_left = math.inf
        self._heard: tuple[Group, ...] | None = None
        self.device = believed
        self.noise = NoiseFound(angle_noise(believed), ())
        self.parts: list[LinearTest] = []
        self.weighed = Weighed((), ())
        self.believed_answers: tuple[Answers, ...] = ()

    def simulate(self) -> None:
        """Take residuals around the gyro, and the secants that are due; half way to it, or half of
        that, where the FMU refuses it; as they were where it refuses every step."""
        for _ in range(HALVINGS):
            try:
                self._simulate()
                return
            except GyroError:
                if not self.parts:
                    raise
                self.device = _midway(self.parts[0].device, self.device, self._catalogue.effects)
        self.device = self.parts[0].device

    def _simulate(self) -> None:
        if self.parts and self.parts[0].device is self.device and not self._fresh:
            return
        answers = self._answers()
        self.parts = [
            linear_test(
                self._simulation, self._believed, self.device, test, answers[i], self._secants(i)
            )
            for i, test in enumerate(self._tests)
        ]
        self._simulated = self._simulated or self.device
        self.believed_answers = self.believed_answers or tuple(answers)

    def _answers(self) -> list[Answers]:
        """Of the gyro; beside one that was simulated, loops at rest tell the difference."""
        simulation, device = self._simulation, self.device
        if self._simulated is None:
            return [simulation.answers(device, test) for test in self._tests]
        return [
            added(part.answers, simulation.difference(part.device, device, part.test))
            for part in self.parts
        ]

    def _secants(self, index: int) -> dict[Effect, Mapping[str, Array]]:
        test, device = self._tests[index], self.device
        kept = self.parts[index].secants if self.parts else {}
        return {**kept, **secants(self._simulation, device, test, self._fresh)}

    def searched(self) -> Hypothesis:
        """What explains the residuals; noises weighed anew where the sets have changed."""
        if self._leftover == math.inf:
            noise = noise_as_believed(self._believed, self.parts)
            self._ease(LINEAR * sum(response_power(self.parts, noise).values()))
        hypothesis = ranked_under(self.noise, self._believed, self.parts, self._leftover)
        if self._leftover and self.step(hypothesis) < CLOSE:
            hypothesis = ranked_under(self.noise, self._believed, self.parts)
        is_close = not self._leftover or self.step(hypothesis) < CLOSE
        self._ease(0.0 if is_close else LINEAR * self.step(hypothesis) ** 2)
        if not is_close:
            self.weighed = Weighed((hypothesis,), (1.0,))
        elif hypothesis.ranked.best.groups == self._heard:
            self.weighed = self.weighed.anew(hypothesis)
        else:
            self.weighed = weighed(hypothesis, self._believed, self.parts, self._catalogue.noises)
            is_near = self.step(hypothesis) < CLOSE
            self._heard = self.weighed.best.ranked.best.groups if is_near else None
        return self.weighed.best

    def _ease(self, leftover: float) -> None:
        """Take this for what a linear search leaves, as far as it has come down."""
        least = min(leftover, self._most_left)
        self._leftover = least if least > LITTLE else 0.0
        self._most_left = least / EASED

    def step(self, hypothesis: Hypothesis) -> float:
        """How far a hypothesis moves the gyro, in deviations of the noise."""
        moved = _moved(self._believed, self.device, hypothesis)
        return _distance(self.device, moved, hypothesis.design)

    def settles(self, hypothesis: Hypothesis) -> bool:
        """Whether it moves neither gyro nor noise, and secants are as they should be."""
        known = alike(self.noise.noise, hypothesis.noise.noise)
        return known and self._has_near_secants(hypothesis) and self.step(hypothesis) < SETTLED

    def move(self, hypothesis: Hypothesis) -> None:
        """To where the hypothesis has the gyro."""
        moved = _moved(self._believed, self.device, hypothesis)
        named = list(hypothesis.ranked.best.named)
        self._fresh = [] if self._has_near_secants(hypothesis) else named
        is_far = _distance(self._taken, moved, hypothesis.design) >= STALE
        if is_far and self.step(hypothesis) < CLOSE:
            self._taken, self._fresh = moved, self._catalogue.effects
        if self._simulated and _distance(self._simulated, moved, hypothesis.design) >= FAR:
            self._simulated = None
        self.device = moved

    def _has_near_secants(self, hypothesis: Hypothesis) -> bool:
        return _distance(self._taken, self.device, hypothesis.design) < STALE


def _moved(believed: Device, device: Device, hypothesis: Hypothesis) -> Device:
    """The believed gyro with the named effects of the most probable set, as far as they stand out
    of what a move this far may leave behind because effects are not linear."""
    found, summed = hypothesis.ranked, hypothesis.design
    named = [(effect, effect.vector(believed) + size) for effect, size in found.best.named.items()]
    aim = believed
    for effect, vector in named:
        aim = effect.put(aim, vector)
    left = LINEAR * _distance(device, aim, summed) ** 2
    moved = believed
    for effect, vector in named:
        if _distance(believed, effect.put(believed, vector), summed) ** 2 > left:
            moved = effect.put(moved, vector)
    return moved


def _midway(one: Device, other: Device, effects: Sequence[Effect]) -> Device:
    """A gyro between two."""
    for effect in effects:
        one = effect.put(one, (effect.vector(one) + effect.vector(other)) / 2)
    return one


def _distance(old: Device, new: Device, summed: Design) -> float:
    """How far apart two gyros are, in deviations of the noise."""
    unit = np.zeros(len(summed.pull))
    for effect in (group for group in summed.places if isinstance(group, Effect)):
        where = summed.places[effect]
        unit[where] = (effect.vector(new) - effect.vector(old)) * summed.lengths[where]
    return float(np.sqrt(max(float(unit @ summed.gram @ unit), 0.0)))
