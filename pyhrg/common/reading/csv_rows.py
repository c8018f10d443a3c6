"""CSV."""

import csv
from collections.abc import Iterator

from pyhrg.common.reading.failures import refuse_unreadable


def parse_csv(source: object, text: str, delimiter: str = ",") -> Iterator[tuple[int, list[str]]]:
    """Number and fields of each row that has any; the number counts lines from 1."""
    reader = csv.reader(iterate_lines(text), delimiter=delimiter)
    while True:
        with refuse_unreadable(f"{source}: row {reader.line_num + 1}", "CSV"):
            row = next(reader, None)
        if row is None:
            return
        if row:
            yield reader.line_num, row


def iterate_lines(text: str) -> Iterator[str]:
    """Lines of a text with their ends, one at a time: a copy of a large text costs memory."""
    begin = 0
    while begin < len(text):
        end = text.find("\n", begin) + 1 or len(text)
        yield text[begin:end]
        begin = end
