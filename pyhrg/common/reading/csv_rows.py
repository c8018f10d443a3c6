"""CSV."""

import csv
import io
from collections.abc import Iterator

from pyhrg.common.reading.failures import refuse_unreadable


def parse_csv(source: object, text: str, delimiter: str = ",") -> Iterator[tuple[int, list[str]]]:
    """Number and fields of each row that has any; the number counts lines from 1."""
    reader = csv.reader(io.StringIO(text), delimiter=delimiter)
    while True:
        with refuse_unreadable(f"{source}: row {reader.line_num + 1}", "CSV"):
            row = next(reader, None)
        if row is None:
            return
        if row:
            yield reader.line_num, row
