"""The truth that flights are held to."""

from dataclasses import dataclass

import numpy as np

from ins_eval.common.state import State, Track
from ins_eval.flights.plan import Plan
from ins_eval.mission_model.missions import SETTLING
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.records.imu.increments import Increments


@dataclass(frozen=True)
class Truth:
    """A trajectory, sampled for a plan.

    trajectory: what is sampled; increments: ideal, from power-on; warm, zero: numbers of increments
    before alignment and before time 0; start: at time 0; track: at the kept times; heights: at the
    bounds of the flight's intervals, m.
    """

    trajectory: Trajectory
    increments: Increments
    warm: int
    zero: int
    start: State
    track: Track
    heights: Array

    @property
    def position(self) -> Array:
        """(3,) at time 0: latitude, longitude, rad, height, m."""
        return self.start.position

    def alignment(self, increments: Increments) -> Increments:
        """Increments after the warm-up, until time 0."""
        return increments.between(self.warm, self.zero)

    def flight(self, increments: Increments) -> Increments:
        """Increments from time 0 on."""
        return increments.between(self.zero, len(increments))


def count_still_increments(
    alignment: float | None, interval: float, warm_up: float = SETTLING
) -> tuple[int, int]:
    """Numbers of increments of the warm-up, and of warm-up and alignment together."""
    if alignment is None:
        return 0, 0
    warm = round(warm_up / interval)
    return warm, warm + round(alignment / interval)


def sample_truth(plan: Plan, trajectory: Trajectory) -> Truth:
    """Ideal increments and true states of a trajectory that covers the plan."""
    warm, zero = count_still_increments(plan.alignment, plan.interval)
    bounds = plan.interval * np.arange(plan.count + 1.0)
    return Truth(
        trajectory=trajectory,
        increments=trajectory.increments(-zero * plan.interval, plan.interval, zero + plan.count),
        warm=warm,
        zero=zero,
        start=trajectory.state(0.0),
        track=trajectory.track(bounds[plan.keep_every :: plan.keep_every]),
        heights=trajectory.position(bounds)[:, 2],
    )
