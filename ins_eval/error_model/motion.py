"""The motion that errors are linearised about: a trajectory's, or one that was flown.

A step of the linear model has five nodes, at its quarters: attitude may turn within a step, and
Boole's rule over the nodes sees it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.increments import Increments
from ins_eval.state import Track
from ins_eval.trajectories.trajectory import Trajectory

Array = NDArray[np.float64]

PARTS = 4
"""Parts of a step, with a node at each bound."""
BOOLE = np.array([7.0, 32.0, 12.0, 32.0, 7.0]) / 90
"""Weights of a step's nodes in its mean; exact for polynomials of fifth degree."""


@dataclass(frozen=True)
class Motion:
    """Motion at the nodes (m,) of n steps, m = 4 n + 1.

    step: s; start: s; latitude: (m,) rad; height: (m,) m; velocity: (m, 3) north, east, down,
    m/s; mat_nb: (m, 3, 3); rate: (m, 3) `omega_ib_b`, rad/s; force: (m, 3) `f_b`, m/s^2;
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
        """(n + 1,) bounds of the steps, s."""
        return np.asarray(self.start + self.step * np.arange(len(self) + 1.0))


def step_mean(at_nodes: Array) -> Array:
    """(n, ...) means over the steps, from (m, ...)."""
    first = len(at_nodes) - PARTS
    parts = (w * at_nodes[k : first + k : PARTS] for k, w in enumerate(BOOLE))
    return np.asarray(sum(parts))


def along(trajectory: Trajectory, start: float, step: float, count: int) -> Motion:
    """Motion of a trajectory over `count` steps of `step` seconds from `start`."""
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


def flown(track: Track, increments: Increments, parts: int = 1) -> Motion:
    """Motion that a navigator (or a reference) put out, with the increments that it came from.

    Args:
        track: states at equal times, the first at the start of the increments; each is a node.
        increments: at least up to the last of these times.
        parts: rows of the track from node to node.

    Raises:
        ValueError: a track that has no whole number of steps, does not begin with the increments,
            or whose times are no multiples of their interval.
    """
    time = track.time[::parts]
    per_node = _intervals_per_node(time, increments)
    rate = _at_bounds(increments.rotation, increments.interval, per_node, len(time))
    force = _at_bounds(increments.velocity, increments.interval, per_node, len(time))
    return Motion(
        step=PARTS * per_node * increments.interval,
        start=float(time[0]),
        latitude=track.position[::parts, 0],
        height=track.position[::parts, 2],
        velocity=track.velocity[::parts],
        mat_nb=track.mat_nb[::parts],
        rate=rate,
        force=force,
        turned=_running_sum(increments.rotation)[: per_node * (len(time) - 1) + 1 : per_node],
    )


def _intervals_per_node(time: Array, increments: Increments) -> int:
    if len(time) < PARTS + 1 or (len(time) - 1) % PARTS:
        raise ValueError(f"{len(time)} nodes of motion: expected a multiple of {PARTS}, plus 1")
    per_node = round((time[1] - time[0]) / increments.interval)
    expected = increments.start + per_node * increments.interval * np.arange(len(time))
    if per_node < 1 or not np.allclose(time, expected, rtol=0, atol=1e-6):
        raise ValueError(
            f"track from {time[0]} s every {time[1] - time[0]} s: expected equal times from the "
            f"increments' start, {increments.start} s, at multiples of {increments.interval} s"
        )
    if (len(time) - 1) * per_node > len(increments):
        raise ValueError(f"track up to {time[-1]} s: increments end at {increments.bounds[-1]} s")
    return per_node


def _at_bounds(sums: Array, interval: float, per_node: int, nodes: int) -> Array:
    """Rates (nodes, 3) at the nodes: means over a node's spacing, centred, one-sided at ends."""
    total = _running_sum(sums)
    centre = per_node * np.arange(nodes)
    reach = max(per_node // 2, 1)
    first = np.maximum(centre - reach, 0)
    last = np.minimum(centre + reach, len(sums))
    return (total[last] - total[first]) / ((last - first) * interval)[:, None]


def _running_sum(values: Array) -> Array:
    return np.concatenate([np.zeros((1, 3)), np.cumsum(values, axis=0)])
