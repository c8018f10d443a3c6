"""Records that are aligned on: recorded logs, or a simulated IMU on a vehicle that stands."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ins_eval.cli.flight_options import sources
from ins_eval.cli.flight_options.place import Place
from ins_eval.common.increments import Increments
from ins_eval.flights.flight import run_seeds
from ins_eval.flights.plan import WARM_UP
from ins_eval.imu.imu import Imu
from ins_eval.trajectories import catalogue
from pyhrg.common.errors import HrgError

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Record:
    """Increments of a standing vehicle; position: (3,) latitude, longitude (rad), height (m);
    mat_nb: true attitude at the record's end, None if it isn't known."""

    name: str
    increments: Increments
    position: Array
    mat_nb: Array | None = None


def recorded(path: Path, where: Place, first: float, seconds: float) -> Record:
    """A stretch of a log.

    Raises:
        HrgError: a log that is shorter, or does not say where it was recorded.
    """
    log, position = sources.log(path, where)
    return Record(path.name, stretch(path, log.increments, first, seconds), position)


def stretch(path: Path, increments: Increments, first: float, seconds: float) -> Increments:
    """Increments from a time since the log's beginning on.

    Raises:
        HrgError: a log that is shorter.
    """
    begin, count = (round(time / increments.interval) for time in (first, seconds))
    if begin + count > len(increments):
        raise HrgError(
            f"{path}: found {increments.duration:g} s, expected {first + seconds:g} s at least"
        )
    return increments.between(begin, begin + count)


def simulated(imu: Imu, trajectory: str, seconds: float, seed: int) -> Record:
    """What an IMU measures before a trajectory sets off, warmed up; the true attitude is known."""
    interval = imu.interval
    warm_up, count = round(WARM_UP / interval), round(seconds / interval)
    still = (warm_up + count) * interval
    truth = catalogue.trajectory(trajectory, still, 60.0)
    increments = truth.increments(-still, interval, warm_up + count)
    (run_seed,) = run_seeds(seed, 1)
    measured = imu.measure(increments, run_seed).increments
    start = truth.state(0.0)
    position = np.array([start.latitude, start.longitude, start.height])
    name = f"{imu.name} IMU, {truth.name}"
    return Record(name, measured.between(warm_up, warm_up + count), position, start.mat_nb)
