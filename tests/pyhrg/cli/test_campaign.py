"""`hrg campaign import`, as documented."""

import re
from pathlib import Path

import pytest

from pyhrg.common.cli import main
from pyhrg.common.units import DEG
from pyhrg.records import campaign

PAGE = Path(__file__).parents[3] / "docs" / "import.md"


def block(kind: str) -> str:
    """The first code block of a kind on the page."""
    found = re.search(rf"```{kind}\n(.*?)```", PAGE.read_text(), re.DOTALL)
    assert found
    return found[1]


@pytest.fixture
def mapping(tmp_path: Path) -> Path:
    (tmp_path / "table.csv").write_text(block("csv"))
    (tmp_path / "mapping.toml").write_text(block("toml"))
    return tmp_path / "mapping.toml"


def run(*arguments: str | Path) -> int:
    return main(["campaign", "import", *map(str, arguments)])


def test_example_is_understood_as_documented(
    mapping: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(mapping, "--check") == 0
    said = capsys.readouterr().out
    documented = (
        PAGE.read_text().split("$ hrg campaign import mapping.toml --check\n")[1].split("```")[0]
    )
    assert said == documented
    assert sorted(path.name for path in mapping.parent.iterdir()) == ["mapping.toml", "table.csv"]


def test_example_is_imported(mapping: Path) -> None:
    out = mapping.parent / "a" / "campaign"
    assert run(mapping, "--out", out) == 0
    test = campaign.read_campaign(out).tests[0]
    assert (test.id, test.kind, test.log.interval) == ("rate_pos", "rate", 0.5)
    assert test.log.table_angle / DEG == pytest.approx([0, 0.2, 0.4, 0.6])
    assert test.log.gyro_angle[-1] / DEG == pytest.approx(0.6054)


def test_what_is_there_is_not_replaced(mapping: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(mapping, "--out", mapping.parent) == 2
    assert "found something there, expected nothing yet" in capsys.readouterr().err
    assert mapping.exists()


@pytest.mark.parametrize(("old", "new"), [("0,4027", "0,4O27"), ("Omega", "Omicron")])
def test_an_error_is_one_line_and_writes_nothing(
    mapping: Path, capsys: pytest.CaptureFixture[str], old: str, new: str
) -> None:
    file = mapping.parent / "table.csv"
    file.write_text(file.read_text().replace(old, new))
    assert run(mapping, "--out", mapping.parent / "campaign") == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert sorted(path.name for path in mapping.parent.iterdir()) == ["mapping.toml", "table.csv"]


def test_it_is_written_or_checked(mapping: Path) -> None:
    with pytest.raises(SystemExit):
        run(mapping)


def test_what_a_diagnosis_would_refuse_is_said(
    mapping: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    turned = mapping.read_text().replace('"mrad"', '"mrad", scale = -1')
    mapping.write_text(turned)
    assert run(mapping, "--check") == 0
    said = capsys.readouterr().out.splitlines()[-1]
    assert said.startswith("a diagnosis would refuse it: 1 of 1 logs, as table.csv: columns gyro")
