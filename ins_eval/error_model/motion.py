"""The motion about which errors are linearized: that of a trajectory, or of a navigator's track.

Each step of the linear model has five nodes, a quarter of a step apart. Boole's rule over the nodes
takes in the rotation of the vehicle within a step.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.state import State, Track
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.records.imu.increments import Increments

Array = NDArray[np.float64]

PARTS = 4
"""Parts of a step; there is a node at each bound."""
BOOLE = np.array([7.0, 32.0, 12.0, 32.0, 7.0]) / 90
"""Weights of a step's nodes in its mean, by Boole's rule; exact for polynomials of degree 5."""


@dataclass(frozen=True)
class Motion:
    """Motion at the nodes (m,) of n steps, m = 4 n + 1.

    step, start: duration of a step and time of the first node, s; latitude: (m,) rad; height: (m,)
    m; velocity: (m, 3) north, east, down, m/s; mat_nb: (m, 3, 3); rate: (m, 3) `omega_ib_b`, rad/s;
    force: (m, 3) `f_b`, m/s^2;
    turned: (m, 3) integral of `rate` on each axis from the start, rad.
    """

    step: float
    start: float
    latitude: Array
    height: Array
    velocity: Array
    mat_nb: Array
    rate: Array
    force: Array
    turned: Array

    def __len__(self) -> int:
        return (len(self.latitude) - 1) // PARTS

    @property
    def time(self) -> Array:
        """(n + 1,) times of the steps' bounds, s."""
        return np.asarray(self.start + self.step * np.arange(len(self) + 1.0))


def step_mean(at_nodes: Array) -> Array:
    """Return means (n, ...) over the steps of values (m, ...) at the nodes."""
    first = len(at_nodes) - PARTS
    parts = (w * at_nodes[k : first + k : PARTS] for k, w in enumerate(BOOLE))
    return np.asarray(sum(parts))


def sample_motion(trajectory: Trajectory, start: float, step: float, count: int) -> Motion:
    """Sample the motion of a trajectory in `count` steps of `step` seconds from time `start`."""
    spacing = step / PARTS
    time = np.asarray(start + spacing * np.arange(PARTS * count + 1.0))
    position = trajectory.position(time)
    rate, force = trajectory.rate_and_force(time)
    return Motion(
        step=step,
        start=start,
        latitude=position[:, 0],
        height=position[:, 2],
        velocity=trajectory.velocity(time),
        mat_nb=trajectory.mat_nb(time),
        rate=rate,
        force=force,
        turned=_running_sum(trajectory.increments(start, spacing, PARTS * count).rotation),
    )


def motion_of_track(start: State, track: Track, increments: Increments) -> Motion:
    """Return the motion of a navigator's track.

    Args:
        start: state in which the navigation began, at the increments' start.
        track: navigated states at equally spaced times, each of which is a node: four rows a step.
        increments: from which the track was computed, at least up to its last time.

    Raises:
        ValueError: the rows are no whole number of steps, or their times are no multiples of the
            increments' interval after the increments' start.
    """
    per_node, nodes = _intervals_per_node(track.time, increments), len(track) + 1
    bounds = slice(0, per_node * len(track) + 1, per_node)
    return Motion(
        step=PARTS * per_node * increments.interval,
        start=increments.start,
        latitude=np.append(start.latitude, track.position[:, 0]),
        height=np.append(start.height, track.position[:, 2]),
        velocity=np.concatenate([start.velocity[None], track.velocity]),
        mat_nb=np.concatenate([start.mat_nb[None], track.mat_nb]),
        rate=_at_bounds(increments.rotation, increments.interval, per_node, nodes),
        force=_at_bounds(increments.velocity, increments.interval, per_node, nodes),
        turned=_running_sum(increments.rotation)[bounds],
    )


def _intervals_per_node(time: Array, increments: Increments) -> int:
    if len(time) == 0 or len(time) % PARTS:
        raise ValueError(f"track of {len(time)} rows: expected a multiple of {PARTS}")
    per_node = round((time[0] - increments.start) / increments.interval)
    expected = increments.start + per_node * increments.interval * np.arange(1, len(time) + 1)
    if per_node < 1 or not np.allclose(time, expected, rtol=0, atol=1e-6):
        raise ValueError(
            f"track from {time[0]} to {time[-1]} s in {len(time)} rows: expected equal times after "
            f"the increments' start, {increments.start} s, at multiples of {increments.interval} s"
        )
    if len(time) * per_node > len(increments):
        raise ValueError(f"track up to {time[-1]} s: increments end at {increments.bounds[-1]} s")
    return per_node


def _at_bounds(sums: Array, interval: float, per_node: int, nodes: int) -> Array:
    """Return rates (nodes, 3): means over one spacing around each node, one-sided at the ends."""
    total = _running_sum(sums)
    centre = per_node * np.arange(nodes)
    reach = max(per_node // 2, 1)
    first = np.maximum(centre - reach, 0)
    last = np.minimum(centre + reach, len(sums))
    return (total[last] - total[first]) / ((last - first) * interval)[:, None]


def _running_sum(values: Array) -> Array:
    return np.concatenate([np.zeros((1, 3)), np.cumsum(values, axis=0)])
