"""A recorded drive as the filter takes it: increments in steps, with rate, force and turn at the
steps' nodes."""

from dataclasses import dataclass

import numpy as np

from ins_eval.common.state import State, Track
from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.navigation.height import Free
from ins_eval.navigation.strapdown import navigate
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

STEP = 0.5
"""Step of the linear model that is aimed at, s: that of flights (`flights.linear.STEP`)."""
SAMPLES = 2
"""Increments a navigation step. Chosen."""


@dataclass(frozen=True)
class Drive:
    """Increments of a drive; a node is every `each` of them, `PARTS` nodes make a step.

    increments: of whole steps; each: increments between nodes; rate, force: (m, 3) at the nodes,
    means over the increments around them, rad/s and m/s^2; turned: (m, 3) turn of each gyro from
    the beginning, rad, by its pattern where that was recorded.
    """

    increments: Increments
    each: int
    rate: Array
    force: Array
    turned: Array

    @property
    def rows(self) -> int:
        """Number of increments in a step."""
        return PARTS * self.each

    @property
    def step(self) -> float:
        """Duration of a step, s."""
        return self.rows * self.increments.interval

    @property
    def steps(self) -> int:
        """Number of whole steps."""
        return (len(self.rate) - 1) // PARTS

    def navigate(self, start: State, first: int, last: int) -> tuple[Track, Motion]:
        """Navigated states at the nodes of steps `first` to `last` - 1, the start's among them, and
        the motion along them."""
        part = self.increments.between(first * self.rows, last * self.rows)
        way = navigate(start, part, Free(), self.each, SAMPLES)
        track = Track(
            np.concatenate([[part.start], way.time]),
            np.concatenate([[start.position], way.position]),
            np.concatenate([[start.velocity], way.velocity]),
            np.concatenate([[start.mat_nb], way.mat_nb]),
        )
        nodes = slice(first * PARTS, last * PARTS + 1)
        motion = Motion(
            step=self.step,
            start=part.start,
            latitude=track.position[:, 0],
            height=track.position[:, 2],
            velocity=track.velocity,
            mat_nb=track.mat_nb,
            rate=self.rate[nodes],
            force=self.force[nodes],
            turned=self.turned[nodes],
        )
        return track, motion


def sample_drive(increments: Increments, turned: Array) -> Drive:
    """The drive of a record.

    turned: (n + 1, 3) turn of each gyro at the bounds of the increments (`measure_turn`).
    """
    each = SAMPLES * max(1, round(STEP / PARTS / increments.interval / SAMPLES))
    count = len(increments) // (PARTS * each) * PARTS * each
    used = increments.between(0, count)
    nodes = np.arange(0, count + 1, each)
    low, high = np.maximum(nodes - each // 2, 0), np.minimum(nodes + each // 2, count)

    def average(parts: Array) -> Array:
        summed = np.concatenate([np.zeros((1, 3)), np.cumsum(parts, axis=0)])
        return np.asarray((summed[high] - summed[low]) / ((high - low) * used.interval)[:, None])

    return Drive(used, each, average(used.rotation), average(used.velocity), turned[nodes])


def measure_turn(increments: Increments, pattern: Array | None) -> Array:
    """(n + 1, 3) turn of each gyro at the bounds of increments, rad: since its pattern angle was
    0, or since the first bound where no pattern is known.

    pattern: (n, 3) angles at the end of each interval, with jumps of half turns or without; None
    where nothing recorded them.
    """
    turned = np.concatenate([np.zeros((1, 3)), np.cumsum(increments.rotation, axis=0)])
    if pattern is None:
        return turned
    first = pattern[:1] + ANGULAR_GAIN * increments.rotation[:1]
    angles = np.unwrap(np.concatenate([first, pattern]), axis=0, period=np.pi)
    return np.asarray(-angles / ANGULAR_GAIN)
