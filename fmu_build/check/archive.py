"""An FMU as the rules read it."""

import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.archives import open_archive
from pyhrg.common.reading.documents import parse_xml

DESCRIPTION = "modelDescription.xml"
INTERFACES = ("ModelExchange", "CoSimulation", "ScheduledExecution")

BASE_TYPES = {"Real", "Integer", "Boolean", "String", "Enumeration"}
"""Elements that hold a variable's type in FMI 2.0."""


@dataclass(frozen=True)
class Variable:
    """A variable of FMI 2.0 or 3.0: common attributes and those of its type in one."""

    kind: str
    """Base type, e.g. Real or Float64."""
    given: dict[str, str]

    @property
    def name(self) -> str:
        """As given; empty where it is missing."""
        return self.given.get("name", "")

    @property
    def reference(self) -> str:
        return self.given.get("valueReference", "")

    @property
    def causality(self) -> str:
        """With the standard's default."""
        return self.given.get("causality", "local")


@dataclass(frozen=True)
class Fmu:
    """An opened archive with its parsed description."""

    path: Path
    entries: tuple[zipfile.ZipInfo, ...]
    description: ET.Element

    @property
    def major(self) -> int:
        """Version of the standard, 2 or 3."""
        return int(self.description.get("fmiVersion", "0")[0])

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the entries, in the order of the archive."""
        return tuple(entry.filename for entry in self.entries)

    def xml(self, name: str) -> ET.Element:
        """Root of a document inside; an empty element where there is none."""
        if name not in self.names:
            return ET.Element("none")
        with open_archive(self.path) as archive:
            return parse_xml(name, archive.read(name))

    @cached_property
    def identifiers(self) -> set[str]:
        """Model identifiers of the interfaces that the FMU offers."""
        return {e.get("modelIdentifier", "") for e in self.interfaces}

    @property
    def interfaces(self) -> list[ET.Element]:
        """Elements of the interfaces that the FMU offers."""
        return [e for name in INTERFACES for e in self.description.findall(name)]

    @cached_property
    def variables(self) -> tuple[Variable, ...]:
        """All variables, in the order of the description."""
        return tuple(self._variables())

    def _variables(self) -> Iterator[Variable]:
        for element in self.description.findall("ModelVariables/*"):
            if self.major == 3:
                start = element.find("Start")
                inner = {} if start is None else {"start": start.get("value", "")}
                sizes = [self._read_size(size) for size in element.findall("Dimension")]
                if sizes:
                    inner["dimensions"] = " ".join(sizes)
                yield Variable(element.tag, {**element.attrib, **inner})
                yield from (
                    Variable(element.tag, {**element.attrib, **alias.attrib, "alias": "true"})
                    for alias in element.findall("Alias")
                )
            else:
                (inside,) = [e for e in element if e.tag in BASE_TYPES] or [ET.Element("none")]
                yield Variable(inside.tag, {**inside.attrib, **element.attrib})

    def _read_size(self, dimension: ET.Element) -> str:
        """A dimension's size at the start, which may be that of a structural parameter; 0 where it
        is neither."""
        reference = dimension.get("valueReference")
        variables = self.description.findall("ModelVariables/*")
        named = (e for e in variables if e.get("valueReference") == reference)
        return (dimension if reference is None else next(named, dimension)).get("start", "0")

    @cached_property
    def types(self) -> dict[str, dict[str, str]]:
        """Attributes of the declared types, by name."""
        types = {}
        for element in self.description.findall("TypeDefinitions/*"):
            inside = element if self.major == 3 else next(iter(element), ET.Element("none"))
            types[element.get("name", "")] = dict(inside.attrib)
        return types

    def attribute(self, variable: Variable, name: str) -> str | None:
        """A variable's attribute, or that of its declared type."""
        if name in variable.given:
            return variable.given[name]
        return self.types.get(variable.given.get("declaredType", ""), {}).get(name)


def open_fmu(path: Path) -> Fmu:
    with open_archive(path) as archive:
        entries = tuple(archive.entries)
        if DESCRIPTION not in (entry.filename for entry in entries):
            raise HrgError(f"{path} holds no {DESCRIPTION}")
        root = parse_xml(f"{DESCRIPTION} in {path}", archive.read(DESCRIPTION))
    version = root.get("fmiVersion", "none")
    if not version.startswith(("2.", "3.")):
        raise HrgError(f"{path} is of FMI version {version}; expected 2.0 or 3.0")
    return Fmu(path, entries, root)
