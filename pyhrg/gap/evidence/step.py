"""A step of the search: from one gyro to the next, and how far that is."""

from collections.abc import Mapping, Sequence

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Group, measure_power
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.evidence.hypothesis import Hypothesis, TermError

LINEARIZATION_ERROR = 1e-3
"""Share of a step's power that may remain in the residual because effects are not linear (Eq.
(10)). The first time the step is the whole gap, later the last one. Chosen."""


NEGLIGIBLE_CHI2 = 1.0
"""Linearization error, as chi-square, that counts as zero: the power of a row's noise. Chosen."""


def allow_term_error(
    hypothesis: Hypothesis, simulated: Mapping[CandidateTerm, Array] | None = None
) -> TermError:
    """Share of the power of the most probable set's candidate terms that may remain in the residual
    because terms are not linear. Of terms that were simulated in these sizes, the step from there
    counts; nothing is simulated if None. Jumps, values of each power-on and an encoder's errors are
    linear."""
    steps: dict[Group, Array] = {}
    for group, size in hypothesis.ranking.best.sizes.items():
        if isinstance(group, CandidateTerm) and is_curved(group):
            known = (simulated or {}).get(group) if is_simulated(group) else None
            steps[group] = size if known is None else size - known
    powers = measure_power(hypothesis.exact.whole, steps)
    errors = {where: LINEARIZATION_ERROR * power for where, power in powers.items()}
    return {where: error for where, error in errors.items() if error > NEGLIGIBLE_CHI2}


def is_curved(term: CandidateTerm) -> bool:
    """Whether the response of a term is linear only where it is small. That to an encoder's error
    is: the pattern is where the gyro reads it."""
    return not (isinstance(term, Jump) or term.is_of_each_power_on or term.is_encoder_error)


def is_simulated(term: CandidateTerm) -> bool:
    """Whether the gyro with its terms moves as such a term makes it. Terms of damping and stiffness
    change what it puts out, not its motion."""
    return term.channel in ("gyro_angle", "amplitude")


def move_gyro(nominal: Device, device: Device, hypothesis: Hypothesis) -> Device:
    """The nominal gyro with the parameters of the most probable set. One whose power is below the
    linearization error of this step (Eq. (10)) is left out."""
    design = hypothesis.exact.whole
    error = LINEARIZATION_ERROR * measure_step(device, hypothesis.put_effects(nominal), design) ** 2
    moved = nominal
    for effect, size in hypothesis.effect_sizes.items():
        vector = effect.vector(nominal) + size
        if measure_step(nominal, effect.put(nominal, vector), design) ** 2 > error:
            moved = effect.put(moved, vector)
    return moved


def go_halfway(old: Device, new: Device, effects: Sequence[Effect]) -> Device:
    """A gyro half way between two."""
    device = old
    for effect in effects:
        device = effect.put(device, (effect.vector(device) + effect.vector(new)) / 2)
    return device


def measure_step(old: Device, new: Device, summed: Design) -> float:
    """Mahalanobis distance between two gyros (Eq. (11))."""
    unit = np.zeros(len(summed.projection))
    for effect in (group for group in summed.columns if isinstance(group, Effect)):
        where = summed.columns[effect]
        unit[where] = (effect.vector(new) - effect.vector(old)) * summed.norms[where]
    return float(np.sqrt(max(float(unit @ summed.gram @ unit), 0.0)))
