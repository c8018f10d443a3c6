"""The course of a test: motion, temperature and commands in each communication step."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyhrg.bench.bench import compute_step_middles, interpolate_rows
from pyhrg.bench.programme import HELD_INPUTS, Programme
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class Course:
    """A test of n rows of m communication steps each; SI. Arrays by step are (n, m), at the
    steps' middles."""

    interval: float
    """Length of a row, s."""
    step: float
    """Communication step, s."""
    table_rate: Array
    """(n + 1,) at the rows' bounds, linear between them."""
    case_temperature: Array
    """(n + 1,) at the rows' bounds, linear between them."""
    held: Mapping[str, Array]
    """(n,) commands and attitude that hold over a row, by their names in a programme."""

    def __len__(self) -> int:
        return len(self.table_rate) - 1

    @property
    def steps(self) -> int:
        """Communication steps in a row."""
        return round(self.interval / self.step)

    @cached_property
    def share(self) -> Array:
        """(m,) share of a row that is over at the middle of each step."""
        return compute_step_middles(self.steps)

    @cached_property
    def time(self) -> Array:
        """(n, m) time since power-on, s."""
        return (np.arange(len(self))[:, None] + self.share) * self.interval

    @cached_property
    def rate(self) -> Array:
        """(n, m) rate of the table, rad/s."""
        return interpolate_rows(self.table_rate, self.share)

    @cached_property
    def table_angle_at_ends(self) -> Array:
        """(n,) angle of the table at the rows' ends, rad."""
        means = (self.table_rate[1:] + self.table_rate[:-1]) / 2
        return np.asarray(np.cumsum(means) * self.interval)

    @cached_property
    def table_angle(self) -> Array:
        """(n, m) angle of the table, rad; 0 at the start."""
        begun = np.concatenate(([0.0], self.table_angle_at_ends[:-1]))[:, None]
        return begun + self.interval * self.share * interpolate_rows(
            self.table_rate, self.share / 2
        )

    @cached_property
    def temperature(self) -> Array:
        """(n, m) temperature of the case, K."""
        return interpolate_rows(self.case_temperature, self.share)

    def each(self, name: str) -> Array:
        """(n, 1) a command or attitude that holds over each row."""
        return np.broadcast_to(self.held[name][:, None], (len(self), self.steps))

    def integrate(self, rate: Array) -> Array:
        """Integral of a rate, from the start to the middle of each step."""
        total = np.cumsum(rate.ravel()) * self.step
        return np.asarray((total - rate.ravel() * self.step / 2).reshape(rate.shape))


def make_course(programme: Programme, step: float) -> Course:
    """The course of a programme, whose rows are multiples of the step."""
    held = {name: programme.values(name) for name in ("axis_up", *HELD_INPUTS)}
    return Course(programme.interval, step, programme.table_rate, programme.temperature, held)
