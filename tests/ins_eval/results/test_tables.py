"""Tables hold the labelled arrays' numbers, to the last bit."""

from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest
import xarray as xr
from pyarrow import csv

from ins_eval.results import flights
from ins_eval.results.quantities import ALL, BY_COLUMN
from tests.ins_eval.results.cases import ROWS, dataset


@pytest.fixture(params=[1, 3])
def data(request: pytest.FixtureRequest) -> xr.Dataset:
    return dataset(runs=request.param)


def assert_same(table: pd.DataFrame, data: xr.Dataset) -> None:
    assert list(table.columns) == [quantity.column for quantity in ALL]
    assert len(table) == ROWS * data.sizes["run"]
    for column, quantity in BY_COLUMN.items():
        expected = data[quantity.name].broadcast_like(data["north_error"])
        expected = expected.transpose("run", "time").values.ravel()
        np.testing.assert_array_equal(table[column], expected, err_msg=column)


def test_csv_round_trip(data: xr.Dataset, tmp_path: Path) -> None:
    flights.write_csv(data, tmp_path / "flights.csv")
    assert_same(csv.read_csv(tmp_path / "flights.csv").to_pandas(), data)


def test_parquet_round_trip_with_units_in_each_field(data: xr.Dataset, tmp_path: Path) -> None:
    path = tmp_path / "flights.parquet"
    flights.write_parquet(data, path)
    assert_same(pd.read_parquet(path), data)
    for field in pq.read_schema(path):
        assert field.metadata[b"units"].decode() == BY_COLUMN[field.name].unit


def test_netcdf_round_trip(data: xr.Dataset, tmp_path: Path) -> None:
    path = tmp_path / "flights.nc"
    flights.write_netcdf(data, path)
    with xr.open_dataset(path, engine="scipy", decode_times=False) as read:
        xr.testing.assert_identical(read.load(), data)


def test_columns_name_their_units() -> None:
    names = flights.tabulate(dataset()).columns
    for name in ("time_s", "north_error_m", "heading_error_deg", "velocity_east_m_s", "run"):
        assert name in names


def test_same_flights_same_bytes(data: xr.Dataset, tmp_path: Path) -> None:
    for write, name in (
        (flights.write_csv, "a.csv"),
        (flights.write_parquet, "a.parquet"),
        (flights.write_netcdf, "a.nc"),
    ):
        write(data, tmp_path / name)
        first = (tmp_path / name).read_bytes()
        write(data, tmp_path / name)
        assert (tmp_path / name).read_bytes() == first
