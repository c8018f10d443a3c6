"""Noise of a record at rest: bias and coefficients that were put in come out, with files."""

import argparse
import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pyhrg import compute_allan
from pyhrg.cli import allan
from pyhrg.common.errors import HrgError
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG, DEG_PER_H, DEG_PER_SQRT_H
from pyhrg.gap.static_record.allan import FILES
from pyhrg.gap.static_record.record import MIN_READINGS

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
    first = noise.deviations.iloc[0]
    expected = WALK / INTERVAL**0.5 / DEG_PER_H
    assert first["low_95"] < expected < first["high_95"]
    assert noise.notes == ("table_angle_deg: missing, taken as on a gyro at rest",)


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
    walk = document["channels"]["gyro"]["angle_random_walk_deg_sqrt_h"]
    assert walk["value"] == pytest.approx(0.01, rel=0.1)
    assert f"{N - 1} readings every 0.1 s" in (out / "report.html").read_text()


def test_a_record_that_is_too_short_is_refused(log: Path) -> None:
    text = "".join(log.read_text().splitlines(keepends=True)[:500])
    log.write_text(text)
    with pytest.raises(HrgError, match=f"498 readings, expected {MIN_READINGS} or more"):
        compute_allan(log)
