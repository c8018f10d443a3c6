"""JSON, TOML and XML."""

import json
import tomllib
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.failures import refuse_unreadable
from pyhrg.common.reading.files import decode, read_bytes
from pyhrg.common.reading.limits import DOCUMENT_BYTES, XML_BYTES, check_size


def read_json(path: Path, error_class: type[HrgError] = HrgError) -> dict[str, Any]:
    """The object that a JSON file holds."""
    return parse_json(path, read_bytes(path, DOCUMENT_BYTES, error_class), error_class)


def parse_json(
    source: object, data: bytes | str, error_class: type[HrgError] = HrgError
) -> dict[str, Any]:
    """The object that a JSON document is; the source names it in messages."""
    with refuse_unreadable(source, "JSON", error_class):
        values = json.loads(data)
    if not isinstance(values, dict):
        raise error_class(f"{source}: found {type(values).__name__}, expected a JSON object")
    return values


def read_toml(path: Path, error_class: type[HrgError] = HrgError) -> dict[str, Any]:
    """The table that a TOML file holds."""
    text = decode(path, read_bytes(path, DOCUMENT_BYTES, error_class), "utf-8", error_class)
    with refuse_unreadable(path, "TOML", error_class):
        return tomllib.loads(text)


def parse_xml(source: object, data: bytes, error_class: type[HrgError] = HrgError) -> ET.Element:
    """The root of an XML document."""
    check_size(source, len(data), XML_BYTES, error_class)
    with refuse_unreadable(source, "XML", error_class):
        return ET.fromstring(data)
