"""`hrg campaign init`: drafts of mappings from the headers of logs."""

import tomllib
from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pyhrg import import_campaign
from pyhrg.common.cli import main
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG
from pyhrg.records.campaign_import import draft_mapping
from tests.pyhrg.cli.test_campaign import run, write_example


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
    assert [test["id"] for test in draft["tests"]] == ["rateplus5_1", "rateplus5_2", "rate-5"]
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


def test_the_documented_example_is_drafted(tmp_path: Path) -> None:
    """A clock's times, a row of units below the names, a decimal comma."""
    mapping = write_example(tmp_path)
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


HEADERS = {
    "german": "Zeit [s];Drehtisch [°];Ausgang [°];Wellenwinkel [°];Amplitudenkraft [1/s];"
    "Quadraturkraft [1/s];Frequenz [Hz];Gehäusetemperatur [°C]",
    "short": "t [s];enc [deg];out [deg];theta [deg];F_amp [1/s];"
    "F_Q [1/s];f [Hz];T case [degC];A [V]",
    "no_table": "t [s];T_room [C];Gyro out [deg];Pattern angle [deg];F_A [1/s];"
    "Quad [1/s];f [Hz];T [C]",
}
CELLS = "0.2;1e-3;2e-3;4711.3;23.5;1.25"


def test_other_names_of_a_laboratory_are_known(tmp_path: Path) -> None:
    """Output and pattern, forces in 1/s that are no amplitude, volts, a case between two
    thermometers, an output from 17 deg, a frequency that is that of the drafted nominal value."""
    logs = [tmp_path / f"{name}.csv" for name in HEADERS]
    for path, header in zip(logs, HEADERS.values(), strict=True):
        width = len(header.split(";"))
        rows = [";".join(f"{i + 1};0;{17 + i};{CELLS}".split(";")[:width]) for i in range(3)]
        path.write_text("\n".join([header, *rows]))
    text = draft_mapping(logs, tmp_path)
    draft = tomllib.loads(text)
    assert draft["nominal"]["frequency_Hz"] == 4710.0
    for test, header in zip(draft["tests"], HEADERS.values(), strict=True):
        columns = {**draft["columns"], **test["columns"]}
        names = [part for part in header.split(";") if part != "T_room [C]"]
        stems = ["time", "table_angle", "gyro_angle", "wave_angle", "amplitude_force"]
        stems += ["quadrature_force", "frequency_offset", "temperature", "amplitude"]
        if test["id"] == "no_table":
            stems.remove("table_angle")
        drafted = {stem: own["column"] for stem, own in columns.items() if isinstance(own, dict)}
        assert drafted == dict(zip(stems, names, strict=False))
        assert columns["gyro_angle"]["from_zero"]
        assert columns["frequency_offset"]["offset"] == -4710
    assert text.count("from_zero = true }   # guessed: it begins far from zero") == 3


def test_a_guess_by_a_word_of_many_is_marked(tmp_path: Path) -> None:
    """An angle of anything, and the temperature of anything."""
    (tmp_path / "log.csv").write_text("t [s],Winkel [deg],Raumtemperatur [C]\n1,0.1,20\n2,0.2,20\n")
    text = draft_mapping([tmp_path / "log.csv"], tmp_path)
    assert "gyro_angle = { column = 'Winkel [deg]', unit = \"deg\" }   # guessed" in text
    assert "column = 'Raumtemperatur [C]', unit = \"degC\" }   # guessed" in text


def test_a_log_without_a_header_is_not_drafted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "log.csv").write_text("1,2\n3,4\n")
    out = tmp_path / "mapping.toml"
    assert main(["campaign", "init", str(tmp_path / "log.csv"), "--out", str(out)]) == 2
    assert "found no row of names above the values" in capsys.readouterr().err
    assert not out.exists()


@pytest.mark.parametrize(
    "form", ["%H:%M:%S", "%d.%m.%Y %H:%M:%S", "%Y-%m-%dT%H:%M:%S", "%d.%m.%Y %H:%M:%S,%f"]
)
def test_clocks_of_a_night_are_read(tmp_path: Path, form: str) -> None:
    """Twenty minutes about midnight, in the encoding of a German Windows."""
    begin = datetime(2024, 3, 5, 23, 50)
    rows = ["Stempel;Winkel [°];Muster [°]"]
    for i in range(120):
        clock = (begin + timedelta(seconds=10 * i)).strftime(form)
        rows.append(f"{clock};{0.03 * i:.2f};{-0.01 * i:.2f}")
    (tmp_path / "nacht.csv").write_text("\n".join(rows), encoding="cp1252")
    out = tmp_path / "mapping.toml"
    assert main(["campaign", "init", str(tmp_path / "nacht.csv"), "--out", str(out)]) == 0
    fill_in(out)
    log = import_campaign(out).campaign.tests[0].log
    assert log.time == pytest.approx(10.0 * np.arange(1, 121))
    assert log.gyro_angle[-1] / DEG == pytest.approx(0.03 * 119)


