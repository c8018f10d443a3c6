"""Parquet."""

import io
from pathlib import Path

import pandas as pd
import pyarrow.parquet as pq

from pyhrg.common.reading.files import read_unpacked
from pyhrg.common.reading.limits import check_size, compute_expanded_limit, refuse_unreadable


def read_parquet(path: Path) -> pd.DataFrame:
    """The table that a Parquet file holds."""
    return parse_parquet(path, read_unpacked(path))


def parse_parquet(source: object, data: bytes) -> pd.DataFrame:
    """The table of a Parquet file's bytes."""
    with refuse_unreadable(source, "Parquet"):
        shape = pq.read_metadata(io.BytesIO(data))
        cells = shape.num_rows * shape.num_columns
        check_size(source, 8 * cells, compute_expanded_limit(len(data)))
        return pd.read_parquet(io.BytesIO(data))
