"""One gyro that is switched on."""

from collections.abc import Callable, Mapping, Sequence
from types import TracebackType

import numpy as np
from numpy.typing import NDArray

from pyhrg.fmu.archive import GyroError
from pyhrg.fmu.instance import Instance

Array = NDArray[np.float64]

CONTROL_PERIOD = 1e-3
"""Control period of the gyro's electronics, s."""
COMMANDS = frozenset({"virtualRotation", "amplitudeSetpoint", "phaseOffset", "driveOn"})
"""Inputs that the electronics take; all others act on the gyro itself, at once."""
CHUNK = 20_000
"""Number of communication steps after which a drive looks whether it was stopped. Chosen: a second
or two of computing at steps of 10 ms."""


class Gyro:
    """One gyro that is switched on; a context manager that switches it off.

    Attributes:
        time: since power-on, s.
    """

    def __init__(
        self,
        instance: Instance,
        give_back: Callable[[Instance], None],
        is_stopped: Callable[[], bool],
    ) -> None:
        """Take over an instance that is set up and given back when it was reset; `is_stopped` says
        whether drives under way are to end with `GyroError`."""
        self._instance = instance
        self._give_back = give_back
        self._is_stopped = is_stopped
        self.time = 0.0

    def __enter__(self) -> "Gyro":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if error is not None:
            self._instance.slave.freeInstance()
            return
        self._instance.reset()
        self._give_back(self._instance)

    def advance(self, rate: float, duration: float) -> float:
        """Turn the case at a constant inertial rate about the input axis, rad/s, for a duration, s;
        returns the gyro's angle at the end, rad."""
        return float(self.drive(np.array([rate]), duration)[0])

    def drive(self, rates: Array, step: float) -> Array:
        """Turn the case at rates that each hold for one step.

        Args:
            rates: (n,) inertial rate about the input axis, rad/s.
            step: communication step, s.

        Returns:
            (n,) the gyro's angle at the end of each step, rad.

        Raises:
            GyroError: a step that the FMU refuses, or `GyroFmu.stop`.
        """
        rates = np.ascontiguousarray(rates, dtype=np.float64)
        angles = np.empty_like(rates)
        references = self._instance.archive.find_references(["angularRate", "gyroAngle"])
        component, loop = self._instance.slave.component, self._instance.loops.drive

        def run(part: slice) -> int:
            begin = self.time + part.start * step
            return loop(component, begin, step, references, rates[part], angles[part])

        self._run_in_parts(run, "step", len(rates), CHUNK)
        self.time += step * len(rates)
        return angles

    def record(
        self,
        moving: Mapping[str, Array],
        held: Mapping[str, Array],
        step: float,
        ends: Sequence[str] = (),
        means: Sequence[str] = (),
    ) -> tuple[Array, Array]:
        """Read outputs row by row, each row several communication steps.

        Args:
            moving: (n, m) values of inputs by name, SI, in each of a row's m steps.
            held: (n,) values of other inputs by name, SI, each constant in a row. `COMMANDS` hold
                from a row's first tick on: a sampled gyro's electronics get them a control period
                before.
            step: communication step, s.
            ends: outputs to be read at the end of each row.
            means: outputs to be averaged over each row. A commanded output of a sampled gyro
                is constant between ticks of 1 ms; a row's mean averages the ticks from its start.
                A row whose commands are new is stepped tick by tick; elsewhere the average
                takes an output to change evenly in a step of several ticks.

        Returns:
            (n, len(ends)) and (n, len(means)), SI.

        Raises:
            GyroError: an unknown name, a value that the FMU refuses, or `GyroFmu.stop`.
        """
        archive, component = self._instance.archive, self._instance.slave.component
        moving_values = np.ascontiguousarray(np.stack(list(moving.values()), axis=-1))
        rows, steps, _ = moving_values.shape
        names = sorted(held, key=lambda name: name not in COMMANDS)
        n_commands = sum(name in COMMANDS for name in names)
        held_values, is_new = _arrange_held([held[name] for name in names], rows)
        at_end, averaged = (np.zeros((rows, len(each))) for each in (ends, means))
        references = [archive.find_references(each) for each in (moving, names, ends, means)]
        tick = CONTROL_PERIOD if archive.is_sampled else 0.0

        def run(part: slice) -> int:
            begin = self.time + part.start * steps * step
            inputs = moving_values[part], held_values[part.start : part.stop + 1], is_new[part]
            place = component, begin, step, tick, n_commands
            loop = self._instance.loops.record
            return loop(*place, *references, *inputs, at_end[part], averaged[part])

        self._run_in_parts(run, "row", rows, max(1, CHUNK // steps))
        self.time += step * steps * rows
        return at_end, averaged

    def read(self, name: str) -> float:
        """Present value of a variable, SI."""
        return float(self._instance.slave.getReal([self._instance.archive.references[name]])[0])

    def command(self, name: str, value: float) -> None:
        """Set an input, SI.

        Raises:
            GyroError: an unknown name, or a value that the FMU refuses.
        """
        self._instance.set_value(name, value)

    def _run_in_parts(
        self, run: Callable[[slice], int], unit: str, count: int, part_length: int
    ) -> None:
        """Run a loop over `count` rows or steps; `run` returns how many of a part succeeded."""
        for first in range(0, count, part_length):
            if self._is_stopped():
                raise GyroError("the drive was stopped")
            part = slice(first, min(first + part_length, count))
            done = run(part)
            if done != part.stop - part.start:
                trouble = f"{unit} {first + done} of {count} failed"
                raise GyroError(self._instance.explain(trouble))


def _arrange_held(values: Sequence[Array], rows: int) -> tuple[Array, NDArray[np.bool_]]:
    """(n + 1, k) values of k held inputs, the last row repeated, and (n + 1,) whether a row's
    values differ from the row before."""
    columns = [np.append(column, column[-1:]) for column in values]
    table = np.column_stack([*columns, np.empty((rows + 1, 0))])
    return table, np.append(True, (np.diff(table, axis=0) != 0).any(axis=1))
