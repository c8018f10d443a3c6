"""Files in, files out; recorded logs where they are at hand."""

import json
import os
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.gap.static_record import diagnose_record
from pyhrg.gap.static_record.belief import Belief, parse_belief, read_beliefs
from pyhrg.gap.static_record.record import (
    Channel,
    StaticRecord,
    channel_from_increments,
    find_quantization_step,
)
from pyhrg.gap.static_record.record import (
    read_static_record as read_record,
)
from pyhrg.gap.static_record.shared_motion import compute_shared_power
from pyhrg.gap.static_record.terms import ACCELEROMETER, GYRO
from tests.pyhrg.noises import noisy_angle
from tests.recordings import find_recording

SHARED = Path(__file__).parents[5] / "shared"


def imu_log(path: Path, rows: int = 3000) -> Path:
    """At rest, level; gyros ten times as noisy as believed."""
    generator = np.random.default_rng(1)
    time = 0.1 * np.arange(1, rows + 1)
    gyros = 3e-5 * generator.standard_normal((3, rows))
    forces = np.array([[0.0], [0.0], [-9.8]]) + 1e-3 * generator.standard_normal((3, rows))
    names = [f"gyro_{a}_rad_s" for a in "xyz"] + [f"accelerometer_{a}_m_s2" for a in "xyz"]
    table = np.column_stack([time, *gyros, *forces])
    header = ",".join(["time_s", *names])
    np.savetxt(path, table, delimiter=",", header=header, comments="")
    return path


def belief_file(folder: Path, table: str = "gyros") -> Path:
    path = folder / "belief.toml"
    path.write_text(f"[{table}]\nangle_random_walk_deg_sqrt_h = 0.003\n")
    return path


def test_files(tmp_path: Path) -> None:
    """What was closed is believed the second time, and nothing is missing."""
    log, first, second = imu_log(tmp_path / "imu.csv"), tmp_path / "first", tmp_path / "second"
    result = diagnose_record(log, belief_file(tmp_path), out=first)
    assert result.verdict == "explained"
    table = result.channels
    assert list(table["channel"]) == ["gyro_x", "gyro_y", "gyro_z"]
    assert (table["low_95"] < table["value"]).all()
    assert result.summary.startswith("imu.csv: explained\n  gyro_x: explained: angle_random_walk ")
    found = json.loads((first / "diagnosis.json").read_text())
    assert found["schema"] == "hrg-diagnosis/1"
    assert [(c["channel"], c["effect"]) for c in found["causes"]] == [
        (f"gyro_{axis}", "angle_random_walk") for axis in "xyz"
    ]
    assert found["channels"]["gyro_x"]["gap"]["shrink_percent"] > 90
    assert "accelerometer_x: it has no belief" in found["notes"]
    assert (first / "report.html").read_text().count("<svg") == 6
    assert diagnose_record(log, first / "closed.toml", out=second).verdict == "no_gap"


def test_the_same_bytes(tmp_path: Path) -> None:
    log, belief = imu_log(tmp_path / "imu.csv", 1200), belief_file(tmp_path, "gyro_x")
    for name in ("one", "two"):
        diagnose_record(log, belief, out=tmp_path / name)
    for file in ("diagnosis.json", "report.html", "closed.toml"):
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two" / file).read_bytes()


def test_nothing_is_written_where_something_is_refused(tmp_path: Path) -> None:
    belief = belief_file(tmp_path)
    with pytest.raises(HrgError, match="gyro_x: found 800 readings, expected 1024 or more"):
        diagnose_record(imu_log(tmp_path / "imu.csv", 800), belief, out=tmp_path / "out")
    belief.write_text("[accelerometers]\nvelocity_random_walk_m_s_sqrt_h = 1\n")
    gyro = Channel("gyro", GYRO, 1.0, noisy_angle(2048, (0, 1, 0, 0, 0), np.random.default_rng(1)))
    with pytest.raises(HrgError, match="found a record of gyros, expected a belief of them"):
        diagnose_record(StaticRecord("log", (gyro,)), read_beliefs(belief))
    assert not (tmp_path / "out").exists()


