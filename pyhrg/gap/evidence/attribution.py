"""What a search among effects and noises found: the gyro, the hypotheses and their linear model."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import NoiseEffect
from pyhrg.gap.effects.design import Design
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.effects.sensitivities import linearize_test
from pyhrg.gap.evidence.hypothesis import Hypothesis, suppose_nothing
from pyhrg.gap.evidence.noise.noise_hypothesis import AddedNoise, NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_search import find_noise_equivalents
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.evidence.residuals import compute_residuals
from pyhrg.gap.evidence.search import Ranking
from pyhrg.gap.replay.simulation import ChannelValues, Simulation
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.gap.whitening.channel_noise import build_angle_noise


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

    @property
    def leaves_excess(self) -> bool:
        """Whether no set explains the records (docs/methods/evidence.md, Eq. 10d)."""
        return any(part.test.unexplained for part in self.parts)


def complete_noises(
    attribution: Attribution, noises: Sequence[NoiseEffect], quantization: AddedNoise | None
) -> Attribution:
    """Each hypothesis' noise with the quantization of the output, and that of the most probable
    hypothesis also with the noises that are confounded with its own."""
    posterior, nominal = attribution.posterior, attribution.nominal

    def complete(hypothesis: Hypothesis) -> Hypothesis:
        noise = hypothesis.noise
        if hypothesis is posterior.best:
            parts, channels = attribution.parts, attribution.channel_noise
            own = compute_residuals(parts, hypothesis.sizes, channels, ("gyro_angle",))
            noise = find_noise_equivalents(noise, own, build_angle_noise(nominal), noises)
        if quantization:
            noise = replace(noise, added=(*noise.added, quantization))
        return replace(hypothesis, noise=noise)

    hypotheses = tuple(map(complete, posterior.hypotheses))
    return replace(attribution, posterior=replace(posterior, hypotheses=hypotheses))


def keep_nominal(simulation: Simulation, attribution: Attribution) -> Attribution:
    """What is left of a search whose gyro is further from the records than the nominal one: this
    one, with nothing named, as of a search that did not converge."""
    nominal = attribution.nominal
    pairs = zip(attribution.parts, attribution.nominal_answers, strict=True)
    parts = tuple(
        linearize_test(simulation, nominal, nominal, part.test, answers, part.sensitivities)
        for part, answers in pairs
    )
    posterior = Posterior((suppose_nothing(parts),), (1.0,))
    answers = attribution.nominal_answers
    return Attribution(nominal, nominal, posterior, parts, answers, settled=False)
