"""Every rule passes our FMUs and fails, by name, one that was tampered with."""

import zipfile
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
from fmpy.validation import _validate_variable_names

from fmu_build.bundle import build_fmu
from fmu_build.check import fmu_checks
from fmu_build.check.archive import open_fmu
from fmu_build.check.rules.rule import RULES
from fmu_build.check.rules.variables import STRUCTURED
from pyhrg.common.errors import HrgError
from tests.fmu_build.check.tampering import (
    Content,
    damaged,
    description,
    removed,
    tampered,
)
from tests.fmu_build.check.violations import CASES


def named(beginning: str) -> str:
    (name,) = (n for n in RULES if n.startswith(beginning))
    return name


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", RULES)
def test_our_fmu_keeps_the_rule(name: str, fmi: int) -> None:
    assert list(RULES[name](open_fmu(build_fmu(fmi=fmi)))) == []


@pytest.mark.parametrize(
    ("beginning", "fmi", "change", "finding"), CASES, ids=[f"{c[0]}, FMI {c[1]}" for c in CASES]
)
def test_a_tampered_fmu_fails_by_name(
    tmp_path: Path, beginning: str, fmi: int, change: Callable[[Content], None], finding: str
) -> None:
    fmu = open_fmu(tampered(build_fmu(fmi=fmi), tmp_path, change))
    findings = list(RULES[named(beginning)](fmu))
    assert any(finding in text for text in findings), findings


@pytest.mark.parametrize(
    ("change", "finding"),
    [
        (description('<Unit name="K/s">', '<Unit name="K/min">'), '"K/s"'),
        (description('<DisplayUnit name="deg" [^>]*>', ""), '"deg"'),
        (description('"gyroRate"', '"gyroAngle"'), '"gyroAngle"'),
        (description(' start="298.15"', ""), '"caseTemperature"'),
    ],
)
def test_fmpy_finds_what_no_rule_of_ours_does(
    tmp_path: Path, change: Callable[[Content], None], finding: str
) -> None:
    fmu = open_fmu(tampered(build_fmu(fmi=3), tmp_path, change))
    validation = next(c for c in fmu_checks.run_checks(fmu) if c.name == "FMPy validates it")
    assert any(finding in text for text in validation.findings), validation.findings


def test_names_are_those_that_fmpy_accepts() -> None:
    """One that it accepts and one that it refuses differ for each rule of the grammar."""
    right = ["a", "_a9.b[1,20].c", "der(a.b)", "der(a[3],2)", r"'odd name!'.b", r"'a\'b'[2]"]
    wrong = ["", "9a", "a.", "a[b]", "a[1", "a b", "der(a", "der(a,b)", "'a", "a-b", "é"]
    for name in [*right, *wrong]:
        variables = [SimpleNamespace(name=name, sourceline=1)]
        described = SimpleNamespace(variableNamingConvention="structured", modelVariables=variables)
        accepted = not _validate_variable_names(described)
        assert accepted == (name in right), name
        assert bool(STRUCTURED.fullmatch(name)) == accepted, name


def test_compression_that_importers_need_not_know_is_found(tmp_path: Path) -> None:
    copy = tampered(build_fmu(), tmp_path, lambda content: None)
    with zipfile.ZipFile(copy, "a", zipfile.ZIP_LZMA) as archive:
        archive.writestr("resources/table.bin", b"0" * 100)
    (finding,) = RULES[named("files are stored or deflated")](open_fmu(copy))
    assert finding == "resources/table.bin is compressed by method 14"


@pytest.mark.parametrize("name", ["documentation/index.html", "sources/core.c"])
def test_an_entry_that_is_damaged_is_found(tmp_path: Path, name: str) -> None:
    (finding,) = RULES[named("every entry")](open_fmu(damaged(build_fmu(), tmp_path, name)))
    assert finding.startswith(f"{name} in ")
    assert "found what is no intact entry" in finding


def test_every_rule_is_tested() -> None:
    others = {named("files are stored or deflated"), named("every entry")}
    assert {named(case[0]) for case in CASES} | others == set(RULES)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (removed("modelDescription.xml"), "holds no modelDescription.xml"),
        (description("</fmiModelDescription>", ""), "is no XML"),
        (description('fmiVersion="2.0"', 'fmiVersion="1.0"'), "FMI version 1.0; expected 2.0"),
    ],
)
def test_unusable_input_is_an_error(
    tmp_path: Path, change: Callable[[Content], None], words: str
) -> None:
    with pytest.raises(HrgError, match=words):
        open_fmu(tampered(build_fmu(), tmp_path, change))


def test_what_is_no_archive_is_an_error(tmp_path: Path) -> None:
    path = tmp_path / "text.fmu"
    path.write_text("no ZIP file")
    with pytest.raises(HrgError, match="is no intact ZIP file"):
        open_fmu(path)
