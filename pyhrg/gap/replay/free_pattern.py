"""A pattern that nothing holds: its own motion makes more of any noise that turns it."""

from dataclasses import replace

import numpy as np

from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import Observed
from pyhrg.gap.replay.simulation import Simulation

GROWN = 0.2
"""Share by which noise of the angle may have grown and still be compared."""
LEAST = 10
"""Rows that are simulated, compared or not."""


def steady(simulation: Simulation, believed: Device, test: Observed) -> Observed:
    """The test up to those rows of a free pattern in which what turned it before has grown or
    shrunk: with a split, a ring-down of minutes makes several times as much of it, and ends in a
    circle, whose pattern has no angle.

    Args:
        simulation: both fidelities.
        believed: whose split and anisotropy move a free pattern.
        test: observed.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    if test.log.drive_on.all():
        return test
    slope = simulation.over_angle(believed, test).slopes["gyro_angle"]
    grown = (test.log.drive_on <= 0) & (np.abs(believed.bryan_factor * slope) > GROWN)
    kept = ~np.logical_or.accumulate(grown)
    count = max(int(kept.sum()), LEAST)
    rows = {name: (there & kept)[:count] for name, there in test.rows.items()}
    return replace(test, inputs=test.inputs.first(count), rows=rows, moving=test.moving[:count])
