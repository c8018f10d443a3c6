"""Rows of a ring-down in which the free pattern's angle is still known."""

from dataclasses import replace

import numpy as np

from pyhrg.common.arrays import Mask
from pyhrg.device.device import Device
from pyhrg.gap.replay.angle_derivatives import AngleDerivatives
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log

NOISE_GROWTH_LIMIT = 0.2
"""Relative growth of an earlier turn of a free pattern above which its rows are not compared.
Chosen."""
MIN_ROWS = 10
"""Fewest rows of a test with a free pattern that are simulated, compared or not. Chosen."""


def find_known_rows(by_angle: AngleDerivatives, nominal: Device, log: Log) -> Mask:
    """(n,) rows up to the one in which a small turn of the free pattern has grown or shrunk too
    far."""
    growth = np.abs(nominal.bryan_factor * by_angle.slopes["gyro_angle"])
    has_grown = log.is_free & (growth > NOISE_GROWTH_LIMIT)
    return np.asarray(~np.logical_or.accumulate(has_grown))


def truncate_free_pattern(
    simulation: Simulation, nominal: Device, test: ObservedTest
) -> ObservedTest:
    """The test up to the row in which a small turn of the free pattern has grown or shrunk too far.

    With a frequency split, a ring-down of minutes multiplies such a turn. It can end in circular
    motion, whose pattern angle is undefined (docs/methods/replay.md, Eq. 7).
    """
    if not test.log.is_free.any():
        return test
    kept = find_known_rows(simulation.differentiate_by_angle(nominal, test), nominal, test.log)
    count = max(int(kept.sum()), MIN_ROWS)
    rows = {name: (compared & kept)[:count] for name, compared in test.rows.items()}
    inputs = test.inputs.section(slice(0, count), test.inputs.start_angle)
    return replace(test, inputs=inputs, rows=rows, transient=test.transient[:count])
