"""Labelled arrays as tables: one row a run and time, the unit in each column's name."""

from pathlib import Path

import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import xarray as xr

from ins_eval.results.quantities import ALL, BY_COLUMN, BY_NAME


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
