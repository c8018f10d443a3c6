"""The motion about which errors are linearized: that of a trajectory.

Each step of the linear model has five nodes, a quarter of a step apart. Boole's rule over the nodes
takes in the rotation of the vehicle within a step.
"""

from dataclasses import dataclass

import numpy as np

from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array

PARTS = 4
"""Parts of a step; there is a node at each bound."""
BOOLE = np.array([7.0, 32.0, 12.0, 32.0, 7.0]) / 90
"""Weights of a step's nodes in its mean, by Boole's rule; exact for polynomials of degree 5."""


@dataclass(frozen=True)
class Motion:
    """Motion at the nodes (m,) of n steps, m = 4 n + 1.

    Attributes:
        step, start: duration of a step and time of the first node, s.
        latitude: (m,) rad.
        height: (m,) m.
        velocity: (m, 3) north, east, down, m/s.
        mat_nb: (m, 3, 3).
        rate: (m, 3) `omega_ib_b`, rad/s.
        force: (m, 3) `f_b`, m/s^2.
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
    rotation = trajectory.increments(start, spacing, PARTS * count).rotation
    return Motion(
        step=step,
        start=start,
        latitude=position[:, 0],
        height=position[:, 2],
        velocity=trajectory.velocity(time),
        mat_nb=trajectory.mat_nb(time),
        rate=rate,
        force=force,
        turned=np.concatenate([np.zeros((1, 3)), np.cumsum(rotation, axis=0)]),
    )
