"""The gallery of the documentation: each picture is shown, is made by a command, and is small."""

import re

import pyhrg
from benchmarks.gallery import GALLERY, PICTURES

MAX_BYTES = 80_000
"""Size of a picture from which the repository would grow too fast."""


def test_every_picture_is_shown_and_made() -> None:
    tests = set(pyhrg.list_tests()["name"])
    there = {path.stem for path in GALLERY.glob("*.png")}
    text = "".join(page.read_text(encoding="utf-8") for page in GALLERY.glob("*.md"))
    shown = set(re.findall(r"!\[[^]]+\]\(([\w-]+)\.png\)", text))
    assert there == shown == tests | set(PICTURES)


def test_pictures_are_small() -> None:
    sizes = {path.name: path.stat().st_size for path in GALLERY.glob("*.png")}
    assert {name: size for name, size in sizes.items() if size > MAX_BYTES} == {}
