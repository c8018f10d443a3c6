"""Recorded IMUs, with the attitude that their logs state."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.increments import Increments
from ins_eval.common.rotation import mat_from_euler
from pyhrg.records.imu import recorded
from pyhrg.records.imu.log import LogError
from pyhrg.records.imu.recorded import write

__all__ = ["LogError", "RecordedImu", "read", "write"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class RecordedImu:
    """A log of an IMU.

    increments: body axes forward, right, down;
    position: (3,) latitude, longitude, rad, height, m, if the log says where it was taken;
    mat_nb: (3, 3) attitude at the start as the log states it, coarse, if it does;
    source: the file.
    """

    increments: Increments
    position: Array | None
    mat_nb: Array | None
    source: str


def read(path: Path, trusted: bool = False) -> RecordedImu:
    """The log in a file, as `pyhrg.records.imu.recorded.read`.

    Raises:
        LogError: likewise.
    """
    log = recorded.read(path, trusted)
    mat_nb = None if log.attitude is None else mat_from_euler(*log.attitude)
    return RecordedImu(log.increments, log.position, mat_nb, log.source)
