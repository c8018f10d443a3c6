"""Rows of inputs and outputs, as compiled loops take them."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array, Mask
from pyhrg.fmu.archive import Archive

CONTROL_PERIOD = 1e-3
"""Control period of the gyro's electronics, s."""
COMMANDS = frozenset({"virtualRotation", "amplitudeSetpoint", "phaseOffset", "driveOn"})
"""Inputs that the electronics take; all others act on the gyro itself, at once."""


class Layout(NamedTuple):
    """What rows hold.

    Attributes:
        step: communication step, s.
        tick: control period, s; 0 for a gyro without one.
        commands: number of held inputs that are `COMMANDS`; these come first.
        moving, held: value references of inputs that change within a row, and of those that are
            constant in it.
        ends, means: value references of outputs at the end of a row, and of those averaged over it.
    """

    step: float
    tick: float
    commands: int
    moving: NDArray[np.uint32]
    held: NDArray[np.uint32]
    ends: NDArray[np.uint32]
    means: NDArray[np.uint32]


class Rows(NamedTuple):
    """Inputs of one gyro, row by row, and its outputs, to be filled.

    Attributes:
        moving: (n, m, inputs) values in each of a row's m steps.
        held: (n + 1, inputs), the last row repeated.
        is_new: (n,) whether a row's held values differ from those of the row before.
        ends, means: (n, outputs). All SI.
    """

    moving: Array
    held: Array
    is_new: Mask
    ends: Array
    means: Array

    def take(self, part: slice) -> "Rows":
        held = self.held[part.start : part.stop + 1]
        return Rows(self.moving[part], held, self.is_new[part], self.ends[part], self.means[part])


def arrange_rows(
    archive: Archive,
    moving: Mapping[str, Array],
    held: Mapping[str, Array],
    step: float,
    ends: Sequence[str],
    means: Sequence[str],
) -> tuple[Layout, Rows]:
    """Layout and rows of what `Gyro.record` is given.

    Raises:
        GyroError: an unknown name.
    """
    moving_values = np.ascontiguousarray(np.stack(list(moving.values()), axis=-1))
    n = len(moving_values)
    names = sorted(held, key=lambda name: name not in COMMANDS)
    columns = [np.append(held[name], held[name][-1:]) for name in names]
    held_values = np.column_stack([*columns, np.empty((n + 1, 0))])
    is_new = np.append(True, (np.diff(held_values[:-1], axis=0) != 0).any(axis=1))
    layout = Layout(
        step,
        CONTROL_PERIOD if archive.is_sampled else 0.0,
        sum(name in COMMANDS for name in names),
        *(archive.find_references(each) for each in (moving, names, ends, means)),
    )
    at_end, averaged = (np.zeros((n, len(each))) for each in (ends, means))
    return layout, Rows(moving_values, held_values, is_new, at_end, averaged)
