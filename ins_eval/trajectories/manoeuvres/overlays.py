"""Overlays: motion that is added to the manoeuvres, such as sway at sea or hills of a road."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from ins_eval.trajectories.keys import Checked, quantity, whole
from ins_eval.trajectories.manoeuvres.manoeuvre import ZERO
from ins_eval.trajectories.manoeuvres.signals import Product, Signal, Sine, Step, Steps, lobe

PERIOD_SPREAD = 0.3
"""Half width of the range of a seaway's wave periods, relative to the mean period. Chosen."""


@dataclass(frozen=True)
class OverlayMotion:
    """Functions of mission time that are added to climb angle, attitude (rad) and height (m)."""

    climb_angle: Signal = ZERO
    roll: Signal = ZERO
    pitch: Signal = ZERO
    yaw: Signal = ZERO
    heave: Signal = ZERO

    @property
    def signals(self) -> tuple[Signal, ...]:
        return self.climb_angle, self.roll, self.pitch, self.yaw, self.heave


@dataclass(frozen=True, kw_only=True)
class Overlay(Checked, ABC):
    """Motion that begins at `start` and lasts for `duration`, or to the mission's end where that is
    None. It rises over `ramp`, and falls over `ramp` before it ends."""

    start: float = quantity("s", 0, 1e6, 0)
    duration: float | None = quantity("s", 1, 1e6, None)
    ramp: float = quantity("s", 1, 1e4, 60)

    @abstractmethod
    def motion(self) -> OverlayMotion:
        """Return the motion that the overlay adds."""

    def envelope(self) -> Steps:
        """Return the factor that rises from 0 to 1 and, if the overlay ends, falls back to 0."""
        if self.duration is None:
            return Steps(0.0, (Step(self.start, self.ramp, 1.0),))
        ramp = min(self.ramp, self.duration / 2)
        return Steps(0.0, lobe(1.0, ramp, self.duration - 2 * ramp, self.start))


@dataclass(frozen=True, kw_only=True)
class Sway(Overlay):
    """Roll, pitch, yaw and heave in a seaway.

    Without a seed each is one sine of the given amplitude and period, with phase `phase`. With a
    seed each is a sum of `waves` sines with random phases and with periods within 30 % of the given
    one; its rms is the same.
    """

    roll: float = quantity("deg", 0, 45, 0)
    roll_period: float = quantity("s", 0.5, 1000, 12)
    pitch: float = quantity("deg", 0, 45, 0)
    pitch_period: float = quantity("s", 0.5, 1000, 8)
    yaw: float = quantity("deg", 0, 45, 0)
    yaw_period: float = quantity("s", 0.5, 1000, 15)
    heave: float = quantity("m", 0, 20, 0)
    heave_period: float = quantity("s", 0.5, 1000, 9)
    phase: float = quantity("deg", -360, 360, 0)
    seed: int | None = whole(0, 2**63 - 1, None)
    waves: int = whole(1, 100, 7)

    def motion(self) -> OverlayMotion:
        random = None if self.seed is None else np.random.default_rng(self.seed)
        names = ("roll", "pitch", "yaw", "heave")
        return OverlayMotion(**{name: self._signal(name, random) for name in names})

    def _signal(self, name: str, random: np.random.Generator | None) -> Signal:
        amplitude, period = getattr(self, name), getattr(self, f"{name}_period")
        sines: tuple[Sine, ...] = (Sine(amplitude, 2 * math.pi / period, self.phase),)
        if random is not None:
            phases = random.uniform(0, 2 * math.pi, self.waves)
            periods = period * random.uniform(1 - PERIOD_SPREAD, 1 + PERIOD_SPREAD, self.waves)
            each = amplitude / math.sqrt(self.waves)
            sines = tuple(
                Sine(each, 2 * math.pi / float(T), float(phase))
                for T, phase in zip(periods, phases, strict=True)
            )
        return Product(self.envelope(), sines) if amplitude else ZERO


@dataclass(frozen=True, kw_only=True)
class Hills(Overlay):
    """The climb angle varies as a sine of time."""

    climb_angle: float = quantity("deg", 0, 30)
    period: float = quantity("s", 1, 1e5)

    def motion(self) -> OverlayMotion:
        sine = Sine(self.climb_angle, 2 * math.pi / self.period)
        return OverlayMotion(climb_angle=Product(self.envelope(), (sine,)))
