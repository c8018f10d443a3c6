"""Small Datasets of flights."""

import numpy as np
import xarray as xr

from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.state import Track
from ins_eval.results import flights

ROWS = 7


def track(longitude_deg: float, shift_m: float, yaw: float = 0.3) -> Track:
    """Eastwards at 45 deg of latitude, a degree a row, shifted north by about `shift_m`."""
    time = 600.0 * np.arange(1.0, ROWS + 1)
    longitude = np.deg2rad(longitude_deg + np.arange(float(ROWS)))
    latitude = np.full(ROWS, np.deg2rad(45.0) + shift_m / 6.37e6)
    position = np.stack([latitude, longitude, np.full(ROWS, 100.0)], axis=-1)
    velocity = np.tile([0.0, 131.0, 0.0], (ROWS, 1))
    mat_nb = np.tile(mat_from_euler(np.array(0.1), np.array(0.05), np.array(yaw)), (ROWS, 1, 1))
    return Track(time, position, velocity, mat_nb)


def covariance() -> np.ndarray:
    """(m, 15, 15) that grows with time; north and east correlated by a half."""
    each = np.eye(15) * np.arange(1.0, 16.0)
    each[0, 1] = each[1, 0] = 0.5 * np.sqrt(each[0, 0] * each[1, 1])
    return np.arange(1.0, ROWS + 1)[:, None, None] * each


def dataset(longitude_deg: float = 10.0, runs: int = 2, sigma: bool = True) -> xr.Dataset:
    """All that a flight's Dataset can hold."""
    truth = track(longitude_deg, 0.0)
    tracks = [track(longitude_deg, 10.0 * (run + 1), 0.3 + 1e-4) for run in range(runs)]
    parts = [
        flights.compare_with_truth(tracks, truth),
        flights.tabulate_own_error(track(longitude_deg, 1e-4), truth),
    ]
    if sigma:
        parts.append(flights.tabulate_sigmas(truth.time, covariance()))
    return xr.merge(parts).assign_attrs(title="a title")
