"""The library is standard Modelica, described throughout: read by a second, independent parser."""

from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path

import pymoca.ast
import pytest

from pyhrg.common.made_by import find_modelica
from tests.modelica.models import defined, modifiers

FILES = sorted(find_modelica().rglob("*.mo"))


def nested(item: pymoca.ast.Class) -> Iterator[pymoca.ast.Class]:
    yield item
    for child in item.classes.values():
        yield from nested(child)


def names(path: Path) -> tuple[str, ...]:
    """Of a file's class and the packages around it, from the library on."""
    place = path.parent if path.name == "package.mo" else path.with_suffix("")
    return place.relative_to(find_modelica()).parts


@pytest.mark.parametrize(("library", "used"), [("HRG", []), ("Strapdown", ["HRG"])])
def test_a_library_says_its_version_and_what_it_uses(library: str, used: list[str]) -> None:
    """The distribution's version; no library from elsewhere."""
    annotation = modifiers(defined(find_modelica() / library / "package.mo").annotation)
    assert annotation["version"].value == version("hrg")
    assert list(modifiers(annotation["uses"])) == used


@pytest.mark.parametrize("path", FILES, ids=lambda p: ".".join(names(p)))
def test_every_class_has_its_page_and_a_name_of_its_own(path: Path) -> None:
    """A class named as a package around it would hide that package from what stands beside it."""
    item = defined(path)
    info = modifiers(modifiers(item.annotation)["Documentation"])["info"].value
    assert len(info) > len("<html></html>")
    for inner in nested(item):
        assert inner.name not in names(path)[:-1]


def test_the_library_is_there() -> None:
    assert len(FILES) > 30


@pytest.mark.parametrize("path", FILES, ids=lambda p: str(p.relative_to(find_modelica())))
def test_second_parser_reads_it_and_everything_is_described(path: Path) -> None:
    for item in nested(defined(path)):
        assert item.comment, item.name
        for symbol in item.symbols.values():
            assert symbol.comment, f"{item.name}.{symbol.name}"


@pytest.mark.parametrize("folder", sorted({path.parent for path in FILES}), ids=lambda p: p.name)
def test_package_order_lists_what_is_there(folder: Path) -> None:
    """The package order is the reader's map: complete, and without ghosts."""
    listed = (folder / "package.order").read_text().split()
    assert len(listed) == len(set(listed))
    files = {path.stem for path in folder.glob("*.mo")} - {"package"}
    packages = {path.parent.name for path in folder.glob("*/package.mo")}
    inside = defined(folder / "package.mo")
    assert set(listed) == files | packages | set(inside.classes) | set(inside.symbols)
