"""Smooth functions of time of which manoeuvres consist."""

import math
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np


class Signal(Protocol):
    """A function of time with two continuous derivatives between its breaks and across them."""

    @property
    def breaks(self) -> tuple[float, ...]:
        """Times at which a higher derivative is not continuous, s."""

    @property
    def scale(self) -> float:
        """Shortest time within which the signal changes, s."""

    def __call__(self, time: Any) -> Any:
        """Return the value at a time or at times (n,), s."""


def smooth_step(s: Any) -> Any:
    """Return the polynomial step from 0 at s <= 0 to 1 at s >= 1 whose first and second derivatives
    are 0 at both ends."""
    s = np.minimum(np.maximum(s, 0.0), 1.0)
    return s * s * s * (10 + s * (6 * s - 15))


@dataclass(frozen=True)
class Step:
    """A smooth change: from `start`, s, within `length`, s, by `change`."""

    start: float
    length: float
    change: float


@dataclass(frozen=True)
class Steps:
    """A value that changes in smooth steps."""

    initial: float
    steps: tuple[Step, ...] = ()

    @property
    def breaks(self) -> tuple[float, ...]:
        return tuple(time for s in self.steps for time in (s.start, s.start + s.length))

    @property
    def scale(self) -> float:
        return min((s.length for s in self.steps), default=math.inf)

    def __call__(self, time: Any) -> Any:
        changes = (s.change * smooth_step((time - s.start) / s.length) for s in self.steps)
        return sum(changes, self.initial + 0.0 * time)


@dataclass(frozen=True)
class Sine:
    """amplitude * sin(frequency * time + phase): rad/s, rad."""

    amplitude: float
    frequency: float
    phase: float = 0.0
    breaks: tuple[float, ...] = ()

    @property
    def scale(self) -> float:
        return math.pi / self.frequency

    def __call__(self, time: Any) -> Any:
        return self.amplitude * np.sin(self.frequency * time + self.phase)


@dataclass(frozen=True)
class Product:
    """An envelope times a sum of sines."""

    envelope: Steps
    parts: tuple[Sine, ...]

    @property
    def breaks(self) -> tuple[float, ...]:
        return self.envelope.breaks

    @property
    def scale(self) -> float:
        return min(self.envelope.scale, *(part.scale for part in self.parts))

    def __call__(self, time: Any) -> Any:
        return self.envelope(time) * sum(part(time) for part in self.parts)


def step_to(initial: float, final: float, length: float) -> Steps:
    """Return one smooth change from a value to another."""
    return Steps(initial, (Step(0.0, length, final - initial),))


def lobe(height: float, ramp: float, hold: float, start: float = 0.0) -> tuple[Step, Step]:
    """Return the steps from 0 to `height` within `ramp`, s, and back after `hold`, s.

    The area is height (ramp + hold).
    """
    return Step(start, ramp, height), Step(start + ramp + hold, ramp, -height)
