"""From profiles to positions and attitudes on WGS-84: the path integrated, knots of a spline."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from ins_eval.common import earth
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.manoeuvres.manoeuvre import Leg
from ins_eval.trajectories.manoeuvres.overlays import Motion
from ins_eval.trajectories.trajectory import Knots

Array = NDArray[np.float64]

LIMIT = math.radians(89.0)
"""Largest latitude."""
SPACINGS = (0.25, 0.2, 0.1, 0.05, 0.02, 0.01)
"""Times between knots, s."""
PER_CHANGE = 12
"""Knots within the shortest change, at least."""
TOLERANCE = 1e-11
"""Of the integration: relative, and rad or m."""
FEWEST = 8
"""Knots at least."""


@dataclass(frozen=True)
class Origin:
    """Where a path begins and which way: rad, m."""

    latitude: float
    longitude: float
    height: float
    heading: float


@dataclass(frozen=True)
class _Flight:
    """A leg in mission time, with the motions beside it."""

    start: float
    leg: Leg
    motions: Sequence[Motion]

    def speed(self, time: Any) -> Any:
        return self.leg.speed(time - self.start)

    def climb_angle(self, time: Any) -> Any:
        hills = sum(m.climb_angle(time) for m in self.motions)
        return self.leg.climb_angle(time - self.start) + hills

    def turn_rate(self, time: Any) -> Any:
        return self.leg.turn_rate(time - self.start)

    def derivative(self, time: float, state: Array) -> tuple[float, float, float, float]:
        """Of latitude, longitude, height and the path's heading."""
        latitude, _, height, heading = map(float, state)
        speed, climb = float(self.speed(time)), float(self.climb_angle(time))
        level = speed * math.cos(climb)
        east = level * math.sin(heading) / (earth.transverse_radius(latitude) + height)
        turn = float(self.turn_rate(time))
        if self.leg.great_circle:
            turn += east * math.tan(latitude)
        north = level * math.cos(heading) / (earth.meridian_radius(latitude) + height)
        return north, east / math.cos(latitude), speed * math.sin(climb), turn

    def channels(self, time: Array, path: Array) -> Array:
        """(n, 6) latitude, longitude, height, roll, pitch, yaw at times (n,) on a path (4, n)."""
        climb = self.climb_angle(time)
        pull = self.speed(time) * np.cos(climb) * self.turn_rate(time) / self.leg.gravity
        bank = self.leg.lean * np.arctan(pull)
        latitude, longitude, height, heading = path
        roll, pitch, yaw, heave = self._beside(time)
        rolled = self.leg.roll(time - self.start) + bank + roll
        position = (latitude, longitude, height + heave)
        return np.stack([*position, rolled, climb + pitch, heading + yaw], axis=-1)

    def _beside(self, time: Array) -> Array:
        """(4, n) roll, pitch, yaw and heave of the motions."""
        added = np.zeros((4, len(time)))
        for m in self.motions:
            added += [signal(time) for signal in (m.roll, m.pitch, m.yaw, m.heave)]
        return added

    def pieces(self, end: float) -> list[tuple[float, float]]:
        """Between breaks, where all signals are smooth."""
        own = (self.start + b for s in self.leg.signals for b in s.breaks)
        beside = (b for m in self.motions for b in m.climb_angle.breaks)
        inside = {b for b in (*own, *beside) if self.start + 1e-6 < b < end - 1e-6}
        return list(pairwise([self.start, *sorted(inside), end]))


def knots(
    origin: Origin, legs: Sequence[Leg], motions: Sequence[Motion], still: float, until: float
) -> Knots:
    """Knots, equally spaced: at rest before time 0, then along the legs.

    Args:
        origin: where the path begins.
        legs: one after another from time 0; the last one goes on as it ends.
        motions: beside them.
        still: time at rest, s.
        until: time at which to end, s; up to a knot more.

    Raises:
        TrajectoryError: a path that leaves the latitudes that can be flown.
    """
    spacing = _spacing(legs, motions)
    grid = spacing * np.arange(max(math.ceil(until / spacing - 1e-9), FEWEST) + 1.0)
    rest = -spacing * np.arange(math.ceil(still / spacing - 1e-9), 0.0, -1.0)
    state = np.array([origin.latitude, origin.longitude, origin.height, origin.heading])
    rows = []
    for flight, end in _flights(legs, motions, float(grid[-1])):
        for piece in flight.pieces(end):
            time = grid[np.searchsorted(grid, piece[0]) : np.searchsorted(grid, piece[1])]
            path, state = _integrated(flight, piece, state, time)
            rows.append(flight.channels(time, path))
    rows.append(flight.channels(grid[-1:], state[:, None]))
    moving = np.concatenate(rows)
    standing = np.broadcast_to(moving[0], (len(rest), 6))
    return Knots(np.concatenate([rest, grid]), *np.concatenate([standing, moving]).T)


def _spacing(legs: Sequence[Leg], motions: Sequence[Motion]) -> float:
    signals = [s for leg in legs for s in leg.signals] + [s for m in motions for s in m.signals]
    wanted = min(signal.scale for signal in signals) / PER_CHANGE
    return next((s for s in SPACINGS if s <= wanted), SPACINGS[-1])


def _flights(
    legs: Sequence[Leg], motions: Sequence[Motion], last: float
) -> Iterator[tuple[_Flight, float]]:
    """Legs in mission time and where each ends; the last one reaches `last`."""
    start = 0.0
    for i, leg in enumerate(legs):
        end = start + leg.duration
        if i == len(legs) - 1 or end >= last:
            yield _Flight(start, leg, motions), last
            return
        yield _Flight(start, leg, motions), end
        start = end


def _integrated(
    flight: _Flight, piece: tuple[float, float], state: Array, time: Array
) -> tuple[Array, Array]:
    """Path (4, n) at times (n,) within a piece, and the state (4,) at its end.

    Dormand and Prince's method of order 8 (Hairer, Norsett and Wanner 1993).
    """

    def room(_: float, y: Array) -> float:
        return LIMIT - abs(float(y[0]))

    room.terminal = True  # type: ignore[attr-defined]
    solved = solve_ivp(
        flight.derivative,
        piece,
        state,
        method="DOP853",
        t_eval=np.append(time, piece[1]),
        events=room,
        rtol=TOLERANCE,
        atol=TOLERANCE,
    )
    if solved.status == 1:
        raise TrajectoryError(
            f"at {solved.t_events[0][0]:.0f} s it passes latitude "
            f"{math.copysign(math.degrees(LIMIT), solved.y_events[0][0][0]):g} deg; expected to "
            "stay within 89 deg of the equator, short of the poles"
        )
    if solved.status != 0:
        raise TrajectoryError(f"from {piece[0]:.0f} s on: {solved.message}")
    return solved.y[:, :-1], solved.y[:, -1]
