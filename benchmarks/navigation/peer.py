"""pyins, where it is importable: `pip install git+https://github.com/nmayorov/pyins`."""

import importlib
from typing import Any

import numpy as np
import pandas as pd
from scipy.spatial.transform import Rotation

from benchmarks.navigation.motions import KEPT_EACH, Flight
from ins_eval.common.state import State, Track
from pyhrg.records.imu.log import Increments


def peer() -> Any | None:
    """pyins's module `strapdown`."""
    try:
        return importlib.import_module("pyins.strapdown")
    except ImportError:
        return None


def table(record: Increments) -> pd.DataFrame:
    """Increments as pyins wants them: the first row is of the interval before the start."""
    columns = ["gyro_x", "gyro_y", "gyro_z", "accel_x", "accel_y", "accel_z"]
    values = np.hstack([record.rotation, record.velocity])
    return pd.DataFrame(values, index=record.bounds[1:], columns=columns)


def navigated(strapdown: Any, start: State, record: pd.DataFrame) -> pd.DataFrame:
    """Increments in, track out; height clamped."""
    yaw, pitch, roll = Rotation.from_matrix(start.mat_nb).as_euler("ZYX", degrees=True)
    position = [np.rad2deg(start.latitude), np.rad2deg(start.longitude), start.height]
    names = ["lat", "lon", "alt", "VN", "VE", "VD", "roll", "pitch", "heading"]
    values = [*position, *start.velocity, roll, pitch, yaw]
    pva = pd.Series(values, index=names, name=record.index[0])
    integrator = strapdown.Integrator(pva, with_altitude=False)
    return integrator.integrate(strapdown.compute_increments_from_imu(record, "increment"))


def flown(strapdown: Any, flight: Flight) -> Track:
    """By pyins, at the times at which this navigator keeps states."""
    keep = round(KEPT_EACH / flight.record.interval)
    rows = navigated(strapdown, flight.start(), table(flight.record)).iloc[keep::keep]
    position = rows[["lat", "lon", "alt"]].to_numpy()
    angles = rows[["heading", "pitch", "roll"]].to_numpy()
    return Track(
        time=flight.increments.bounds[keep::keep],
        position=np.column_stack([np.deg2rad(position[:, :2]), position[:, 2]]),
        velocity=rows[["VN", "VE", "VD"]].to_numpy(),
        mat_nb=Rotation.from_euler("ZYX", angles, degrees=True).as_matrix(),
    )
