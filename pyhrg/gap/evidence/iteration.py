"""The Gauss-Newton iteration from the nominal gyro to the one that explains the records."""

import math
from collections.abc import Collection, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import Catalogue, Effect
from pyhrg.gap.effects.design import Design, Group, LinearTest, compute_excess_power
from pyhrg.gap.effects.sensitivities import compute_sensitivities, linearize_test
from pyhrg.gap.evidence.hypothesis import Hypothesis, estimate_nominal_noise, rank_under_noise
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_levels import are_equal
from pyhrg.gap.evidence.posterior import Posterior, compare_noises
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.simulation import ChannelValues, Simulation, add_channels
from pyhrg.gap.whitening.channel_noise import build_angle_noise

Array = NDArray[np.float64]

CONVERGENCE_DISTANCE = 0.1
"""The search has converged when a step moves the gyro by less than this Mahalanobis distance
(Eq. (11)). Chosen: a tenth of the standard deviation of the estimate."""
SENSITIVITY_DISTANCE = 300.0
"""Mahalanobis distance from where all sensitivities were taken beyond which they are taken again.
Chosen."""
RESIMULATION_DISTANCE = 10.0
"""Mahalanobis distance from the last full simulation (loops in transient) beyond which it is run
again. Chosen."""
MAX_HALVINGS = 8
"""Number of times that a step to a gyro which the FMU refuses is halved. Chosen."""
LINEARIZATION_ERROR = 1e-3
"""Share of a step's power that may remain in the residual because effects are not linear (Eq.
(10)). The first time the step is the whole gap, later the last one. Chosen."""
LINEARIZATION_DECAY = 4.0
"""Factor by which the allowed linearization error falls from round to round at least, so that all
records separate, in the end, sets which explain the residual in turn. Chosen."""
NEGLIGIBLE_CHI2 = 1.0
"""Linearization error, as chi-square, below which it counts as zero: the power of one row's noise.
Chosen."""
LINEAR_DISTANCE = math.sqrt(NEGLIGIBLE_CHI2 / LINEARIZATION_ERROR)
"""Mahalanobis length of a step up to which the linearization error is negligible: 32 sigma.
Derived."""


