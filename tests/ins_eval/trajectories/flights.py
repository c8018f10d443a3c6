"""Missions for tests, and figures of their paths."""

import numpy as np

from ins_eval.common import earth
from ins_eval.common.state import position_error
from ins_eval.trajectories.manoeuvres.manoeuvre import Manoeuvre
from ins_eval.trajectories.manoeuvres.overlays import Overlay
from ins_eval.trajectories.mission import Mission, Start, build_trajectory, compute_duration
from ins_eval.trajectories.trajectory import Trajectory

LATITUDE = np.deg2rad(45.0)
HEIGHT = 1000.0
GRAVITY = float(earth.gravity(LATITUDE, HEIGHT))


def fly_manoeuvres(
    *manoeuvres: Manoeuvre,
    speed: float = 200.0,
    heading: float = 0.0,
    overlays: tuple[Overlay, ...] = (),
    climb_angle: float = 0.0,
) -> tuple[Trajectory, float]:
    """A trajectory of manoeuvres, and the time at which they end, s."""
    start = Start(
        latitude=LATITUDE,
        longitude=0.2,
        height=HEIGHT,
        heading=heading,
        speed=speed,
        climb_angle=climb_angle,
    )
    mission = Mission(name="test", start=start, course=manoeuvres, overlays=overlays)
    return build_trajectory(mission, compute_duration(mission)), compute_duration(mission)


def displacement(trajectory: Trajectory, time: float) -> np.ndarray:
    """North, east, down (3,) from time 0, m."""
    at = trajectory.position(np.array([0.0, time]))
    return position_error(at[1], at[0])


def euler(trajectory: Trajectory, time: np.ndarray) -> np.ndarray:
    """(..., 3) roll, pitch, yaw, rad, as far as a matrix tells them."""
    mat = trajectory.mat_nb(time)
    roll = np.arctan2(mat[..., 2, 1], mat[..., 2, 2])
    pitch = np.arcsin(-mat[..., 2, 0])
    return np.stack([roll, pitch, np.arctan2(mat[..., 1, 0], mat[..., 0, 0])], axis=-1)
