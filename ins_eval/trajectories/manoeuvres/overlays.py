"""Motion that goes on beside the manoeuvres: the sea's sway, a road's hills."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from ins_eval.trajectories.keys import Checked, quantity, whole
from ins_eval.trajectories.manoeuvres.manoeuvre import ZERO
from ins_eval.trajectories.manoeuvres.signals import Product, Signal, Sine, Step, Steps, lobe

SPREAD = 0.3
"""Periods of a seaway's waves: within this share of the mean period."""


@dataclass(frozen=True)
class Motion:
    """Functions of mission time that add to the path's climb angle (rad), the attitude (rad), and
    the height (m)."""

    climb_angle: Signal = ZERO
    roll: Signal = ZERO
    pitch: Signal = ZERO
    yaw: Signal = ZERO
    heave: Signal = ZERO

    @property
    def signals(self) -> tuple[Signal, ...]:
        """All of them."""
        return self.climb_angle, self.roll, self.pitch, self.yaw, self.heave


@dataclass(frozen=True, kw_only=True)
class Overlay(Checked, ABC):
    """Motion from `start` on, for `duration` or to the end; it swells and fades within `ramp`."""

    start: float = quantity("s", 0, 1e6, 0)
    duration: float | None = quantity("s", 1, 1e6, None)
    ramp: float = quantity("s", 1, 1e4, 60)

    @abstractmethod
    def motion(self) -> Motion:
        """What it adds."""

    def envelope(self) -> Steps:
        """From 0 to 1 and back."""
        if self.duration is None:
            return Steps(0.0, (Step(self.start, self.ramp, 1.0),))
        ramp = min(self.ramp, self.duration / 2)
        return Steps(0.0, lobe(1.0, ramp, self.duration - 2 * ramp, self.start))


@dataclass(frozen=True, kw_only=True)
class Sway(Overlay):
    """A seaway's roll, pitch, yaw and heave.

    Without a seed each is one sine of the amplitude and period, at `phase`. With a seed each is a
    sum of `waves` sines of random phases and of periods within 30 % of the period, of the same rms.
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

    def motion(self) -> Motion:
        random = None if self.seed is None else np.random.default_rng(self.seed)
        names = ("roll", "pitch", "yaw", "heave")
        return Motion(**{name: self._signal(name, random) for name in names})

    def _signal(self, name: str, random: np.random.Generator | None) -> Signal:
        amplitude, period = getattr(self, name), getattr(self, f"{name}_period")
        sines: tuple[Sine, ...] = (Sine(amplitude, 2 * math.pi / period, self.phase),)
        if random is not None:
            phases = random.uniform(0, 2 * math.pi, self.waves)
            periods = period * random.uniform(1 - SPREAD, 1 + SPREAD, self.waves)
            each = amplitude / math.sqrt(self.waves)
            sines = tuple(
                Sine(each, 2 * math.pi / float(T), float(phase))
                for T, phase in zip(periods, phases, strict=True)
            )
        return Product(self.envelope(), sines) if amplitude else ZERO


@dataclass(frozen=True, kw_only=True)
class Hills(Overlay):
    """The path climbs and falls sinusoidally in time."""

    climb_angle: float = quantity("deg", 0, 30)
    period: float = quantity("s", 1, 1e5)

    def motion(self) -> Motion:
        sine = Sine(self.climb_angle, 2 * math.pi / self.period)
        return Motion(climb_angle=Product(self.envelope(), (sine,)))
