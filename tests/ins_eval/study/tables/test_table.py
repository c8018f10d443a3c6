"""study.parquet: every column with its unit, the same bytes of the same rows."""

from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from ins_eval.study.tables import columns
from ins_eval.study.tables.columns import COLUMNS, HOURS, TRIAD

EXAMPLE = {"int": 4, "text": "car", "number": 2.5, "numbers": [1.0, 2.0]}


def rows(count: int = 3) -> dict[str, list[Any]]:
    return {column.name: [EXAMPLE[column.kind]] * count for column in COLUMNS}


def test_table_keeps_values_units_and_meanings(tmp_path: Path) -> None:
    path = tmp_path / columns.TABLE
    columns.write_table(columns.make_table(rows()), path)
    read = pq.read_table(path)
    assert read.to_pydict() == rows()
    hours = read.schema.field(HOURS).metadata
    assert hours[b"unit"] == b"h"
    assert b"navigation" in hours[b"what"]


def test_same_rows_give_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a", "b"):
        columns.write_table(
            columns.make_table(rows(2 * columns.ROW_GROUP_SIZE + 1)), tmp_path / name
        )
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()
    groups = pq.ParquetFile(tmp_path / "a").metadata
    sizes = [groups.row_group(i).num_rows for i in range(groups.num_row_groups)]
    assert sizes == [columns.ROW_GROUP_SIZE, columns.ROW_GROUP_SIZE, 1]


def test_missing_and_unknown_columns_are_refused() -> None:
    short = rows()
    del short[TRIAD]
    with pytest.raises(ValueError, match=r"differing in .'triad'."):
        columns.make_table(short)
    with pytest.raises(ValueError, match=r"differing in .'speed_m_s'."):
        columns.make_table({**rows(), "speed_m_s": [1.0] * 3})
