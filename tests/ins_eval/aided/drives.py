"""A drive of whole-angle gyros with position fixes, as files."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pandas as pd

from benchmarks.intervals.calibration import PLAN
from ins_eval.common.state import displace
from ins_eval.error_model.error_budget import BODY
from ins_eval.flights.sources import load_imu_at_rate
from ins_eval.mission_model.gyro_map import measure_gyro_map
from ins_eval.study.gyros.true_maps import list_slow_parameters
from ins_eval.trajectories.catalogue import load_trajectory
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.full_circumference import make_power_ons
from pyhrg.bench.calibration.calibration import PERIODS, PROCEDURE, RATE
from pyhrg.bench.reporting.document import format_document
from pyhrg.bench.scale_factor.scale_factor import make_turn_power_ons
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu
from tests.pyhrg.bench.cases import slow_bench

SEED, RATE_HZ, SECONDS = 4, 50, 2400.0
BEGIN = 90.0
"""Time at which the record begins, s: the vehicle moves."""
SIGMA = 1.5
LEVER_ARM = (1.0, 0.5, -1.5)
IMU = "typical-hrg"


@dataclass(frozen=True)
class DrivenFiles:
    """log, fixes: files; bench: results of the bench of the gyros forward, right, down; trajectory:
    the truth; maps: (3, 2 TERMS) true maps of bias, rad/s, and of the scale-factor error."""

    log: Path
    fixes: Path
    bench: tuple[Path, ...]
    trajectory: Trajectory
    maps: Array


def drive(folder: Path, slow: GyroFmu) -> DrivenFiles:
    """City traffic with fixes of `SIGMA` each second."""
    imu = load_imu_at_rate(IMU, RATE_HZ)
    trajectory = load_trajectory("city", BEGIN + SECONDS + 10)
    true = trajectory.increments(BEGIN, imu.interval, round(SECONDS / imu.interval))
    reading = imu.measure(true, SEED)
    columns = {"time_s": true.bounds[1:]}
    for axis, name in enumerate("xyz"):
        columns[f"rotation_{name}_rad"] = reading.increments.rotation[:, axis]
        columns[f"velocity_{name}_m_s"] = reading.increments.velocity[:, axis]
        columns[f"pattern_{name}_deg"] = np.rad2deg(reading.pattern_angle[:, axis])
    log, fixes = folder / "drive.csv", folder / "fixes.csv"
    pd.DataFrame(columns).to_csv(log, index=False)
    write_fixes(fixes, trajectory, BEGIN + np.arange(0.5, SECONDS))
    benches = imu.gyros.draw(np.random.default_rng(SEED))
    devices = [bench.device for bench in benches]
    maps = np.array([measure_gyro_map(slow, list_slow_parameters(each)) for each in devices])
    results = tuple(folder / f"{name}.json" for name in BODY)
    for number, (path, device) in enumerate(zip(results, devices, strict=True)):
        write_bench_result(path, slow_bench(slow, device, seed=number))
    return DrivenFiles(log, fixes, results, trajectory, maps)


def write_bench_result(path: Path, bench: Bench) -> None:
    """A short calibration. The mean is left out, because the IMU subtracts it."""
    turns = make_turn_power_ons(bench, RATE, PERIODS, 1)
    campaign = bench.campaign(bench.run([*make_power_ons(bench, PLAN, 3, 1), *turns]))
    outcome = PROCEDURE.evaluate(campaign)
    findings = tuple(each for each in outcome.findings if each.name != "bias map mean")
    path.write_text(format_document(PROCEDURE, replace(outcome, findings=findings), {}, {}))


def write_fixes(path: Path, trajectory: Trajectory, time: Array) -> None:
    errors = np.random.default_rng(SEED).normal(0.0, SIGMA, (len(time), 3))
    arms = trajectory.mat_nb(time) @ np.array(LEVER_ARM)
    latitude, longitude, height = displace(trajectory.position(time), arms + errors).T
    columns = {
        "time_s": time,
        "latitude_deg": np.rad2deg(latitude),
        "longitude_deg": np.rad2deg(longitude),
        "height_m": height,
        "position_sigma_m": SIGMA,
    }
    pd.DataFrame(columns).to_csv(path, index=False)
