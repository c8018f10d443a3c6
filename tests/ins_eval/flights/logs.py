"""Recorded logs for the command line's tests."""

from pathlib import Path

from ins_eval.imu import specification
from ins_eval.trajectories import catalogue
from pyhrg.records.imu.log import Increments
from tests.ins_eval.imu.logs import INCREMENTS, frame, saved
from tests.recordings import find_recording

LATITUDE_DEG = "39.9"
"""Where the car stands."""


def ring_laser() -> Path:
    """A recorded log; `HRG_REAL` says where such are."""
    return find_recording("lasergyro.imu.gz")


def standing(seconds: float, seed: int = 1) -> Increments:
    """What a simple IMU measures in a car that stands."""
    truth = catalogue.load_trajectory("car", 10.0, seconds)
    increments = truth.increments(-seconds, 0.01, round(seconds * 100))
    return specification.load_imu("simple").measure(increments, seed).increments


def written(folder: Path, seconds: float) -> Path:
    """Its log, as CSV."""
    return saved(frame(standing(seconds), *INCREMENTS), folder, "standing.csv")
