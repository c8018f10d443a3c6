"""Which effects make the gap: a Gauss-Newton iteration whose every step is a search among sets.

Effects enter through the FMU. A search is linear in them (docs/methods/evidence.md, Eq. (1)). The
effects of the most probable set are put into the gyro, the gyro is simulated again, and the search
is repeated around it until it moves no more. Sizes always count from the nominal gyro.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import FULL_CATALOGUE, Catalogue
from pyhrg.gap.effects.design import Design, LinearTest
from pyhrg.gap.evidence.hypothesis import Hypothesis
from pyhrg.gap.evidence.iteration import Iteration
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.evidence.search import Ranking
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.simulation import ChannelValues, Simulation
from pyhrg.gap.whitening.channel_noise import CampaignNoise

MAX_ROUNDS = 20
"""Number of iterations after which the search ends without convergence. Chosen."""


@dataclass(frozen=True)
class Attribution:
    """Result of the search.

    nominal: the gyro before the diagnosis.
    device: the gyro around which the last search was linear.
    posterior: hypotheses on noise and effects, in sizes that count from the nominal gyro.
    parts: linear model of each test around the device.
    nominal_answers: simulation of the nominal gyro in each test.
    settled: whether the search converged.
    """

    nominal: Device
    device: Device
    posterior: Posterior
    parts: tuple[LinearTest, ...]
    nominal_answers: tuple[ChannelValues, ...]
    settled: bool

    @property
    def ranking(self) -> Ranking:
        """Sets of effects under the most probable noise."""
        return self.posterior.best.ranking

    @property
    def noise(self) -> NoiseHypothesis:
        """Most probable noise of the output angle."""
        return self.posterior.best.noise

    @property
    def design(self) -> Design:
        """Normal equations around the device, under the most probable noise."""
        return self.posterior.best.design

    @property
    def channel_noise(self) -> CampaignNoise:
        """Noise of all channels, under the most probable hypothesis."""
        return self.posterior.best.channel_noise

    def replace_noises(self, change: Callable[[Hypothesis], NoiseHypothesis]) -> "Attribution":
        """A copy in which each hypothesis has the noise that `change` gives for it."""
        return replace(self, posterior=self.posterior.replace_noises(change))


def attribute_gap(
    simulation: Simulation,
    nominal: Device,
    tests: Sequence[ObservedTest],
    catalogue: Catalogue = FULL_CATALOGUE,
    report: Callable[[str], None] = lambda text: None,
) -> Attribution:
    """Find the effects that make a campaign's gap.

    Args:
        simulation: both fidelities.
        nominal: the gyro before the diagnosis.
        tests: tests that may be fitted to.
        catalogue: effects and noises that may be named.
        report: is called with a line of text at each step.

    Raises:
        GyroError: the FMU refuses the nominal gyro.
    """
    iteration = Iteration(simulation, nominal, tests, catalogue)
    for number in range(1, MAX_ROUNDS + 1):
        report(f"round {number}: simulating")
        iteration.simulate()
        report(f"round {number}: searching")
        hypothesis = iteration.search()
        report(f"round {number}: step of {iteration.step_length(hypothesis):.3g} sigma")
        has_converged = iteration.has_converged(hypothesis)
        iteration.noise = hypothesis.noise
        if has_converged or number == MAX_ROUNDS:
            break
        iteration.move(hypothesis)
    return Attribution(
        nominal,
        iteration.device,
        iteration.posterior,
        tuple(iteration.parts),
        iteration.nominal_answers,
        has_converged,
    )
