"""A step of the search: from one gyro to the next, and how far that is."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design
from pyhrg.gap.effects.linear_test import Group, LinearTest
from pyhrg.gap.evidence.form_error import NEGLIGIBLE_CHI2
from pyhrg.gap.evidence.hypothesis import Hypothesis, estimate_nominal_noise
from pyhrg.gap.evidence.residuals import compute_residuals
from pyhrg.gap.replay.observations import CHANNELS

LINEARIZATION_ERROR = 1e-3
"""Share of a step's power that may remain in the residual because effects are not linear (Eq.
(10)). The step is at most the gap that is left, and taken for no longer than the last one.
Chosen."""
LINEAR_DISTANCE = math.sqrt(NEGLIGIBLE_CHI2 / LINEARIZATION_ERROR)
"""Mahalanobis length of a step with a negligible linearization error, 32 sigma. Farther from where
sensitivities were taken they are taken again. Derived."""
CURVED_CHANNELS = tuple(channel for channel in CHANNELS if channel != "frequency_offset")
"""Channels whose power counts there. The frequency is nearly linear in all that shifts it, and
known so well that a stated one a little off has more power than all else."""


def move_gyro(nominal: Device, device: Device, hypothesis: Hypothesis) -> Device:
    """The nominal gyro with the parameters of the most probable set. One whose power is below the
    linearization error of this step (Eq. (10)) is left out."""
    design = hypothesis.exact.whole
    target = hypothesis.put_effects(nominal)
    error = LINEARIZATION_ERROR * measure_curved_power(device, target, design)
    moved = nominal
    for effect, size in hypothesis.effect_sizes.items():
        vector = effect.vector(nominal) + size
        if measure_step(nominal, effect.put(nominal, vector), design) ** 2 > error:
            moved = effect.put(moved, vector)
    return moved


def measure_gap(parts: Sequence[LinearTest]) -> float:
    """Chi-square of the records less the simulation of the present gyro, beyond their noise, in
    the channels that are not linear."""
    nominal, device = parts[0].nominal, parts[0].device
    moved: dict[Group, Array] = {
        effect: effect.vector(device) - effect.vector(nominal) for effect in parts[0].sensitivities
    }
    residuals = compute_residuals(parts, moved, estimate_nominal_noise(parts), CURVED_CHANNELS)
    return sum(max(float(r.white @ r.white) - len(r.white), 0.0) for r in residuals)


def go_halfway(old: Device, new: Device, effects: Sequence[Effect]) -> Device:
    """A gyro half way between two."""
    device = old
    for effect in effects:
        device = effect.put(device, (effect.vector(device) + effect.vector(new)) / 2)
    return device


def measure_step(old: Device, new: Device, summed: Design) -> float:
    """Mahalanobis distance between two gyros (Eq. (11))."""
    where, change = _subtract(old, new, summed)
    unit = change * summed.norms[where]
    return float(np.sqrt(max(float(unit @ summed.gram[np.ix_(where, where)] @ unit), 0.0)))


def measure_curved_power(old: Device, new: Device, summed: Design) -> float:
    """Square of the Mahalanobis distance in the channels that are not linear."""
    where, change = _subtract(old, new, summed)
    size, power = np.zeros(len(summed.norms)), 0.0
    size[where] = change
    for block in (block for block in summed.blocks if block.channel in CURVED_CHANNELS):
        own = size[block.columns]
        power += float(own @ block.gram[:-1, :-1] @ own) / (1 + block.model_error)
    return max(power, 0.0)


def _subtract(old: Device, new: Device, summed: Design) -> tuple[NDArray[np.int64], Array]:
    """(p,) columns of a design's effects, and (p,) change of their vectors between two gyros."""
    effects = [group for group in summed.columns if isinstance(group, Effect)]
    change = np.concatenate([effect.vector(new) - effect.vector(old) for effect in effects])
    return summed.list_columns(effects), change
