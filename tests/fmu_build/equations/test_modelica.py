"""The small reader of Modelica's text agrees with a full parser."""

from pathlib import Path

import pymoca.ast
import pymoca.parser
import pytest

from fmu_build.bundle import find_modelica_library
from fmu_build.equations.modelica import read_page, read_types
from tests.modelica.test_library import FILES, defined

UNITS = find_modelica_library() / "Units" / "package.mo"


def attributes(item: pymoca.ast.Class) -> dict[str, str]:
    """Text attributes that a derived type gives."""
    (clause,) = item.extends
    return {
        a.value.component.name: a.value.modifications[0].value
        for a in clause.class_modification.arguments
        if isinstance(a.value.modifications[0].value, str)
    }


def test_types_are_those_of_the_parser() -> None:
    parsed = defined(UNITS).classes
    read = read_types([str(UNITS)])
    assert {name for name in read if name.startswith("HRG.Units.")} == {
        f"HRG.Units.{name}" for name in parsed
    }
    for name, item in parsed.items():
        given = attributes(item)
        found = read[f"HRG.Units.{name}"]
        assert found.description == item.comment
        assert found.quantity == given.get("quantity", "")
        assert found.unit == given["unit"]
        assert found.display_unit == given.get("displayUnit", "")


@pytest.mark.parametrize("way", ["Inputs", "Outputs"])
def test_a_connector_has_the_type_that_it_carries(way: str) -> None:
    read = read_types([str(UNITS)])
    carried = {name: t for name, t in read.items() if name.startswith(f"HRG.Interfaces.{way}.")}
    ports = defined(UNITS.parents[1] / "Interfaces" / way / "package.mo").classes
    assert {name.rpartition(".")[2] for name in carried} == set(ports)
    for name, declared in carried.items():
        assert declared is read[f"HRG.Units.{name.rpartition('.')[2]}"]


@pytest.mark.parametrize(
    "path", FILES, ids=lambda p: str(p.relative_to(find_modelica_library().parent))
)
def test_pages_are_those_of_the_parser(path: Path) -> None:
    item = defined(path)
    read = read_page(path)
    place = path.parent if path.name == "package.mo" else path.with_suffix("")
    assert read.name == ".".join(place.relative_to(find_modelica_library().parent).parts)
    assert read.description == item.comment
    assert bool(read.info) == ("Documentation(info=" in path.read_text())
