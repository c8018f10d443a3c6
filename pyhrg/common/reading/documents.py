"""JSON, TOML, XML and CSV."""

import csv
import json
import tomllib
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.files import decode, read_bytes
from pyhrg.common.reading.limits import DOCUMENT_BYTES, XML_BYTES, check_size, refuse_unreadable


def read_json(path: Path) -> dict[str, Any]:
    """The object that a JSON file holds."""
    return parse_json(path, read_bytes(path, DOCUMENT_BYTES))


def parse_json(source: object, data: bytes | str) -> dict[str, Any]:
    """The object that a JSON document is; the source names it in messages."""
    with refuse_unreadable(source, "JSON"):
        values = json.loads(data)
    if not isinstance(values, dict):
        raise HrgError(f"{source}: found {type(values).__name__}, expected a JSON object")
    return values


def read_toml(path: Path) -> dict[str, Any]:
    """The table that a TOML file holds."""
    text = decode(path, read_bytes(path, DOCUMENT_BYTES), "utf-8")
    with refuse_unreadable(path, "TOML"):
        return tomllib.loads(text)


def parse_xml(source: object, data: bytes) -> ET.Element:
    check_size(source, len(data), XML_BYTES)
    with refuse_unreadable(source, "XML"):
        return ET.fromstring(data)


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