@pytest.mark.parametrize(
    ("text", "refusal"),
    [
        ("t [s],gyro [deg]\n1,0.1\n2,0.2\n", "columns.wave_angle: found 'edit'"),
        ("t [s],x,pattern [deg]\n1,7,0.1\n2,7,0.2\n", "columns.gyro_angle: found 'edit'"),
        ("t,gyro [deg],pattern [deg]\n3/5/24 1:02:03,1,1\n3/5/24 1:02:04,1,1\n", "time.format"),
    ],
)
def test_what_is_not_found_is_to_be_edited(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, refusal: str
) -> None:
    (tmp_path / "log.csv").write_text(text)
    out = tmp_path / "mapping.toml"
    assert main(["campaign", "init", str(tmp_path / "log.csv"), "--out", str(out)]) == 0
    fill_in(out)
    assert run(out, "--check") == 2
    assert refusal in capsys.readouterr().err


def test_logs_in_volts_share_one_scale(tmp_path: Path) -> None:
    """Of the longest steady log, also where a sweep of the amplitude begins near 1; quadrature
    forces in volts have it too. Words of the drive, a wrapped pattern angle, a commanded rotation
    and attitudes by accelerometers are found."""
    t = np.arange(1, 400)
    frame = pd.DataFrame({"t_ms": 1000 * t, "out_deg": 2.5 * t, "F_quad_V_s": 2e-3, "drive": "ON"})
    frame["pattern_deg_wrapped"] = (100 - 0.277 * frame.out_deg) % 180
    frame["ampl_V"] = 1.27 + 1e-6 * np.random.default_rng(1).standard_normal(len(t))
    frame.loc[300:, "drive"] = "OFF"
    sweep = frame.iloc[:100].assign(ampl_V=1.016, Aset_V=1.016, acc_z_g=1.0)
    short = frame.iloc[:50].assign(ampl_V=1.2701, Vcmd_dps=1.0, out_deg=0.0)
    short["pattern_deg_wrapped"] = 100 + 0.277 * t[:50]
    for name, part in (("rest", frame), ("SN7_VR_pos", short), ("drive_cycle", sweep)):
        part.to_csv(tmp_path / f"{name}.csv", index=False)
    logs = [tmp_path / f"{name}.csv" for name in ("rest", "SN7_VR_pos", "drive_cycle")]
    (tmp_path / "mapping.toml").write_text(draft_mapping(logs, tmp_path))
    fill_in(tmp_path / "mapping.toml")
    imported = import_campaign(tmp_path / "mapping.toml").campaign
    rest, rotation, cycle = imported.tests
    assert (rotation.kind, cycle.kind, cycle.role) == ("virtual_rotation", "manoeuvre", "holdout")
    assert np.median(rest.log.amplitude) == pytest.approx(1, abs=1e-8)
    assert rotation.log.amplitude[0] == pytest.approx(1.2701 / 1.27, abs=1e-6)
    assert cycle.log.amplitude_setpoint[0] == pytest.approx(0.8, abs=1e-6)
    assert cycle.log.quadrature_force[0] == pytest.approx(2e-3 / 1.27)
    assert not cycle.log.has_values("axis_up")
    assert rest.log.drive_on[[0, -1]] == pytest.approx([1, 0])
    assert np.ptp(rest.log.wave_angle) / DEG == pytest.approx(0.277 * 2.5 * 398)
    assert rotation.log.virtual_rotation[0] == pytest.approx(DEG)
    assert imported.tolerances == dict.fromkeys(
        ("amplitude_scale", "amplitude_force_scale", "quadrature_force_scale"), 0.01
    )


def test_numbers_and_words_for_nothing_are_missing_values(tmp_path: Path) -> None:
    """Nines far beyond a column's other values; 999 deg on the way of an angle are a value."""
    rows = [[t, 9.99 * t, -2.77 * t, 20] for t in range(1, 120)]
    rows[5][3], rows[6][3], rows[7][2] = -9999, "n/a", "-9999.0"
    text = "".join(f"{','.join(map(str, row))}\n" for row in rows)
    (tmp_path / "log.csv").write_text("t [s],gyro [deg],pattern [deg],T [C]\n" + text)
    draft = draft_mapping([tmp_path / "log.csv"], tmp_path)
    assert "missing = ['-9999', '-9999.0', 'n/a']   # guessed: no value" in draft
    (tmp_path / "mapping.toml").write_text(draft)
    fill_in(tmp_path / "mapping.toml")
    log = import_campaign(tmp_path / "mapping.toml").campaign.tests[0].log
    assert np.flatnonzero(np.isnan(log.temperature)).tolist() == [5, 6]
    assert np.flatnonzero(np.isnan(log.wave_angle)).tolist() == [7]
    assert np.max(log.gyro_angle) / DEG > 999


def test_a_log_that_begins_again_is_refused(tmp_path: Path) -> None:
    seconds = [*range(1, 50), *range(1, 40)]
    rows = "".join(f"{t},0.1,{i}\n" for i, t in enumerate(seconds))
    (tmp_path / "log.csv").write_text("t [s],gyro [deg],pattern [deg]\n" + rows)
    (tmp_path / "mapping.toml").write_text(draft_mapping([tmp_path / "log.csv"], tmp_path))
    fill_in(tmp_path / "mapping.toml")
    with pytest.raises(HrgError, match=r"row 51, .*1 after 49: the log begins again"):
        import_campaign(tmp_path / "mapping.toml")