def test_readings_that_are_none_are_refused() -> None:
    values = np.random.default_rng(1).standard_normal(2000)
    with pytest.raises(HrgError, match="g: found 3 in all readings"):
        channel_from_increments("g", GYRO, 1.0, np.full(2000, 3.0))
    values[5] = np.nan
    with pytest.raises(HrgError, match="g: reading 5: found nan"):
        channel_from_increments("g", GYRO, 1.0, values)


def test_grid() -> None:
    generator = np.random.default_rng(2)
    assert find_quantization_step(0.25 * np.round(9 * generator.random(1000))) == pytest.approx(
        0.25
    )
    assert find_quantization_step(generator.standard_normal(1000)) is None
    assert find_quantization_step(np.tile([0.0981, np.nextafter(0.0981, 1)], 500)) is None


def test_motion_is_shared_and_noise_is_not() -> None:
    """Three channels of noise; a disturbance that two of them show, one with a lag."""
    n = 40000
    generator = np.random.default_rng(3)
    noises = generator.standard_normal((3, n))
    motion = np.convolve(generator.standard_normal(n + 400), np.ones(100) / 10, "valid")[:n]
    noises[0] += 3 * motion
    noises[1] += 3 * np.roll(motion, 20)
    channels = [channel_from_increments(str(i), GYRO, 0.01, x) for i, x in enumerate(noises)]
    shared = compute_shared_power(channels)
    assert np.all(shared[:2, 8] > 0.9)
    assert np.all(shared[2] < 0.35)
    assert np.all(shared[:, 0] < 0.05)


def test_terminal_says_motion_and_a_half_that_differs() -> None:
    """Two gyros share a slow disturbance; the third has none, and more noise in its second half."""
    n = 8192
    generator = np.random.default_rng(4)
    readings = generator.standard_normal((3, n))
    motion = np.convolve(generator.standard_normal(n + 99), np.ones(100) / 10, "valid")
    readings[:2] += 2 * motion
    readings[2, n // 2 :] *= 1.3
    channels = [channel_from_increments(f"gyro_{i}", GYRO, 1.0, r) for i, r in enumerate(readings)]
    belief = {"gyros": Belief(np.array([0.0, 1.0, 0.0, 0.0]))}
    lines = diagnose_record(StaticRecord("log", tuple(channels)), belief).summary.splitlines()
    for line in lines[1:3]:
        assert "motion" in line
        assert "(other channels show it)" in line
    assert "motion" not in lines[3]
    assert "gyro_2: unexplained: held-out half differs, p = " in lines[3]


def test_a_bench_log_s_walk_is_found() -> None:
    """The truth of the fourth campaign is a walk of 0.000655 deg/sqrt(h); the others have none."""
    folder = Path(os.environ.get("HRG_CAMPAIGNS", SHARED / "campaigns"))
    if not (folder / "dev-04").is_dir():
        pytest.skip(f"{folder} is not there; HRG_CAMPAIGNS says where recorded campaigns are")
    for number in range(1, 7):
        campaign = folder / f"dev-0{number}"
        nominal = json.loads((campaign / "campaign.json").read_text())["nominal"]
        stated = {key: nominal[key] for key in GYRO.by_parameter if key in nominal}
        belief = {"gyros": parse_belief(stated, GYRO, "campaign.json")}
        result = diagnose_record(read_record(campaign / "static_fixed.csv.gz"), belief)
        causes = result.channel_diagnoses[0].causes
        assert [c.term.effect for c in causes] == ["angle_random_walk"] * (number == 4)
        assert all(c.low < 0.000655336 < c.high for c in causes)


def test_a_laser_gyro_s_record_is_motion() -> None:
    """A vehicle with people in it: no noise term; from 0.1 to 3 Hz the channels share it."""
    path = find_recording("lasergyro.imu.gz")
    record = read_record(path)
    assert [c.kind for c in record.channels] == [GYRO] * 3 + [ACCELEROMETER] * 3
    assert record.channels[0].quantization_step == pytest.approx(np.deg2rad(0.1 / 3600), rel=1e-6)
    shared = compute_shared_power(record.channels)
    assert np.all(shared[:3, 7:9] > 0.8)
    short = StaticRecord(record.source, tuple(c.part(0, 20000) for c in record.channels[2:3]))
    belief = Belief(np.array([1.4e-7, 3e-7, 0.0, 0.0]))
    found = diagnose_record(short, {"gyros": belief})
    assert found.verdict == "unexplained"
    assert found.channel_diagnoses[0].causes == ()
