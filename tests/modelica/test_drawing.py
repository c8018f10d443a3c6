"""The gyro is drawn: each line of its diagram runs from one connector to the other."""

import re
from itertools import pairwise
from pathlib import Path

import pytest

from fmu_build.bundle import find_modelica_library
from tests.modelica.models import defined

Box = tuple[float, float, float, float]
LIBRARY = find_modelica_library()
GYRO = LIBRARY / "Gyroscopes" / "HRGEnvelope.mo"
DECLARATION = re.compile(r"^  (?:replaceable )?[A-Z][\w.]* (\w+)", re.M)
EXTENT = re.compile(r"Placement\(transformation\(extent = \{\{(.+?), (.+?)\}, \{(.+?), (.+?)\}\}")
CONNECTION = re.compile(
    r"connect\(([\w.]+), ([\w.]+)\)\n +annotation \(Line\(points = \{\{(.+?)\}\}, color"
)
TOLERANCE = 0.3
"""Lines are rounded to 0.1, connectors to 1 of a part's icon, 0.2 to 0.6 of the diagram."""


def find_files(path: Path) -> list[Path]:
    """The class of a file and what it extends."""
    bases = [LIBRARY.joinpath(*str(e.component).split(".")) for e in defined(path).extends]
    beside = [path.parent / base.name for base in bases]
    found = [b if b.with_suffix(".mo").exists() else s for b, s in zip(bases, beside, strict=True)]
    return [path, *(file for base in found for file in find_files(base.with_suffix(".mo")))]


def read_places(path: Path) -> dict[str, Box]:
    """Extent of each component of a class that has a place."""
    places = {}
    for file in find_files(path):
        text = file.read_text()
        begins = [(m.start(), m[1]) for m in DECLARATION.finditer(text)]
        for match in EXTENT.finditer(text):
            name = [name for begin, name in begins if begin < match.start()][-1]
            left, bottom, right, top = map(float, match.groups())
            places[name] = (left, bottom, right, top)
    return places


def find_center(box: Box, inside: Box = (-100, -100, 100, 100)) -> tuple[float, float]:
    """Center of an extent of an icon in a part of this extent."""
    left, bottom, right, top = inside
    x, y = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
    return (
        left + (x + 100) / 200 * (right - left),
        bottom + (y + 100) / 200 * (top - bottom),
    )


def test_every_connection_is_drawn() -> None:
    text = GYRO.read_text()
    assert text.count("connect(") == len(CONNECTION.findall(text)) > 30


@pytest.mark.parametrize(
    "connection", CONNECTION.findall(GYRO.read_text()), ids=lambda c: f"{c[0]}-{c[1]}"
)
def test_a_line_ends_at_its_connectors(connection: tuple[str, str, str]) -> None:
    *names, points = connection
    drawn = [tuple(map(float, point.split(", "))) for point in points.split("}, {")]
    symbols = defined(GYRO).symbols
    parts = read_places(GYRO)
    for name, end in zip(names, (drawn[0], drawn[-1]), strict=True):
        component, _, port = name.partition(".")
        place = find_center(parts[component])
        if port:
            file = LIBRARY.joinpath(*str(symbols[component].type).split(".")).with_suffix(".mo")
            place = find_center(read_places(file)[port], parts[component])
        assert end == pytest.approx(place, abs=TOLERANCE)
    for (x0, y0), (x1, y1) in pairwise(drawn):
        assert x0 == x1 or y0 == y1, "a slanting line"
