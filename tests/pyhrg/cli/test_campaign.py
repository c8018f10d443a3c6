"""`hrg campaign import`, as documented."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pyhrg import import_campaign, run_test
from pyhrg.common.cli import main
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG
from pyhrg.records import LogError, campaign

PAGE = Path(__file__).parents[3] / "docs" / "import.md"


def block(kind: str) -> str:
    """The first code block of a kind on the page."""
    found = re.search(rf"```{kind}\n(.*?)```", PAGE.read_text(), re.DOTALL)
    assert found
    return found[1]


def write_example(folder: Path) -> Path:
    (folder / "table.csv").write_text(block("csv"))
    (folder / "mapping.toml").write_text(block("toml"))
    return folder / "mapping.toml"


@pytest.fixture
def mapping(tmp_path: Path) -> Path:
    return write_example(tmp_path)


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
    assert "mapping.toml, which is no part of a campaign" in capsys.readouterr().err
    assert run(mapping, "--out", mapping.parent, "--force") == 2
    assert mapping.exists()
    out = mapping.parent / "campaign"
    assert run(mapping, "--out", out) == 0
    mapping.write_text(mapping.read_text().replace("latitude_deg = 39.9", "latitude_deg = 45"))
    assert run(mapping, "--out", out) == 2
    assert "found a campaign there; choose another folder, or" in capsys.readouterr().err
    assert run(mapping, "--out", out, "--force") == 0
    assert campaign.read_campaign(out).site.latitude_deg == pytest.approx(45)


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
    said = capsys.readouterr().out
    assert "\na diagnosis would refuse it: 1 of 1 logs, as table.csv: columns gyro" in said


def test_noise_that_nothing_tells_is_said(
    mapping: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mapping.write_text(re.sub(r"angle_random_walk.*", "", mapping.read_text()))
    assert run(mapping, "--check") == 0
    said = capsys.readouterr().out
    assert "\na diagnosis would refuse it: campaign.json: nominal: states no noise of the" in said
    assert "Not at rest: 3 on a table that turns at 0.0057 deg/s or faster, 1 in stretch" in said


def test_a_log_with_the_gyros_columns_alone_is_imported_and_benched(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A static record of two hours, and the same under a kind that no test reads."""
    seconds = np.arange(1.0, 7201.0)
    angle = np.degrees(EARTH_RATE * np.sin(39.9 * DEG) * seconds)
    angle += np.random.default_rng(1).normal(0, 1e-6, len(seconds))
    frame = pd.DataFrame({"t": seconds, "gyro": angle, "pattern": -0.277 * angle})
    frame.to_csv(tmp_path / "log.csv", index=False)
    entry = """
[[tests]]
id = "{kind}"
kind = "{kind}"
role = "fit"
file = "log.csv"
"""
    columns = """
[columns]
time = { column = "t", unit = "s" }
axis_up = 1
gyro_angle = { column = "gyro", unit = "deg" }
wave_angle = { column = "pattern", unit = "deg" }
"""
    head = re.sub(r"\[layout\].*", "", block("toml"), flags=re.DOTALL)
    text = head + columns + entry.format(kind="static") + entry.format(kind="drehrate")
    (tmp_path / "mapping.toml").write_text(text)
    assert run(tmp_path / "mapping.toml", "--check") == 0
    said = capsys.readouterr().out
    assert "the bench can run: fixed-position, random-walk\n  not self-calibration: " in said
    assert "drehrate: no bench test reads the kind drehrate; expected one such as rate" in said
    assert run(tmp_path / "mapping.toml", "--out", tmp_path / "campaign") == 0
    result = run_test("fixed-position", campaign=tmp_path / "campaign")
    assert any("table_angle_deg, virtual_rotation_deg_s" in x for x in result.outcome.exclusions)
    assert abs(result.findings.value["bias_deg_per_h"]) < 1e-3
    (tmp_path / "mapping.toml").write_text(text.replace('"pattern", ', '"pattern", scale = -1, '))
    assert run(tmp_path / "mapping.toml", "--out", tmp_path / "turned") == 0
    capsys.readouterr()
    bench = ["bench", "fixed-position", "--campaign", tmp_path / "turned", "--out", tmp_path / "b"]
    assert main([*map(str, bench)]) == 0
    said = "a diagnosis would refuse these records: campaign.json: nominal.c"
    assert f"Record: static.csv.gz: {said}" in capsys.readouterr().out
    assert said in (tmp_path / "b" / "report.html").read_text()
    assert said in (tmp_path / "b" / "fixed-position" / "result.json").read_text()


@pytest.mark.parametrize("gyro", ["", ", from_zero = true"])
def test_origins_that_contradict_each_other_are_said(
    mapping: Path, capsys: pytest.CaptureFixture[str], gyro: str
) -> None:
    """A log that begins while the table turns: a table from zero beside an output that is not."""
    t = 0.5 * np.arange(1, 5)
    turned = 5 * t + 100
    frame = pd.DataFrame({"t": t, "table": turned, "out": turned + 7, "pattern": -0.277 * turned})
    frame.to_csv(mapping.parent / "table.csv", index=False)
    head = re.sub(r"\[layout\].*", "", block("toml"), flags=re.DOTALL)
    columns = f"""
[columns]
axis_up = 1
time = {{ column = "t", unit = "s" }}
table_angle = {{ column = "table", unit = "deg", from_zero = true }}
gyro_angle = {{ column = "out", unit = "deg"{gyro} }}
wave_angle = {{ column = "pattern", unit = "deg" }}
[[tests]]
id = "rate"
kind = "rate"
role = "fit"
file = "table.csv"
"""
    mapping.write_text(head + columns)
    log = import_campaign(mapping).campaign.tests[0].log
    assert run(mapping, "--check") == 0
    said = "gyro_angle begins 109.499 deg beside table_angle" in capsys.readouterr().out
    assert said == (not gyro)
    if gyro:
        earth = EARTH_RATE * np.sin(39.9 * DEG)
        assert log.gyro_angle[0] - log.table_angle[0] == pytest.approx(0.5 * earth)


def test_a_table_that_turned_is_not_taken_to_rest(recorded_campaign: Path) -> None:
    given = campaign.read_campaign(recorded_campaign)
    tests = [test for test in given.tests if test.kind == "rate"]
    absent = [np.full(len(test.log.time), np.nan) for test in tests]
    pairs = zip(tests, absent, strict=True)
    spoilt = tuple(replace(t, recording=replace(t.log, table_angle=angle)) for t, angle in pairs)
    with pytest.raises(LogError, match="column table_angle_deg is missing"):
        run_test("rate-reversal", campaign=replace(given, tests=spoilt))


def test_a_spreadsheet_is_refused_in_words(
    mapping: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (mapping.parent / "table.csv").write_bytes(b"PK\x03\x04\x14\x00\xff")
    assert run(mapping, "--check") == 2
    assert "found a spreadsheet (Excel) or an archive" in capsys.readouterr().err
