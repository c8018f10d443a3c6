"""From profiles of legs to spline knots: the path on WGS-84 is integrated numerically."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from ins_eval.common import earth
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.manoeuvres.manoeuvre import Leg
from ins_eval.trajectories.manoeuvres.overlays import OverlayMotion
from pyhrg.common.arrays import Array

MAX_LATITUDE = math.radians(89.0)
"""Largest latitude of a path, rad. Chosen: at a pole north and east end."""
SPACINGS = (0.25, 0.2, 0.1, 0.05, 0.02, 0.01)
"""Times between knots that are used, s. Chosen."""
KNOTS_PER_CHANGE = 12
"""Smallest number of knots within the shortest change of a signal. Chosen."""
TOLERANCE = 1e-11
"""Tolerance of the integration, relative and absolute (rad or m). Chosen."""
MIN_KNOTS = 8
"""Smallest number of knots; a quintic spline needs six."""


@dataclass(frozen=True)
class _LegInTime:
    """A leg that begins at mission time `start`, s, with the overlays' motions."""

    start: float
    leg: Leg
    motions: Sequence[OverlayMotion]

    def speed(self, time: Any) -> Any:
        return self.leg.speed(time - self.start)

    def climb_angle(self, time: Any) -> Any:
        hills = sum(m.climb_angle(time) for m in self.motions)
        return self.leg.climb_angle(time - self.start) + hills

    def turn_rate(self, time: Any) -> Any:
        return self.leg.turn_rate(time - self.start)

    def derivative(self, time: float, state: Array) -> tuple[float, float, float, float]:
        """Return the rates of latitude, longitude, height and the path's heading."""
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
        """Return position, roll, pitch, yaw (n, 6) at times (n,) on a path (4, n)."""
        climb = self.climb_angle(time)
        tan_bank = self.speed(time) * np.cos(climb) * self.turn_rate(time) / self.leg.gravity
        bank = self.leg.lean * np.arctan(tan_bank)
        latitude, longitude, height, heading = path
        roll, pitch, yaw, heave = self._sum_motions(time)
        total_roll = self.leg.roll(time - self.start) + bank + roll
        position = (latitude, longitude, height + heave)
        return np.stack([*position, total_roll, climb + pitch, heading + yaw], axis=-1)

    def _sum_motions(self, time: Array) -> Array:
        """Return roll, pitch, yaw and heave (4, n) of the overlays."""
        added = np.zeros((4, len(time)))
        for m in self.motions:
            added += [signal(time) for signal in (m.roll, m.pitch, m.yaw, m.heave)]
        return added

    def split_at_breaks(self, end: float) -> list[tuple[float, float]]:
        """Return the intervals between breaks, within which all signals are smooth."""
        own = (self.start + b for s in self.leg.signals for b in s.breaks)
        beside = (b for m in self.motions for b in m.climb_angle.breaks)
        inside = {b for b in (*own, *beside) if self.start + 1e-6 < b < end - 1e-6}
        return list(pairwise([self.start, *sorted(inside), end]))


def compute_knots(
    state: Array,
    legs: Sequence[Leg],
    motions: Sequence[OverlayMotion],
    still: float,
    until: float,
) -> tuple[Array, Array]:
    """Times (n,), s, and channels (n, 6), as `Trajectory` takes them, of equally spaced knots: at
    rest for `still` s, then along the legs from time 0 until up to one spacing after `until`, s.

    state: (4,) latitude, longitude, rad, height, m, and heading, rad, at time 0. The last leg is
    continued as it ends.
    """
    spacing = _choose_spacing(legs, motions)
    grid = spacing * np.arange(max(math.ceil(until / spacing - 1e-9), MIN_KNOTS) + 1.0)
    before = -spacing * np.arange(math.ceil(still / spacing - 1e-9), 0.0, -1.0)
    rows = []
    for leg, end in _place_legs(legs, motions, float(grid[-1])):
        for piece in leg.split_at_breaks(end):
            time = grid[np.searchsorted(grid, piece[0]) : np.searchsorted(grid, piece[1])]
            path, state = _integrate(leg, piece, state, time)
            rows.append(leg.channels(time, path))
    rows.append(leg.channels(grid[-1:], state[:, None]))
    moving = np.concatenate(rows)
    standing = np.broadcast_to(moving[0], (len(before), 6))
    return np.concatenate([before, grid]), np.concatenate([standing, moving])


def _choose_spacing(legs: Sequence[Leg], motions: Sequence[OverlayMotion]) -> float:
    signals = [s for leg in legs for s in leg.signals] + [s for m in motions for s in m.signals]
    wanted = min(signal.scale for signal in signals) / KNOTS_PER_CHANGE
    return next((s for s in SPACINGS if s <= wanted), SPACINGS[-1])


def _place_legs(
    legs: Sequence[Leg], motions: Sequence[OverlayMotion], last: float
) -> Iterator[tuple[_LegInTime, float]]:
    """Yield each leg in mission time with its end, s; the final leg ends at `last`."""
    start = 0.0
    for i, leg in enumerate(legs):
        end = start + leg.duration
        if i == len(legs) - 1 or end >= last:
            yield _LegInTime(start, leg, motions), last
            return
        yield _LegInTime(start, leg, motions), end
        start = end


def _integrate(
    leg: _LegInTime, piece: tuple[float, float], state: Array, time: Array
) -> tuple[Array, Array]:
    """Integrate the path over a piece; return it (4, n) at times (n,), and its last state (4,).

    The method is Dormand and Prince's of order 8 (Hairer, Norsett and Wanner 1993).
    """

    def reach_limit(_: float, y: Array) -> float:
        return MAX_LATITUDE - abs(float(y[0]))

    reach_limit.terminal = True  # type: ignore[attr-defined]
    solved = solve_ivp(
        leg.derivative,
        piece,
        state,
        method="DOP853",
        t_eval=np.append(time, piece[1]),
        events=reach_limit,
        rtol=TOLERANCE,
        atol=TOLERANCE,
    )
    if solved.status == 1:
        limit = math.copysign(math.degrees(MAX_LATITUDE), solved.y_events[0][0][0])
        raise TrajectoryError(
            f"at {solved.t_events[0][0]:.0f} s it passes latitude {limit:g} deg; expected to stay "
            "within 89 deg of the equator, short of the poles"
        )
    if solved.status != 0:
        raise TrajectoryError(f"from {piece[0]:.0f} s on: {solved.message}")
    return solved.y[:, :-1], solved.y[:, -1]
