"""Noise of a record at rest: bias and coefficients that were put in come out, with files."""

import argparse
import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import pyhrg
from pyhrg import compute_allan
from pyhrg.cli import allan
from pyhrg.common.errors import HrgError
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.gap.static_record.allan import FILES
from pyhrg.gap.static_record.record import MIN_READINGS
from pyhrg.noise.coefficients import compute_allan_deviation

N, INTERVAL, WALK, SITE_RATE = 8192, 0.1, 0.01 * DEG_PER_SQRT_H, EARTH_RATE * 0.6


@pytest.fixture
def log(tmp_path: Path) -> Path:
    """A bench log of a gyro at rest with angle random walk, without the columns of a bench."""
    steps = np.random.default_rng(5).normal(0, WALK * INTERVAL**0.5, N)
    angle = np.cumsum(SITE_RATE * INTERVAL + steps) / DEG
    frame = pd.DataFrame({"time_s": INTERVAL * np.arange(1, N + 1), "gyro_angle_deg": angle})
    path = tmp_path / "log.csv"
    frame.to_csv(path, index=False)
    return path


def test_what_was_put_in_comes_out(log: Path) -> None:
    noise = compute_allan(log)
    (gyro,) = noise.channels
    walk = gyro.noise.angle_random_walk
    assert walk.low < WALK < walk.high
    assert walk.high / walk.low < 1.2
    assert gyro.bias.low < SITE_RATE < gyro.bias.high
    assert gyro.bias.high - gyro.bias.low < 2 * DEG_PER_H
    assert (noise.deviations["unit"] == "deg/h").all()
    assert list(noise.deviations.attrs["units"]) == list(noise.deviations.columns)
    (axes,) = noise.plot()
    assert axes.get_ylabel() == "Allan deviation, deg/h"
    assert len(axes.lines) == 2
    first = noise.deviations.iloc[0]
    expected = WALK / INTERVAL**0.5 / DEG_PER_H
    assert first["low_95"] < expected < first["high_95"]
    assert noise.notes == ("table_angle_deg: missing, taken as on a gyro at rest",)


def test_gaps_and_turns_of_the_table_are_said(log: Path) -> None:
    frame = pd.read_csv(log)
    turned = np.clip(frame["time_s"] - 500, 0, 10)
    frame["table_angle_deg"] = turned
    frame["gyro_angle_deg"] += turned
    frame.drop(index=range(1000, 1100)).to_csv(log, index=False)
    noise = compute_allan(log)
    gap, turn = noise.notes[-2:]
    assert gap.startswith(
        "gaps part it into 2 stretches: only the longest is used, 110.1 to 819.2 s"
    )
    assert turn.startswith("not at rest: the table turned through 10 deg. Its angle is taken out;")
    assert noise.channels[0].bias.low < SITE_RATE < noise.channels[0].bias.high


def test_a_gap_without_an_encoder_is_no_turn(log: Path) -> None:
    pd.read_csv(log).drop(index=range(2000, 5000)).to_csv(log, index=False)
    notes = compute_allan(log).notes
    assert notes[-1].startswith("gaps part it into 2 stretches: only the longest is used, 500.1 to")


def test_a_turn_without_an_encoder_is_refused_with_its_times(log: Path) -> None:
    frame = pd.read_csv(log)
    frame["gyro_angle_deg"] += np.clip(frame["time_s"] - 500, 0, 10)
    frame.to_csv(log, index=False)
    with pytest.raises(
        HrgError, match=r"gyro turned, first at 500\.\d s, last at 519\.\d s, and no"
    ):
        compute_allan(log)


def test_gaps_that_leave_too_little_are_named(log: Path) -> None:
    frame = pd.read_csv(log)
    frame[frame.index % 1000 > 2].to_csv(log, index=False)
    with pytest.raises(
        HrgError, match=r"log\.csv: gaps part it into 9 stretches: .* 997 of 8165 rows"
    ):
        compute_allan(log)


@pytest.mark.parametrize(("creep", "said"), [(0.5, False), (3.0, True)])
def test_a_pattern_that_crept_is_said(log: Path, creep: float, said: bool) -> None:
    frame = pd.read_csv(log)
    frame["wave_angle_deg"] = np.linspace(0, creep, len(frame))
    frame.to_csv(log, index=False)
    notes = compute_allan(log).notes
    assert any(note.startswith(f"the pattern crept by {creep:g} deg") for note in notes) == said


