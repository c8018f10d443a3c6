"""One gyro that is switched on."""

from collections.abc import Callable, Mapping, Sequence

from pyhrg.common.arrays import Array
from pyhrg.fmu.archive import GyroError
from pyhrg.fmu.instance import Instance
from pyhrg.fmu.loops import record
from pyhrg.fmu.rows import Layout, Rows, arrange_rows

CHUNK = 20_000
"""Number of communication steps after which a drive looks whether it was stopped. Chosen: a second
or two of computing at steps of 10 ms."""


class Gyro:
    """One gyro that is switched on; a context manager that switches it off.

    Attributes:
        time: time since power-on, s.
        instance: instance of the FMU.
    """

    def __init__(
        self,
        instance: Instance,
        give_back: Callable[[Instance], None],
        is_stopped: Callable[[], bool],
    ) -> None:
        """Take over an instance that is set up and given back when it was reset; `is_stopped` says
        whether drives under way are to end with `GyroError`."""
        self.instance = instance
        self._give_back = give_back
        self._is_stopped = is_stopped
        self.time = 0.0

    def __enter__(self) -> "Gyro":
        return self

    def __exit__(self, kind: object, *error: object) -> None:
        if kind is not None:
            self.instance.slave.freeInstance()
            return
        self.instance.reset()
        self._give_back(self.instance)

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
        layout, rows = arrange_rows(self.instance.archive, moving, held, step, ends, means)
        self.fill(layout, rows)
        return rows.ends, rows.means

    def fill(self, layout: Layout, rows: Rows) -> None:
        """Record rows that are arranged already; see `record`."""
        component, functions = self.instance.slave.component, self.instance.functions
        n, steps = rows.moving.shape[:2]
        part_length = max(1, CHUNK // steps)
        for first in range(0, n, part_length):
            self.check_stop()
            part = slice(first, min(first + part_length, n))
            begin = self.time + first * steps * layout.step
            done = record(functions, component, begin, *layout, *rows.take(part))
            if done != part.stop - part.start:
                raise GyroError(self.instance.explain(f"row {first + done} of {n} failed"))
        self.time += layout.step * steps * n

    def read(self, name: str) -> float:
        """Present value of a variable, SI."""
        return float(self.instance.slave.getReal([self.instance.archive.references[name]])[0])

    def command(self, name: str, value: float) -> None:
        """Set an input, SI.

        Raises:
            GyroError: an unknown name, or a value that the FMU refuses.
        """
        self.instance.set_values({name: value})

    def check_stop(self) -> None:
        """Raise `GyroError` if drives under way are to end."""
        if self._is_stopped():
            raise GyroError("the drive was stopped")
