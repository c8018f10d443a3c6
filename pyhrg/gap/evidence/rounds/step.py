"""A step of the search: from one gyro to the next, and how far that is."""

from collections.abc import Sequence

import numpy as np

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design
from pyhrg.gap.evidence.hypothesis import Hypothesis

LINEARIZATION_ERROR = 1e-3
"""Share of a step's power that may remain in the residual because effects are not linear (Eq.
(10)). The step is at most the gap that is left, and taken for no longer than the last one.
Chosen."""


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
    effects = [group for group in summed.columns if isinstance(group, Effect)]
    where = summed.list_columns(effects)
    change = np.concatenate([effect.vector(new) - effect.vector(old) for effect in effects])
    unit = change * summed.norms[where]
    return float(np.sqrt(max(float(unit @ summed.gram[np.ix_(where, where)] @ unit), 0.0)))
