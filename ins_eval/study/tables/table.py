"""study.parquet: columns as `columns.py` has them, their units in fields' metadata."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from ins_eval.study.tables.columns import COLUMNS, Column

KINDS = {
    "int": pa.int64(),
    "text": pa.string(),
    "number": pa.float64(),
    "numbers": pa.list_(pa.float64()),
}


TABLE = "study.parquet"
ROWS = 4096
"""Of a row group."""


def schema() -> pa.Schema:
    """Of every column, with `unit` and `what`."""
    return pa.schema([_field(column) for column in COLUMNS])


def table(columns: Mapping[str, Sequence[Any]]) -> pa.Table:
    """Rows from the columns' values, by name; exactly those of `schema`.

    Raises:
        ValueError: a column is missing, unknown, or of another length.
    """
    wanted = schema()
    if differ := set(columns) ^ set(wanted.names):
        raise ValueError(f"columns: found {sorted(columns)}, differing in {sorted(differ)}")
    arrays = [pa.array(columns[field.name], field.type) for field in wanted]
    return pa.Table.from_arrays(arrays, schema=wanted)


def write(rows: pa.Table, path: Path) -> None:
    """The same bytes of the same rows, with the same library."""
    pq.write_table(rows, path, row_group_size=ROWS)


def _field(column: Column) -> pa.Field:
    metadata = {"unit": column.unit, "what": column.what}
    return pa.field(column.name, KINDS[column.kind], metadata=metadata)
