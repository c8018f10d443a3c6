"""The power of a step that linear equations may miss a part of."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.evidence.rounds.step import measure_curved_power, measure_step
from tests.pyhrg.gap.made_up import design_of

FREQUENCY, DECAY = EFFECTS["nominal_frequency"], EFFECTS["nominal_decay_time"]


def test_a_stated_frequency_that_is_off_makes_no_other_channel_uncertain() -> None:
    """Its power is that of the step, and of none in the other channels, whose model error counts as
    noise there."""
    generator = np.random.default_rng(2)
    columns = {effect: generator.standard_normal((400, 1)) for effect in (FREQUENCY, DECAY)}
    read, force = (
        design_of({**columns, FREQUENCY: size * columns[FREQUENCY]}, columns[DECAY][:, 0], channel)
        for channel, size in (("frequency_offset", 1e4), ("amplitude_force", 1e-9))
    )
    (own,) = force.blocks
    design = replace(read, blocks=(*read.blocks, replace(own, model_error=3.0)))
    old = Device()
    new = DECAY.put(FREQUENCY.put(old, FREQUENCY.vector(old) + 20), DECAY.vector(old) + 1)
    power = float(np.sum(columns[DECAY] ** 2))
    assert measure_curved_power(old, new, design) == pytest.approx(power / 4, rel=1e-6)
    assert measure_step(old, new, design) ** 2 > 1e8 * power