class Iteration:
    """State of the iteration from the nominal gyro to the one that explains the records.

    The sensitivities are linear. The part of a large effect that they miss must be read neither as
    noise nor as another effect: it is added to the noise (Eq. (10)). Noise, jumps and steps are
    looked for once the steps are short.

    _to_differentiate: effects whose sensitivities are due.
    _differentiated_at: gyro at which all sensitivities were taken last.
    _simulated_at: gyro of the last full simulation; None where one is due.
    _linearization_error: allowed linearization error, as chi-square.
    _error_limit: upper limit of the next one.
    _compared_groups: set of effects for which the noises were compared last.
    """

    def __init__(
        self,
        simulation: Simulation,
        nominal: Device,
        tests: Sequence[ObservedTest],
        catalogue: Catalogue,
    ) -> None:
        self._simulation = simulation
        self._nominal = nominal
        self._tests = tests
        self._catalogue = catalogue
        self._to_differentiate: Collection[Effect] = catalogue.parameters
        self._differentiated_at = nominal
        self._simulated_at: Device | None = None
        self._linearization_error = self._error_limit = math.inf
        self._compared_groups: tuple[Group, ...] | None = None
        self.device = nominal
        self.noise = NoiseHypothesis(build_angle_noise(nominal), ())
        self.parts: list[LinearTest] = []
        self.posterior = Posterior((), ())
        self.nominal_answers: tuple[ChannelValues, ...] = ()

    def simulate(self) -> None:
        """Take the residuals around the gyro, and the sensitivities that are due.

        Where the FMU refuses the gyro, the step to it is halved, again and again. Where it refuses
        all of these, the gyro stays where it was.
        """
        for _ in range(MAX_HALVINGS):
            try:
                self._simulate()
                return
            except GyroError:
                if not self.parts:
                    raise
                self.device = _midway(self.parts[0].device, self.device, self._catalogue.parameters)
        self.device = self.parts[0].device

    def _simulate(self) -> None:
        if self.parts and self.parts[0].device is self.device and not self._to_differentiate:
            return
        answers = self._simulated_channels()
        self.parts = [
            linearize_test(
                self._simulation,
                self._nominal,
                self.device,
                test,
                answers[i],
                self._sensitivities(i),
            )
            for i, test in enumerate(self._tests)
        ]
        self._simulated_at = self._simulated_at or self.device
        self.nominal_answers = self.nominal_answers or tuple(answers)

    def _simulated_channels(self) -> list[ChannelValues]:
        """Simulation of the gyro in each test: in full, or the last full one with the difference
        between the two gyros, which is simulated with loops at rest."""
        simulation, device = self._simulation, self.device
        if self._simulated_at is None:
            return [simulation.simulate(device, test) for test in self._tests]
        return [
            add_channels(
                part.simulated, simulation.compute_difference(part.device, device, part.test)
            )
            for part in self.parts
        ]

    def _sensitivities(self, index: int) -> dict[Effect, Mapping[str, Array]]:
        test, device = self._tests[index], self.device
        kept = self.parts[index].sensitivities if self.parts else {}
        return {
            **kept,
            **compute_sensitivities(self._simulation, device, test, self._to_differentiate),
        }

    def search(self) -> Hypothesis:
        """The most probable hypothesis; noises are compared again where the best set changed."""
        if self._linearization_error == math.inf:
            noise = estimate_nominal_noise(self._nominal, self.parts)
            self._allow_linearization_error(
                LINEARIZATION_ERROR * sum(compute_excess_power(self.parts, noise).values())
            )
        hypothesis = rank_under_noise(
            self.noise, self._nominal, self.parts, self._linearization_error
        )
        if self._linearization_error and self.step_length(hypothesis) < LINEAR_DISTANCE:
            hypothesis = rank_under_noise(self.noise, self._nominal, self.parts)
        is_close = not self._linearization_error or self.step_length(hypothesis) < LINEAR_DISTANCE
        self._allow_linearization_error(
            0.0 if is_close else LINEARIZATION_ERROR * self.step_length(hypothesis) ** 2
        )
        if not is_close:
            self.posterior = Posterior((hypothesis,), (1.0,))
        elif hypothesis.ranking.best.groups == self._compared_groups:
            self.posterior = self.posterior.with_best(hypothesis)
        else:
            self.posterior = compare_noises(
                hypothesis, self._nominal, self.parts, self._catalogue.noises
            )
            is_near = self.step_length(hypothesis) < LINEAR_DISTANCE
            self._compared_groups = self.posterior.best.ranking.best.groups if is_near else None
        return self.posterior.best

    def _allow_linearization_error(self, chi2: float) -> None:
        """Allow this linearization error, at most the limit, and lower the limit."""
        error = min(chi2, self._error_limit)
        self._linearization_error = error if error > NEGLIGIBLE_CHI2 else 0.0
        self._error_limit = error / LINEARIZATION_DECAY

    def step_length(self, hypothesis: Hypothesis) -> float:
        """Mahalanobis distance (Eq. (11)) by which a hypothesis moves the gyro."""
        moved = _moved(self._nominal, self.device, hypothesis)
        return _distance(self.device, moved, hypothesis.known.whole)

    def has_converged(self, hypothesis: Hypothesis) -> bool:
        """Whether it moves neither gyro nor noise, and the sensitivities were taken nearby."""
        is_noise_kept = are_equal(self.noise.noise, hypothesis.noise.noise)
        is_near = self._has_near_sensitivities(hypothesis)
        return is_noise_kept and is_near and self.step_length(hypothesis) < CONVERGENCE_DISTANCE

    def move(self, hypothesis: Hypothesis) -> None:
        """Move the gyro to where the hypothesis has it."""
        moved = _moved(self._nominal, self.device, hypothesis)
        named = list(hypothesis.ranking.best.named)
        self._to_differentiate = [] if self._has_near_sensitivities(hypothesis) else named
        from_sensitivities = _distance(self._differentiated_at, moved, hypothesis.known.whole)
        is_step_short = self.step_length(hypothesis) < LINEAR_DISTANCE
        if from_sensitivities >= SENSITIVITY_DISTANCE and is_step_short:
            self._differentiated_at, self._to_differentiate = moved, self._catalogue.parameters
        if (
            self._simulated_at
            and _distance(self._simulated_at, moved, hypothesis.known.whole)
            >= RESIMULATION_DISTANCE
        ):
            self._simulated_at = None
        self.device = moved

    def _has_near_sensitivities(self, hypothesis: Hypothesis) -> bool:
        return (
            _distance(self._differentiated_at, self.device, hypothesis.known.whole)
            < SENSITIVITY_DISTANCE
        )


def _moved(nominal: Device, device: Device, hypothesis: Hypothesis) -> Device:
    """The nominal gyro with the named effects of the most probable set. An effect whose power is
    below the linearization error of this step (Eq. (10)) is left out."""
    summed = hypothesis.known.whole
    sizes = hypothesis.effect_sizes.items()
    named = [(effect, effect.vector(nominal) + size) for effect, size in sizes]
    aim = nominal
    for effect, vector in named:
        aim = effect.put(aim, vector)
    error = LINEARIZATION_ERROR * _distance(device, aim, summed) ** 2
    moved = nominal
    for effect, vector in named:
        if _distance(nominal, effect.put(nominal, vector), summed) ** 2 > error:
            moved = effect.put(moved, vector)
    return moved


def _midway(old: Device, new: Device, effects: Sequence[Effect]) -> Device:
    """A gyro half way between two."""
    device = old
    for effect in effects:
        device = effect.put(device, (effect.vector(device) + effect.vector(new)) / 2)
    return device


def _distance(old: Device, new: Device, summed: Design) -> float:
    """Mahalanobis distance between two gyros (Eq. (11))."""
    unit = np.zeros(len(summed.projection))
    for effect in (group for group in summed.columns if isinstance(group, Effect)):
        where = summed.columns[effect]
        unit[where] = (effect.vector(new) - effect.vector(old)) * summed.norms[where]
    return float(np.sqrt(max(float(unit @ summed.gram @ unit), 0.0)))
