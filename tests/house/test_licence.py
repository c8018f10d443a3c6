"""One licence, stated alike wherever a reader or a tool looks for it."""

from importlib.metadata import version
from pathlib import Path

from fmu_build.archive.licences import read_licence

ROOT = Path(__file__).parents[2]


def test_the_installed_licence_is_that_of_the_sources() -> None:
    licence = read_licence()
    assert licence.expression == "BSD-3-Clause"
    assert licence.copyright == "Copyright (c) 2026, The HRG authors"
    assert licence.text == (ROOT / "LICENSE").read_text()


def test_the_citation_says_the_same() -> None:
    lines = (ROOT / "CITATION.cff").read_text().splitlines()
    licence = read_licence()
    assert f"license: {licence.expression}" in lines
    assert f"  - name: {licence.author}" in lines
    assert f"version: {version('hrg')}" in lines
