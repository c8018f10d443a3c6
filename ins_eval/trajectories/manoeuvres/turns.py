"""Manoeuvres that turn.

In a coordinated turn the specific force stays in the vehicle's plane of symmetry: at turn rate w
and speed v, tan(bank) = v w / g, and the radius is v^2 / (g tan(bank)). The turn rate is ramped, so
that roll rates are smooth.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from ins_eval.trajectories.keys import choice, quantity
from ins_eval.trajectories.manoeuvres.manoeuvre import (
    Entry,
    Leg,
    Manoeuvre,
    horizontal_speed,
    make_leg,
)
from ins_eval.trajectories.manoeuvres.signals import Product, Sine, Step, Steps, lobe

SIDES = {"right": 1.0, "left": -1.0}


@dataclass(frozen=True, kw_only=True)
class Turn(Manoeuvre):
    """A turn by an angle within a given time.

    `lean` is the ratio of the bank to that of a coordinated turn: 0 stays level, below 0 leans out,
    as a car does.
    """

    turn: float = quantity("deg", -3600, 3600)
    duration: float = quantity("s", 0.1, 1e5)
    lean: float = quantity("", -1, 1, 0)

    def leg(self, entry: Entry) -> Leg:
        horizontal_speed(entry)
        ramp = self.duration / 3
        rate = self.turn / (2 * ramp)
        return make_leg(
            entry, self.duration, turn_rate=Steps(0.0, lobe(rate, ramp, ramp)), lean=self.lean
        )


@dataclass(frozen=True, kw_only=True)
class CoordinatedTurn(Manoeuvre):
    """A turn at a bank angle, positive to the right; a small turn is flown at a smaller bank."""

    turn: float = quantity("deg", -3600, 3600)
    bank: float = quantity("deg", 0.1, 80, 25)
    ramp: float = quantity("s", 0.1, 100, 4)

    def leg(self, entry: Entry) -> Leg:
        steps = _turn(self.turn, _rate(entry, self.bank), self.ramp)
        return make_leg(entry, _end(steps), turn_rate=Steps(0.0, steps))


@dataclass(frozen=True, kw_only=True)
class UTurn(Manoeuvre):
    """A coordinated turn by 180 deg."""

    side: str = choice("right", "left", required=True)
    bank: float = quantity("deg", 0.1, 80, 25)
    ramp: float = quantity("s", 0.1, 100, 4)

    def leg(self, entry: Entry) -> Leg:
        turn = SIDES[self.side] * math.pi
        return CoordinatedTurn(turn=turn, bank=self.bank, ramp=self.ramp).leg(entry)


@dataclass(frozen=True, kw_only=True)
class STurn(Manoeuvre):
    """A coordinated turn, positive to the right, and the same turn back to the first heading."""

    turn: float = quantity("deg", -170, 170)
    bank: float = quantity("deg", 0.1, 80, 25)
    ramp: float = quantity("s", 0.1, 100, 4)

    def leg(self, entry: Entry) -> Leg:
        out = _turn(self.turn, _rate(entry, self.bank), self.ramp)
        steps = _and_back(out)
        return make_leg(entry, _end(steps), turn_rate=Steps(0.0, steps))


@dataclass(frozen=True, kw_only=True)
class FigureEight(Manoeuvre):
    """Two coordinated loops, the first to the given side, that end where they began."""

    bank: float = quantity("deg", 0.1, 80, 25)
    ramp: float = quantity("s", 0.1, 100, 4)
    side: str = choice("right", "left")

    def leg(self, entry: Entry) -> Leg:
        rate = _rate(entry, self.bank)
        angle = SIDES[self.side] * _closing_angle(rate, self.ramp)
        steps = _and_back(_turn(angle, rate, self.ramp))
        return make_leg(entry, _end(steps), turn_rate=Steps(0.0, steps))


@dataclass(frozen=True, kw_only=True)
class Weave(Manoeuvre):
    """Coordinated weaving: the heading swings about the course by heading * sin(2 pi t / period).

    With `ramp` 0 it begins at its full turn rate. Only a mission's first manoeuvre can do so, or
    one after a weave of the same kind. Otherwise the weave grows and fades within `ramp`.
    """

    heading: float = quantity("deg", -90, 90)
    period: float = quantity("s", 1, 1e4)
    duration: float = quantity("s", 1, 1e6)
    ramp: float = quantity("s", 0, 1e4, 0)

    def leg(self, entry: Entry) -> Leg:
        horizontal_speed(entry)
        frequency = 2 * math.pi / self.period
        swing = Sine(self.heading * frequency, frequency, math.pi / 2)
        if self.ramp == 0:
            return make_leg(entry, self.duration, turn_rate=swing)
        ramp = min(self.ramp, self.duration / 2)
        envelope = Steps(0.0, lobe(1.0, ramp, self.duration - 2 * ramp))
        return make_leg(entry, self.duration, turn_rate=Product(envelope, (swing,)))


def _rate(entry: Entry, bank: float) -> float:
    return entry.gravity * math.tan(bank) / horizontal_speed(entry)


def _turn(angle: float, rate: float, ramp: float) -> tuple[Step, ...]:
    """Return the steps of a turn rate that turns by an angle; a small one at less than `rate`."""
    hold = max(abs(angle) / rate - ramp, 0.0)
    return lobe(angle / (ramp + hold), ramp, hold)


def _and_back(steps: tuple[Step, ...]) -> tuple[Step, ...]:
    end = _end(steps)
    return (*steps, *(Step(s.start + end, s.length, -s.change) for s in steps))


def _end(steps: tuple[Step, ...]) -> float:
    return max(s.start + s.length for s in steps)


def _closing_angle(rate: float, ramp: float) -> float:
    """Return the angle, rad, of a loop that ends where it began; without ramps it is 2 pi."""
    points, weights = np.polynomial.legendre.leggauss(40)
    s = 0.5 * (points + 1)
    swept = ramp * (s - s**4 * (2.5 + s * (s - 3)))

    def half_chord(angle: float) -> float:
        """Return half the distance from start to end per speed, s: arc of the hold, then ramp."""
        turn_rate = min(rate, angle / ramp)
        arc = 0.5 * (angle - turn_rate * ramp)
        on_ramp = 0.5 * ramp * float(weights @ np.cos(arc + turn_rate * swept))
        return math.sin(arc) / turn_rate + on_ramp

    return float(brentq(half_chord, math.pi, 3 * math.pi, xtol=1e-14))
