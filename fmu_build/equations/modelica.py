"""Parts of a model that the Modelica compiler leaves out of its document: quantities, display
units, info pages.

A small reader of Modelica's text: types derived from Real in one line of attributes, and the
`Documentation(info="...")` annotation. The tests hold it to a full parser.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from pyhrg.common.reading.files import decode, read_bytes
from pyhrg.common.reading.limits import DOCUMENT_BYTES

STRING = r'"((?:[^"\\]|\\.)*)"'
ATTRIBUTES = r'(?:[^()"]|"[^"]*")*'
"""Attributes of a type; parentheses stand in strings alone."""


@dataclass(frozen=True)
class RealType:
    """A type derived from Real; attributes that it doesn't give are empty."""

    name: str
    description: str
    quantity: str
    unit: str
    display_unit: str


@dataclass(frozen=True)
class Page:
    """Documentation of a class: a description, and its `info` text in HTML."""

    name: str
    description: str
    info: str


def read_types(files: Iterable[str]) -> dict[str, RealType]:
    """Types of the library that Modelica files belong to, by full name; a connector that carries a
    type is known by the connector's name too."""
    types: dict[str, RealType] = {}
    connectors: dict[str, str] = {}
    present = (path for path in map(Path, set(files)) if path.exists())
    for root in sorted({find_library(path) for path in present}):
        for file in sorted(root.rglob("*.mo")):
            types |= _types(file)
            connectors |= _connectors(file)
    return types | {
        connector: declared
        for connector, name in connectors.items()
        if (declared := find_type(name, types)) is not None
    }


@cache
def list_integers(libraries: Path) -> frozenset[str]:
    """Last names of the integer parameters that the libraries in a folder declare."""
    texts = (file.read_text(encoding="utf-8") for file in sorted(libraries.rglob("*.mo")))
    return frozenset(
        name for text in texts for name in re.findall(r"\bparameter\s+Integer\s+(\w+)", text)
    )


def find_type(name: str, types: Mapping[str, RealType]) -> RealType | None:
    """The type that a name means, which may begin at any package around it."""
    return next((t for full, t in types.items() if f".{full}".endswith(f".{name}")), None)


def read_page(file: Path) -> Page:
    """The page of the class that a file holds."""
    text = decode(file, read_bytes(file, DOCUMENT_BYTES), "utf-8")
    name = file.parent.name if file.name == "package.mo" else file.stem
    head = re.search(rf"\b{name}\s+{STRING}", text)
    info = re.search(rf"Documentation\s*\(\s*info\s*=\s*{STRING}", text)
    return Page(
        name=f"{_package(text)}{name}",
        description=_plain(head.group(1)) if head else "",
        info=re.sub(r"</?html>", "", _plain(info.group(1))).strip() if info else "",
    )


@cache
def find_library(file: Path) -> Path:
    """Folder of the top-level package that a file belongs to."""
    folder = file.parent
    while (folder.parent / "package.mo").exists():
        folder = folder.parent
    return folder


def _types(file: Path) -> dict[str, RealType]:
    text = file.read_text(encoding="utf-8")
    scope = _scope(file, text)
    types = {}
    pattern = rf"\btype\s+(\w+)\s*=\s*Real\s*\(({ATTRIBUTES})\)\s*{STRING}"
    for match in re.finditer(pattern, text):
        name, attributes, description = match.groups()
        given = dict(re.findall(rf"(\w+)\s*=\s*{STRING}", attributes))
        types[f"{scope}.{name}"] = RealType(
            name=f"{scope}.{name}",
            description=_plain(description),
            quantity=given.get("quantity", ""),
            unit=given.get("unit", ""),
            display_unit=given.get("displayUnit", ""),
        )
    return types


def _connectors(file: Path) -> dict[str, str]:
    """Name of the type that each connector of a file carries."""
    text = file.read_text(encoding="utf-8")
    pattern = r"\bconnector\s+(\w+)\s*=\s*(?:input|output)\s+([\w.]+)"
    return {f"{_scope(file, text)}.{name}": carried for name, carried in re.findall(pattern, text)}


def _scope(file: Path, text: str) -> str:
    """Package in which a file's short classes stand: of a `package.mo` alone."""
    return f"{_package(text)}{file.parent.name}" if file.name == "package.mo" else ""


def _package(text: str) -> str:
    within = re.match(r"\s*within\s+([\w.]+)\s*;", text)
    return f"{within.group(1)}." if within else ""


def _plain(literal: str) -> str:
    """Text of a Modelica string literal."""
    return re.sub(r"\\(.)", r"\1", literal)
