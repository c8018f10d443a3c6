"""`hrg aid` from the command line."""

import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from ins_eval.flights.sources import load_imu_at_rate
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.cli import main
from tests.ins_eval.imu.logs import INCREMENTS, frame, saved

SECONDS, SIGMA = 900.0, 0.05


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A car's log and fixes: velocities alone in even seconds from 800 s on, and an odometer."""
    folder = tmp_path_factory.mktemp("aid")
    imu = load_imu_at_rate("simple", 20)
    trajectory = load_trajectory("car", SECONDS + 10)
    true = trajectory.increments(0.0, imu.interval, round(SECONDS / imu.interval))
    log = saved(frame(imu.measure(true, 2).increments, *INCREMENTS), folder, "car.csv")
    time = np.arange(1.0, SECONDS)
    noise = np.random.default_rng(2).normal(0.0, SIGMA, (2, len(time), 3))
    velocity = trajectory.velocity(time)
    speed = np.einsum("mi,mi->m", trajectory.mat_nb(time)[:, :, 0], velocity) + noise[0, :, 0]
    position, velocity = trajectory.position(time), velocity + noise[1]
    columns = {
        "time_s": time,
        "latitude_deg": np.rad2deg(position[:, 0]),
        "longitude_deg": np.rad2deg(position[:, 1]),
        "height_m": position[:, 2],
        "position_sigma_m": 1.0,
        "velocity_north_m_s": velocity[:, 0],
        "velocity_east_m_s": velocity[:, 1],
        "velocity_down_m_s": velocity[:, 2],
        "velocity_sigma_m_s": SIGMA,
        "speed_m_s": speed,
        "speed_sigma_m_s": SIGMA,
    }
    table = pd.DataFrame(columns)
    alone = (table.time_s > 800) & (table.time_s % 2 == 0)
    table.loc[alone, table.columns[1:5]] = np.nan
    table.loc[~alone, table.columns[9:]] = np.nan
    fixes = folder / "fixes.csv"
    table.to_csv(fixes, index=False)
    return log, fixes


def test_a_drive_is_aided(
    tmp_path: Path, files: tuple[Path, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "result"
    assert main(["aid", *map(str, files), "--out", str(out)]) == 0
    document = json.loads((out / "aid.json").read_text())
    assert document["fixes"] == {"used": 849 + 899 + 50, "contradicting": 0, "outside": 0}
    heading = load_trajectory("car", SECONDS).mat_nb(np.array(10.0))
    true = np.rad2deg(np.arctan2(heading[1, 0], heading[0, 0])) % 360
    assert document["heading_deg"] == pytest.approx(true, abs=5 * document["heading_sigma_deg"])
    assert (out / "aid.png").read_bytes().startswith(b"\x89PNG")
    assert "written to" in capsys.readouterr().out


def test_an_arm_beyond_any_vehicle_is_refused(
    tmp_path: Path, files: tuple[Path, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["aid", *map(str, files), "--lever-arm-m", "1000", "0", "0"]
    assert main([*arguments, "--out", str(tmp_path / "result")]) == 2
    assert "lever_arm_m: found 1000, expected a number from -100 to 100" in capsys.readouterr().err
