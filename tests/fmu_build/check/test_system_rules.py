"""Rules on systems (SSP): each finds what offends against it, in a system of two FMUs."""

import re
from pathlib import Path

import pytest

from fmu_build.check.system.archive import open_system
from fmu_build.check.system.importers import IMPORTERS, OWN_CONNECTORS, plan_run
from fmu_build.check.system.rules import RULES
from tests.fmu_build.check.two_fmus import STRUCTURE, VALUES, write


def find(path: Path) -> list[str]:
    with open_system(path) as system:
        return [finding for rule in RULES.values() for finding in rule(system)]


def test_a_sound_system_has_no_finding(tmp_path: Path) -> None:
    assert find(write(tmp_path)) == []


def test_importers_are_not_asked_for_connectors_of_the_system_itself(tmp_path: Path) -> None:
    own = r"<ssd:Connectors>\s*<ssd:Connector name=\"rate\".*?</ssd:Connectors>"
    without = re.sub(own, "", STRUCTURE, count=1, flags=re.DOTALL)
    for structure, expected in ((STRUCTURE, True), (without, False)):
        with open_system(write(tmp_path, structure=structure)) as system:
            asked = plan_run(system).standards
        assert (OWN_CONNECTORS in asked) is expected
    assert all(OWN_CONNECTORS not in importer.standards for importer in IMPORTERS)


@pytest.mark.parametrize(
    ("pattern", "replacement", "finding"),
    [
        (' name="two"', "", "The attribute 'name' is required but missing"),
        ("HRGPlant.fmu", "Other.fmu", "plant: there is no resources/Other.fmu"),
        ('name="electronics"', 'name="plant"', "2 components are called plant"),
        ('name="angularRate"', 'name="spin"', "plant.spin: its FMU has no such variable"),
        ('angularRate" kind="input"', 'angularRate" kind="output"', "found kind output"),
        (
            r'(angularRate".*?)ssc:Real',
            r"\1ssc:Boolean",
            "found type Boolean, the variable is Real",
        ),
        (r'(angularRate".*?)rad/s', r"\1deg/s", "found unit deg/s, the variable is in rad/s"),
        ('Connector="rate"', 'Connector="turn"', "turn is connected and is no connector"),
        ('endConnector="reference"', 'endConnector="angularRate"', "angularRate has 2 sources"),
        ('startElement="electronics"', 'startElement="plant"', "reference is of kind input and g"),
        (
            'endElement="plant"\\s+endConnector="ref.*?"',
            'endConnector="rate"',
            "rate is of kind input",
        ),
    ],
)
def test_rules_on_the_structure_find(
    tmp_path: Path, pattern: str, replacement: str, finding: str
) -> None:
    changed, count = re.subn(pattern, replacement, STRUCTURE, count=1)
    assert count == 1
    found = find(write(tmp_path, structure=changed))
    assert any(finding in f for f in found), found


@pytest.mark.parametrize(
    ("old", "new", "finding"),
    [
        ("startAngle", "endAngle", "endAngle for plant: its FMU has no such variable"),
        ('value="0.1"', 'value="1e9"', "1e9 is above its max 1000.0"),
        ("ssv:Real", "ssv:Integer", "a value of type Integer, the variable is Real"),
        ("startAngle", "reading[1]", "it is of causality output and can't be set"),
    ],
)
def test_rules_on_values_find(tmp_path: Path, old: str, new: str, finding: str) -> None:
    found = find(write(tmp_path, values=VALUES.replace(old, new)))
    assert any(finding in f for f in found), found
