"""Which effects make the gap: a Gauss-Newton iteration whose every step is a search among sets.

Effects enter through the FMU. A search is linear in them (docs/methods/evidence.md, Eq. (1)). The
effects of the most probable set are put into the gyro, the gyro is simulated again, and the search
is repeated around it until it moves no more. Sizes always count from the nominal gyro.
"""

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import replace

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.effects.linear_test import Group, LinearTest
from pyhrg.gap.effects.sensitivities import linearize_tests
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.form_error import list_large_terms, rank_anew, rank_with_forms
from pyhrg.gap.evidence.hypothesis import Hypothesis, rank_roughly
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_levels import are_equal
from pyhrg.gap.evidence.posterior import Posterior, average_posteriors, compare_noises
from pyhrg.gap.evidence.residual_features import compute_checked_residuals, find_period
from pyhrg.gap.evidence.rounds.step import (
    LINEAR_DISTANCE,
    LINEARIZATION_ERROR,
    go_halfway,
    measure_curved_power,
    measure_gap,
    measure_step,
    move_gyro,
)
from pyhrg.gap.evidence.rounds.turns import ERROR_DECAY, Turns
from pyhrg.gap.evidence.unexplained import count_unexplained, measure_unexplained
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.simulation import ChannelValues, Simulation
from pyhrg.gap.whitening.channel_noise import build_angle_noise

CONVERGENCE_DISTANCE = 0.1 / math.sqrt(LINEARIZATION_ERROR)
"""The search has converged when a step moves the gyro by less than this Mahalanobis distance
(Eq. (11)), 3.2. Derived: the linearization error of such a step moves the estimate by a tenth of
its standard deviation."""
MAX_HALVINGS = 8
"""Number of times that a step to a gyro which the FMU refuses is halved. Chosen."""
MAX_ROUNDS = 20
"""Number of iterations after which the search ends unconverged. Chosen."""
PHASE_TOLERANCE = 0.01
"""Cycles by which a line may be wrong at the end of the longest test. Chosen."""
MAX_PERIODS = 3
"""Number of times that the period is taken anew: from what is left beside other effects. Chosen."""
MAX_COUNTS = 10
"""Number of searches in a round beside what was left unexplained. Chosen: one to three were
seen."""
UNSETTLED_ROUNDS = 4
"""Number of last rounds whose posteriors are averaged then. Chosen: more than the sets between
which searches were seen to alternate."""


def attribute_gap(
    simulation: Simulation,
    nominal: Device,
    tests: Sequence[ObservedTest],
    catalogue: Catalogue,
    report: Callable[[str], None] = lambda text: None,
) -> Attribution:
    """Find the effects and noises of the catalogue that make the gap in tests that may be fitted
    to. `report` is called with a line of text at each step."""
    iteration = _Iteration(simulation, nominal, tests, catalogue)
    posteriors = deque[Posterior](maxlen=UNSETTLED_ROUNDS)
    for number in range(1, MAX_ROUNDS + 1):
        report(f"round {number}: simulating")
        iteration.simulate()
        report(f"round {number}: searching")
        hypothesis = iteration.search()
        length = iteration.step_length(hypothesis)
        report(f"round {number}: step of {length:.3g} sigma")
        has_converged = iteration.has_converged(hypothesis)
        iteration.noise = hypothesis.noise
        posteriors.append(iteration.posterior)
        if has_converged or number == MAX_ROUNDS:
            break
        iteration.move(hypothesis)
    return Attribution(
        nominal,
        iteration.device,
        posteriors[-1] if has_converged else average_posteriors(posteriors),
        tuple(iteration.parts),
        iteration.nominal_answers,
        has_converged,
    )


