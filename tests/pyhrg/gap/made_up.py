"""Designs of made-up columns, white noise of one; a gyro for which no angle matters."""

from collections.abc import Mapping

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.design import Block, Design
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.replay.angle_derivatives import AngleDerivatives
from pyhrg.gap.replay.observations import CHANNELS


def flat_derivatives(rows: int) -> AngleDerivatives:
    nothing = dict.fromkeys(CHANNELS, np.zeros(rows))
    return AngleDerivatives(nothing, nothing, np.ones(rows), np.zeros(rows))


def design_of(
    columns: Mapping[Group, Array], residual: Array, channel: str = "gyro_angle"
) -> Design:
    """One channel of one test.

    Args:
        columns: (n, size) of each group.
        residual: (n,) in deviations of the noise.
    """
    all_columns = np.column_stack(list(columns.values()))
    ends = np.cumsum([block.shape[1] for block in columns.values()])
    places = {
        group: np.arange(end - block.shape[1], end)
        for (group, block), end in zip(columns.items(), ends, strict=True)
    }
    lengths = np.linalg.norm(all_columns, axis=0)
    unit = all_columns / lengths
    both = np.column_stack([all_columns, residual])
    columns = np.arange(both.shape[1] - 1)
    block = Block("test", channel, columns, both.T @ both, len(residual), 0.0)
    return Design(
        unit.T @ unit, unit.T @ residual, float(residual @ residual), places, lengths, (block,)
    )
