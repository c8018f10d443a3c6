"""Flights as labelled arrays and as tables.

The arrays are `xarray` Datasets whose variables carry their units. A table has one row a run and
time, and the unit in each column's name.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import xarray as xr

from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.state import Track, TrackError, track_error
from ins_eval.results import quantities
from ins_eval.results.quantities import ALL, BY_COLUMN, BY_NAME, Quantity
from pyhrg.common.arrays import Array

ATTITUDE = slice(6, 9)
"""Place in a covariance's first nine rows, as `TrackError` orders them."""


def tabulate_navigated(tracks: Sequence[Track]) -> xr.Dataset:
    """What the navigator says, dimensions (run, time)."""
    columns = np.stack([_state_columns(track) for track in tracks], axis=1)
    return _dataset(tracks[0].time, quantities.NAVIGATED, columns)


def compare_with_truth(tracks: Sequence[Track], truth: Track) -> xr.Dataset:
    """Navigated and true states at the same times, and the errors between them."""
    errors = np.stack([error_columns(track_error(track, truth)) for track in tracks], axis=1)
    radial = np.hypot(errors[0], errors[1])[None]
    return xr.merge(
        [
            tabulate_navigated(tracks),
            _dataset(truth.time, quantities.TRUE, _state_columns(truth)),
            _dataset(truth.time, quantities.ERROR, errors),
            _dataset(truth.time, (quantities.RADIAL_ERROR,), radial),
        ]
    )


def tabulate_own_error(track: Track, truth: Track) -> xr.Dataset:
    """The navigator's own error: a flight on ideal increments from the true start."""
    position = track_error(track, truth).position
    return _dataset(truth.time, quantities.OWN, position.T)


def tabulate_sigmas(time: Array, covariance: Array) -> xr.Dataset:
    """1-sigma of position, velocity and attitude.

    time: (m,) s; covariance: (m, k, k), k >= 9, of position (m), velocity (m/s), attitude (rad)
    north, east, down in this order.
    """
    deviations = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1)[:, :9]).T
    deviations[ATTITUDE] = np.rad2deg(deviations[ATTITUDE])
    cross = _dataset(time, (quantities.COVARIANCE,), covariance[:, 0, 1][None])
    return xr.merge([_dataset(time, quantities.SIGMA, deviations), cross])


def error_columns(error: TrackError) -> Array:
    """(9, m) as `quantities.ERROR` names them: m, m/s, deg."""
    return np.concatenate([error.position.T, error.velocity.T, np.rad2deg(error.attitude.T)])


def _state_columns(track: Track) -> Array:
    """(9, m) as `quantities.NAVIGATED` names them: deg, m, m/s."""
    roll, pitch, heading = np.rad2deg(euler_from_mat(track.mat_nb))
    return np.stack(
        [
            np.rad2deg(track.position[:, 0]),
            wrap_deg(np.rad2deg(track.position[:, 1])),
            track.position[:, 2],
            *track.velocity.T,
            heading % 360,
            pitch,
            roll,
        ]
    )


def wrap_deg(longitude: Array) -> Array:
    """To -180 (included) to 180 deg."""
    return np.asarray((longitude + 180) % 360 - 180)


def _dataset(time: Array, names: Sequence[Quantity], columns: Array) -> xr.Dataset:
    """Columns (k, [run,] m) under their names."""
    dims = ("time",) if columns.ndim == 2 else ("run", "time")
    coordinates = {"time": ("time", time, quantities.TIME.attributes)}
    if columns.ndim == 3:
        runs = np.arange(1, columns.shape[1] + 1)
        coordinates["run"] = ("run", runs, quantities.RUN.attributes)
    return xr.Dataset(
        {
            quantity.name: (dims, column, quantity.attributes)
            for quantity, column in zip(names, columns, strict=True)
        },
        coordinates,
    )


def tabulate(dataset: xr.Dataset) -> pd.DataFrame:
    """One row a run and time; what all runs share is repeated."""
    table = dataset.to_dataframe(dim_order=[d for d in ("run", "time") if d in dataset.dims])
    table = table.reset_index().rename(columns={name: BY_NAME[name].column for name in BY_NAME})
    return table[[quantity.column for quantity in ALL if quantity.column in table]]


def write_table(table: pd.DataFrame, path: Path) -> None:
    """Every digit: what is read back is the same to the last bit."""
    table.to_csv(path, index=False, lineterminator="\n")


def write_csv(dataset: xr.Dataset, path: Path) -> None:
    write_table(tabulate(dataset), path)


def write_parquet(dataset: xr.Dataset, path: Path) -> None:
    """Each field's metadata holds `units` and `long_name` as well."""
    table = pa.Table.from_pandas(tabulate(dataset), preserve_index=False)
    fields = [field.with_metadata(BY_COLUMN[field.name].attributes) for field in table.schema]
    pq.write_table(table.cast(pa.schema(fields)), path)


def write_netcdf(dataset: xr.Dataset, path: Path) -> None:
    """NetCDF 3, classic: needs no further library."""
    dataset.to_netcdf(path, engine="scipy", format="NETCDF3_64BIT")
