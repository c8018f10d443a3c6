"""A system of FMUs as the rules read it."""

import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from fmu_build.archive.ssp import SPACES
from fmu_build.check.archive import Fmu, open_fmu
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.archives import Archive, open_archive
from pyhrg.common.reading.documents import parse_xml

STRUCTURE = "SystemStructure.ssd"


@dataclass(frozen=True)
class Connector:
    """A connector of an element: its kind, and its type and unit where they are given."""

    name: str
    kind: str
    type: str | None
    unit: str | None


@dataclass(frozen=True)
class Component:
    """An element of the system; values: its parameter sets by what they are called in messages."""

    name: str
    source: str
    values: Mapping[str, ET.Element]


@dataclass(frozen=True)
class System:
    """An opened archive.

    Attributes:
        connectors: connectors of each element, by the element's name, nested systems included;
            under None those of the system itself.
        fmus: FMUs by the source that components name; missing ones are left out.
    """

    path: Path
    structure: ET.Element
    components: tuple[Component, ...]
    connectors: Mapping[str | None, Mapping[str, Connector]]
    fmus: Mapping[str, Fmu]

    @property
    def connections(self) -> list[ET.Element]:
        return self.structure.findall("ssd:System/ssd:Connections/ssd:Connection", SPACES)


@contextmanager
def open_system(path: Path) -> Iterator[System]:
    """A system whose FMUs are unpacked until the end.

    Raises:
        HrgError: the file is no system that can be read, or an FMU in it is none.
    """
    with (
        tempfile.TemporaryDirectory(prefix="hrg-check-") as folder,
        open_archive(path) as archive,
    ):
        structure = parse_xml(f"{STRUCTURE} in {path}", archive.read(STRUCTURE))
        system = structure.find("ssd:System", SPACES)
        if system is None:
            raise HrgError(f"{path}: {STRUCTURE} describes no system")
        listed = system.findall("ssd:Elements/ssd:Component", SPACES)
        components = tuple(_read_component(archive, element) for element in listed)
        connectors = {
            e.get("name"): _read_connectors(e) for e in system.findall("ssd:Elements/*", SPACES)
        }
        connectors[None] = _read_connectors(system)
        packed = {entry.filename for entry in archive.entries}
        fmus: dict[str, Fmu] = {}
        for source in {c.source for c in components} & packed:
            file = Path(folder) / f"{len(fmus)}-{PurePosixPath(source).name}"
            file.write_bytes(archive.read(source))
            fmus[source] = open_fmu(file)
        yield System(path, structure, components, connectors, fmus)


def is_system(path: Path) -> bool:
    """Whether an archive holds the description of a system."""
    with open_archive(path) as archive:
        return any(entry.filename == STRUCTURE for entry in archive.entries)


def _read_component(archive: Archive, element: ET.Element) -> Component:
    values = {}
    for binding in element.findall("ssd:ParameterBindings/ssd:ParameterBinding", SPACES):
        source = binding.get("source")
        if source is None:
            inside = binding.find("ssd:ParameterValues/ssv:ParameterSet", SPACES)
            values["values in the description"] = ET.Element("none") if inside is None else inside
        else:
            values[source] = parse_xml(source, archive.read(source))
    name, source = element.get("name", ""), element.get("source", "")
    return Component(name, source, values)


def _read_connectors(element: ET.Element) -> dict[str, Connector]:
    connectors = {}
    for connector in element.findall("ssd:Connectors/ssd:Connector", SPACES):
        name = connector.get("name", "")
        typed = [e for e in connector if e.tag.startswith(f"{{{SPACES['ssc']}}}")]
        kind = _strip(typed[0].tag) if typed else None
        unit = typed[0].get("unit") if typed else None
        connectors[name] = Connector(name, connector.get("kind", ""), kind, unit)
    return connectors


def list_values(parameters: ET.Element) -> Iterator[tuple[str, str, str]]:
    """Name, type and value of a set's parameters."""
    for parameter in parameters.findall("ssv:Parameters/ssv:Parameter", SPACES):
        for value in parameter:
            yield parameter.get("name", ""), _strip(value.tag), value.get("value", "")


def _strip(tag: str) -> str:
    return tag.rpartition("}")[2]