class _Iteration:
    """State of the iteration from the nominal gyro to the one that explains the records.

    The sensitivities are linear. The part of a large effect that they miss must be read neither as
    noise nor as another effect: it is added to the noise (Eq. (10)). Noise, jumps and steps are
    looked for once the steps are short. Then what no set explains is noted in the tests (Eq. (10d))
    and sets are ranked again.

    _is_far: whether sensitivities are due.
    _differentiated_at: gyro at which they were taken last.
    _linearization_error: allowed linearization error, as chi-square.
    _sets: best sets of the rounds whose steps are not linear yet.
    _compared_groups: set of effects for which the noises were compared last.
    _last_exact: last hypothesis without linearization error; the next search starts from it.
    """

    def __init__(
        self,
        simulation: Simulation,
        nominal: Device,
        tests: Sequence[ObservedTest],
        catalogue: Catalogue,
    ) -> None:
        self._simulation, self._nominal = simulation, nominal
        self._tests, self._catalogue = tests, catalogue
        self._is_far = True
        self._differentiated_at = nominal
        self._linearization_error = math.inf
        self._sets = Turns()
        self._compared_groups: tuple[Group, ...] | None = None
        self._last_exact: Hypothesis | None = None
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
                self.device = go_halfway(
                    self.parts[0].device, self.device, self._catalogue.parameters
                )
        self.device = self.parts[0].device

    def _simulate(self) -> None:
        if self.parts and self.parts[0].device is self.device and not self._is_far:
            return
        where = self._simulation, self._nominal, self.device, self._tests
        if self._is_far:
            self.parts = linearize_tests(*where, self._catalogue.parameters)
            self._differentiated_at = self.device
        else:
            self.parts = linearize_tests(*where, last=self.parts)
        self.nominal_answers = self.nominal_answers or tuple(p.simulated for p in self.parts)

    def search(self) -> Hypothesis:
        """The most probable hypothesis, beside which no more is left unexplained than counted."""
        self._search()
        for _ in range(MAX_COUNTS):
            if self._linearization_error or not self._count_unexplained():
                break
            self._search()
        return self.posterior.best

    def _search(self) -> None:
        """Rank sets and noises; noises are compared again where the best set changed."""
        if self._linearization_error:
            power = LINEARIZATION_ERROR * measure_gap(self.parts)
            self._linearization_error = min(self._linearization_error, power)
        hypothesis = self._rank()
        length = self.step_length(hypothesis)
        if self._linearization_error and length < LINEAR_DISTANCE:
            self._linearization_error = 0.0
            hypothesis = self._rank()
        elif self._linearization_error:
            moved, design = self._move_gyro(hypothesis), hypothesis.exact.whole
            missed = LINEARIZATION_ERROR * measure_curved_power(self.device, moved, design)
            if self._sets.take(hypothesis.ranking.best.groups, length):
                missed = min(missed, self._linearization_error / ERROR_DECAY)
            self._linearization_error = missed
        best = hypothesis.ranking.best
        # the response of large terms is curved
        if self._linearization_error or list_large_terms(best, hypothesis):
            self.posterior = Posterior((hypothesis,), (1.0,))
            self._compared_groups = None
        elif best.groups == self._compared_groups:
            others = self.posterior.hypotheses[1:]
            self.posterior = replace(self.posterior, hypotheses=(hypothesis, *others))
        else:
            self.posterior = compare_noises(hypothesis, self.parts, self._catalogue.noises)
            is_near = self.step_length(hypothesis) < LINEAR_DISTANCE
            self._compared_groups = self.posterior.best.ranking.best.groups if is_near else None

    def _count_unexplained(self) -> bool:
        """Let what the most probable hypothesis leaves of the residual count against all of them;
        whether it is more than before."""
        best = self.posterior.best
        residuals = compute_checked_residuals(best, best.sizes, self.parts)
        tests = count_unexplained(self._tests, measure_unexplained(residuals))
        if tests is None:
            return False
        self._observe(tests)
        self._last_exact = self._compared_groups = None
        return True

    def _rank(self) -> Hypothesis:
        """Sets under the present noise, at last beside the forms that terms may have."""
        error = self._linearization_error
        if error:
            return rank_roughly(self.noise, self.parts, error)
        noises, last = self._catalogue.noises, self._last_exact
        if last:
            hypothesis = rank_with_forms(self.noise, self.parts, last)
        else:
            hypothesis = rank_anew(self.noise, self.parts, noises)
        for _ in range(MAX_PERIODS):
            if not self._take_period(hypothesis):
                break
            hypothesis = rank_anew(self.noise, self.parts, noises)
        self._last_exact = hypothesis
        return hypothesis

    def _take_period(self, hypothesis: Hypothesis) -> bool:
        """Let terms have the period of the line that the residual shows without the effects of a
        hypothesis; whether it is a new one."""
        effects = dict[Group, Array](hypothesis.effect_sizes.items())
        period = find_period(compute_checked_residuals(hypothesis, effects, self.parts))
        known = self._tests[0].line_period
        if period is None:
            return False
        longest = max(test.log.time[-1] for test in self._tests)
        if known and abs(period / known - 1) * longest < PHASE_TOLERANCE * known:
            return False
        # the period stands in the term's words: rounded where the line does not feel it
        decimals = -math.floor(math.log10(PHASE_TOLERANCE / 10 * period**2 / longest))
        period = round(period, max(decimals, 0))
        self._observe([replace(test, line_period=period) for test in self._tests])
        return True

    def _observe(self, tests: Sequence[ObservedTest]) -> None:
        self._tests = tests
        self.parts = [part.observe(test) for part, test in zip(self.parts, tests, strict=True)]

    def step_length(self, hypothesis: Hypothesis) -> float:
        """Mahalanobis distance (Eq. (11)) by which a hypothesis moves the gyro."""
        return measure_step(self.device, self._move_gyro(hypothesis), hypothesis.exact.whole)

    def _move_gyro(self, hypothesis: Hypothesis) -> Device:
        return move_gyro(self._nominal, self.device, hypothesis)

    def has_converged(self, hypothesis: Hypothesis) -> bool:
        """Whether it moves neither gyro nor noise, and sensitivities were taken nearby."""
        is_noise_kept = are_equal(self.noise.noise, hypothesis.noise.noise)
        is_near = self._has_near_sensitivities(hypothesis)
        return is_noise_kept and is_near and self.step_length(hypothesis) < CONVERGENCE_DISTANCE

    def move(self, hypothesis: Hypothesis) -> None:
        """Move the gyro to where the hypothesis has it. Far from where sensitivities were taken
        last, they are taken again."""
        self.device = self._move_gyro(hypothesis)
        self._is_far = not self._has_near_sensitivities(hypothesis)

    def _has_near_sensitivities(self, hypothesis: Hypothesis) -> bool:
        distance = measure_step(self._differentiated_at, self.device, hypothesis.exact.whole)
        return distance < LINEAR_DISTANCE
