"""`hrg campaign import`, as documented."""

import re
import tomllib
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
from pyhrg.records.campaign_import import draft_mapping

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
    assert (
        "warning: a diagnosis would refuse these records: campaign.json: nominal.c"
        in capsys.readouterr().err
    )


def fill_in(draft: Path) -> None:
    """Give what only the laboratory knows."""
    draft.write_text(draft.read_text().replace('latitude_deg = "edit"', "latitude_deg = 45.0"))


def test_a_draft_of_guesses_is_accepted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    t = np.arange(1, 300)
    columns = {"t [s]": t, "Omega_deg": 0.003 * t, "Theta (mrad)": -4.83 * 0.003 * t, "T": 21}
    frame = pd.DataFrame({**columns, "remark": "x"})
    rates = frame.rename(columns={"Omega_deg": "gyro_rate_deg_s"}).assign(gyro_rate_deg_s=0.003)
    for name, part in (("still", frame), ("rate_1", rates)):
        part.to_csv(tmp_path / f"{name}.csv", sep=";", decimal=",", index=False)
    out = tmp_path / "draft" / "mapping.toml"
    out.parent.mkdir()
    logs = [str(tmp_path / name) for name in ("still.csv", "rate_1.csv")]
    assert main(["campaign", "init", *logs, "--out", str(out)]) == 0
    assert f"hrg campaign import {out} --check" in capsys.readouterr().out
    draft = tomllib.loads(out.read_text())
    _, rate = draft["tests"]
    assert draft["layout"] == {"separator": "semicolon", "decimal": "comma", "comment": "#"}
    assert draft["columns"]["wave_angle"] == {"column": "Theta (mrad)", "unit": "mrad"}
    assert draft["columns"]["temperature"] == {"column": "T", "unit": "degC"}
    assert (rate["kind"], rate["columns"]["gyro_angle"]["integrate"]) == ("rate", "means")
    assert "# not used: remark" in out.read_text()
    assert run(out, "--check") == 2
    assert "site.latitude_deg: found 'edit', expected a number" in capsys.readouterr().err
    fill_in(out)
    assert run(out, "--check") == 0
    assert main(["campaign", "init", *logs, "--out", str(out)]) == 2
    assert "found a file, expected none" in capsys.readouterr().err


def test_a_draft_of_another_laboratorys_logs_needs_no_edit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Names, units, marks and file names of a laboratory; a clock that runs, an encoder that jumps
    by a turn, volts, the loop's frequency itself; one log lacks most columns."""
    t = np.arange(1, 200)
    turned = 5 * (t + 0.003 * t)
    frame = pd.DataFrame({"t_ms": 51_000 + 1000 * t, "enc_deg": (300 + 5 * t) % 360, "T_C": 25})
    frame["out_arcsec"], frame["theta_mrad"] = 3600 * turned, -0.277 * np.radians(turned) * 1e3
    frame["amp_V"], frame["Fa_1/h"], frame["f_Hz"] = 1.25, 8.0, 7000.1
    for name, part in (("rate+5 1", frame), ("rate-5", frame), ("rate+5.2", frame.iloc[:, [0, 3]])):
        text = "% turntable 3\nsecond line\n" + part.to_csv(sep=";", index=False)
        (tmp_path / f"{name}.csv").write_text(text)
    out = tmp_path / "mapping.toml"
    assert (
        main(["campaign", "init", *map(str, sorted(tmp_path.glob("*.csv"))), "--out", str(out)])
        == 0
    )
    draft = tomllib.loads(out.read_text())
    assert [test["id"] for test in draft["tests"]] == ["rate_5_1", "rate_5_2", "rate-5"]
    assert "absent" in draft["tests"][1]
    assert "not used" not in out.read_text().partition("[layout]")[2]
    fill_in(out)
    imported = import_campaign(out).campaign
    whole, short = (test.log for test in imported.tests[:2])
    assert whole.time[0] == 1.0
    assert whole.table_angle / DEG == pytest.approx(5 * (t - 1))
    earth = imported.site.compute_earth_rate(1.0) / DEG
    assert whole.gyro_angle / DEG == pytest.approx(turned - turned[0] + earth)
    assert whole.wave_angle == pytest.approx(-0.277 * np.radians(turned))
    assert whole.temperature[0] == 298.15
    assert whole.amplitude[0] == 1.0
    assert whole.amplitude_force[0] == pytest.approx(8 / 3600)
    assert whole.frequency_offset[0] == pytest.approx(0.1 * 2 * np.pi)
    assert not short.has_values("table_angle")


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


def test_the_documented_example_is_drafted(mapping: Path) -> None:
    """A clock's times, a row of units below the names, a decimal comma."""
    out = mapping.parent / "draft.toml"
    assert main(["campaign", "init", str(mapping.parent / "table.csv"), "--out", str(out)]) == 0
    fill_in(out)
    drafted, stated = (import_campaign(path).campaign.tests[0].log for path in (out, mapping))
    for field in ("time", "temperature", "gyro_angle", "wave_angle", "axis_up", "drive_on"):
        np.testing.assert_array_equal(getattr(drafted, field), getattr(stated, field), field)
    assert drafted.table_angle == pytest.approx(stated.table_angle)


def test_a_kind_is_guessed_by_the_table_and_times_by_their_evenness(tmp_path: Path) -> None:
    seconds = np.arange(1.0, 401.0)
    turned = {"rest": 0 * seconds, "eins": 5.0 * seconds, "zwei": 20.0 * (seconds // 50)}
    for name, angle in turned.items():
        frame = pd.DataFrame({"n [s]": seconds, "Musterwinkel [deg]": -0.277 * angle})
        frame["Drehtisch [deg]"], frame["Winkel [deg]"] = angle % 360, angle
        frame.to_csv(tmp_path / f"{name}.csv", index=False)
    (tmp_path / "untimed.csv").write_text("gyro\n1\n2\n")
    logs = [tmp_path / f"{name}.csv" for name in (*turned, "untimed")]
    draft = tomllib.loads(draft_mapping(logs, tmp_path))
    assert [test["kind"] for test in draft["tests"]] == ["static", "rate", "positions", "static"]
    assert draft["columns"]["time"] == {"column": "n [s]", "unit": "s"}
    assert draft["columns"]["wave_angle"]["column"] == "Musterwinkel [deg]"
    assert [test.get("interval_s") for test in draft["tests"]] == [None, None, None, "edit"]


def test_a_log_without_a_header_is_not_drafted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "log.csv").write_text("1,2\n3,4\n")
    out = tmp_path / "mapping.toml"
    assert main(["campaign", "init", str(tmp_path / "log.csv"), "--out", str(out)]) == 2
    assert "found no row of names above the values" in capsys.readouterr().err
    assert not out.exists()


def test_a_table_that_turned_is_not_taken_to_rest(recorded_campaign: Path) -> None:
    given = campaign.read_campaign(recorded_campaign)
    tests = [test for test in given.tests if test.kind == "ring_down"]
    absent = [np.full(len(test.log.time), np.nan) for test in tests]
    pairs = zip(tests, absent, strict=True)
    spoilt = tuple(replace(t, recording=replace(t.log, table_angle=angle)) for t, angle in pairs)
    with pytest.raises(LogError, match="column table_angle_deg is missing"):
        run_test("ring-down", campaign=replace(given, tests=spoilt))


def test_a_spreadsheet_is_refused_in_words(
    mapping: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (mapping.parent / "table.csv").write_bytes(b"PK\x03\x04\x14\x00\xff")
    assert run(mapping, "--check") == 2
    assert "found a spreadsheet (Excel) or an archive" in capsys.readouterr().err