def test_an_imu_that_moved_is_said(tmp_path: Path) -> None:
    n = 4096
    readings = np.random.default_rng(3).normal(0, 1e-4, (n, 6))
    readings[:, 5] -= 9.8
    readings[:, 1] += 4e-5
    readings[2000:2200, 2] += 0.02
    names = [
        "time_s",
        *(f"gyro_{a}_rad_s" for a in "xyz"),
        *(f"accelerometer_{a}_m_s2" for a in "xyz"),
    ]
    frame = pd.DataFrame(np.column_stack([0.1 * np.arange(1, n + 1), readings]), columns=names)
    frame.to_csv(tmp_path / "imu.csv", index=False)
    notes = compute_allan(tmp_path / "imu.csv", trusted=True).notes
    assert [note.split(": ")[:2] for note in notes] == [["gyro_z", "not at rest"]]


def test_a_rate_ramp_is_found_and_drawn(log: Path) -> None:
    """A bias that drifts is in the coefficients, and the drawn line follows the points."""
    ramp = 30 * DEG_PER_H / HOUR
    frame = pd.read_csv(log)
    frame["gyro_angle_deg"] += ramp / DEG * frame["time_s"] ** 2 / 2
    frame.to_csv(log, index=False)
    noise = compute_allan(log)
    (gyro,) = noise.channels
    assert gyro.ramp.low < ramp < gyro.ramp.high
    assert gyro.ramp.present
    assert gyro.rows[-1][2:] == ("deg/h/h", "rate_ramp_deg_h_h")
    assert noise.document["channels"]["gyro"]["rate_ramp_deg_h_h"]["value"] == pytest.approx(
        30, rel=0.1
    )
    drawn = np.hypot(
        compute_allan_deviation(gyro.deviation.tau, gyro.noise),
        gyro.ramp.value * gyro.deviation.tau / np.sqrt(2),
    )
    assert drawn[-1] == pytest.approx(gyro.deviation.deviation[-1], rel=0.1)


def test_what_is_no_log_is_refused_with_the_way_out(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="found a folder, expected a log, such as one in a campaign"):
        compute_allan(tmp_path)
    (tmp_path / "lab.csv").write_text("t_ms;rate_deg_h\n1000;9.6\n2000;9.7\n")
    with pytest.raises(HrgError, match="`hrg campaign init` reads a bench log of other columns"):
        compute_allan(tmp_path / "lab.csv")


def test_the_command_writes_what_it_says(
    log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    parser = argparse.ArgumentParser()
    allan.add_options(parser)
    out = tmp_path / "out"
    allan.run(parser.parse_args([str(log), "--out", str(out)]))
    said = capsys.readouterr().out
    assert said.endswith(f"written to {out}: {', '.join(FILES)}\n")
    assert sorted(path.name for path in out.iterdir()) == sorted(FILES)
    allan.run(parser.parse_args([str(log), "--out", str(out), "--json"]))
    document = json.loads(capsys.readouterr().out)
    assert document == json.loads((out / "allan.json").read_text())
    other = tmp_path / "other.csv"
    other.write_bytes(log.read_bytes())
    with pytest.raises(HrgError, match=r"allan\.json: another run: source: found 'log\.csv'"):
        compute_allan(other, out=out)
    compute_allan(other, out=out, force=True)
    with pytest.raises(HrgError, match=r"report\.html: found the report of another command"):
        pyhrg.run_test("fixed-position", out=out)
    (out / "allan.json").unlink()
    with pytest.raises(HrgError, match=r"report\.html: found the report of another command"):
        compute_allan(log, out=out)
    walk = document["channels"]["gyro"]["angle_random_walk_deg_sqrt_h"]
    assert walk["value"] == pytest.approx(0.01, rel=0.1)
    assert f"{N - 1} readings every 0.1 s" in (out / "report.html").read_text()


def test_a_record_that_is_too_short_is_refused(log: Path) -> None:
    text = "".join(log.read_text().splitlines(keepends=True)[:500])
    log.write_text(text)
    with pytest.raises(HrgError, match=f"498 readings, expected {MIN_READINGS} or more"):
        compute_allan(log)
