"""A change of bias, pattern angle or output angle at one moment of a test."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import Coordinates

Kind = Literal["bias", "pattern", "output"]
"""What changes: the bias from then on; the pattern angle at once; or the output angle alone, as
after lost counts, while the pattern stays."""


@dataclass(frozen=True)
class Jump(CandidateTerm):
    """Changes at given times in one or several tests (docs/methods/effects.md, Eq. 6).

    times: test and time since power-on, s, of each change.
    log_odds: logarithm of the prior odds that changes occur at these times.
    kind: what changes.
    """

    times: tuple[tuple[str, float], ...] = ()
    log_odds: float = 0.0
    kind: Kind = "bias"

    @property
    def is_curved(self) -> bool:
        """It is linear in its sizes."""
        return False

    def columns(self, where: Coordinates) -> Array:
        """(n, k) output angle of a test per unit of each of the k changes."""
        test = where.test
        is_here = np.array([float(test.test.id == name) for name, _ in self.times])
        respond = integrate_jump if self.kind == "bias" else evaluate_step
        return is_here * respond(test.log.time, np.array([t for _, t in self.times]))


def make_bias_jump(times: Sequence[tuple[str, float]], log_odds: float) -> Jump:
    """A jump of the bias with its description; arguments as in `Jump`."""
    words = f"bias: a jump {_describe_all(times)}"
    return Jump("gyro_angle", "time", words, None, tuple(times), log_odds)


def make_step(times: Sequence[tuple[str, float]], log_odds: float, kind: Kind) -> Jump:
    """A step of the pattern angle or of the output alone, with its description; arguments as in
    `Jump`."""
    what = "pattern" if kind == "pattern" else "output alone"
    words = f"{what}: a step {_describe_all(times)}"
    return Jump("gyro_angle", "time", words, None, tuple(times), log_odds, kind)


def _describe_all(times: Sequence[tuple[str, float]]) -> str:
    return "; ".join(f"at {time:.9g} s in {test}" for test, time in times)


def parse_times(words: str) -> list[tuple[str, float]]:
    """Test and time, s, of each change that the description of a jump or a step names."""
    each = (change.removeprefix("at ").partition(" s in ") for change in words.split("; "))
    return [(test, float(time)) for time, _, test in each]


def integrate_jump(rows: Array, times: Array) -> Array:
    """(n, k) output angle at (n,) times of rows, s, after unit jumps of the bias at (k,) times."""
    return np.asarray(np.maximum(rows[:, None] - times, 0.0))


def evaluate_step(rows: Array, times: Array) -> Array:
    """(n, k) output angle at (n,) times of rows, s, after unit steps of it at (k,) times, s; a row
    at the time of a step is after it."""
    return np.asarray((rows[:, None] >= times).astype(np.float64))
