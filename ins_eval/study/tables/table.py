"""study.parquet: the columns of `columns.py`, with their units in the metadata."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from ins_eval.study.tables.columns import COLUMNS, Column

ARROW_TYPES = {
    "int": pa.int64(),
    "text": pa.string(),
    "number": pa.float64(),
    "numbers": pa.list_(pa.float64()),
}


TABLE = "study.parquet"
ROW_GROUP_SIZE = 4096
"""Rows of a row group."""


def make_table(columns: Mapping[str, Sequence[Any]]) -> pa.Table:
    """The table from the values of all columns, by name; their metadata are `unit` and `what`.

    Raises:
        ValueError: a column is missing, unknown, or of another length.
    """
    wanted = pa.schema([_make_field(column) for column in COLUMNS])
    if differ := set(columns) ^ set(wanted.names):
        raise ValueError(f"columns: found {sorted(columns)}, differing in {sorted(differ)}")
    arrays = [pa.array(columns[field.name], field.type) for field in wanted]
    return pa.Table.from_arrays(arrays, schema=wanted)


def write_table(rows: pa.Table, path: Path) -> None:
    """Write a table; the same rows and library give the same bytes."""
    pq.write_table(rows, path, row_group_size=ROW_GROUP_SIZE)


def _make_field(column: Column) -> pa.Field:
    metadata = {"unit": column.unit, "what": column.what}
    return pa.field(column.name, ARROW_TYPES[column.kind], metadata=metadata)
