"""Motion for tests."""

import numpy as np

from ins_eval.common import earth
from ins_eval.mission_model.missions import STILL
from ins_eval.parking.mission import Mission, sample_mission
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.records.imu.log import Increments


def at_rest(
    latitude: float, height: float, seconds: float, gyro_bias: np.ndarray, yaw: float = 0.0
) -> Increments:
    """Increments at 100 Hz of a level vehicle at rest whose gyros are biased, rad/s."""
    north = earth.RATE * np.cos(latitude)
    rate = np.array([north * np.cos(yaw), -north * np.sin(yaw), -earth.RATE * np.sin(latitude)])
    south = -earth.horizontal_gravity(latitude, height, (0.0, 0.0))[0]
    force = np.array([south * np.cos(yaw), -south * np.sin(yaw), -earth.gravity(latitude, height)])
    count = round(seconds * 100)
    return Increments(
        0.01,
        np.tile((rate + gyro_bias) * 0.01, (count, 1)),
        np.tile(force * 0.01, (count, 1)),
    )


def short_mission(hours: float) -> Mission:
    """The default manoeuvre, cut short."""
    return sample_mission(load_trajectory("car", hours * 3600 + 10, STILL), hours)
