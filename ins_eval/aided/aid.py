"""The front door: a recorded drive with fixes gives the sensors' errors, maps of gyros among
them."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from ins_eval.aided.bias_map import read_bias_map
from ins_eval.aided.estimate import estimate_drive
from ins_eval.aided.fixes import FEWEST, Fixes, read_fixes
from ins_eval.aided.hold_out import judge_hold_out
from ins_eval.aided.kalman.drive import measure_turn, sample_drive
from ins_eval.aided.kalman.forward import Filtered
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.aided.kalman.start import WINDOW, align_in_motion
from ins_eval.aided.report import AidedDrive
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.linear_model import AXES
from ins_eval.flights.assumed_errors import assume_errors
from ins_eval.flights.sources import load_imu_at_rate, read_record
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.mission_model.bench_map import BenchMap, read_bench_map
from pyhrg.common.arguments import check_number
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder
from pyhrg.common.units import DEG_PER_H, HOUR, PPM
from pyhrg.records.imu.log import RecordedImu

MOST_OUTLIERS = 0.05
"""Share of fixes that contradict the log above which it is refused. Chosen: a filter that leaves
out more follows neither."""
LONGEST_ARM = 100.0
"""Longest lever arm, m."""


def aid(
    log: Path | str,
    fixes: Path | str,
    *,
    errors_of: Imu | str = "simple",
    lever_arm_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
    hold_out_h: float = 0.0,
    bench: Sequence[Path | str] = (),
    bench_drift: tuple[float, float] | None = None,
    out: Path | str | None = None,
) -> AidedDrive:
    """Estimate the errors of an IMU's sensors, and its vehicle's path, from a drive with fixes.

    The vehicle is aligned in motion, filtered forward and smoothed backward
    (docs/methods/aided.md).

    Args:
        log: recorded log of the IMU; with columns of pattern angles for whole-angle gyros.
        fixes: positions, velocities, speeds in the log's time (docs/aided.md).
        errors_of: IMU whose errors are the prior.
        lever_arm_m: from IMU to antenna: forward, right, down, m.
        hold_out_h: hours at the end whose fixes are not used but judge the free-inertial position
            with and without the errors that were found.
        bench: results of the bench's test `calibration` of the gyros forward, right, down
            (result.json); their maps are part of the prior unless the drive contradicts them.
        bench_drift: with `bench`, standard deviation of a term's change since then: of the bias,
            deg/h, and of the scale factor, ppm.
        out: folder that the result is written to, see `AidedDrive.write`; None writes nothing.

    Raises:
        HrgError: a file that can't be used; fixes outside the log, or that contradict it;
            whole-angle gyros without pattern angles; an argument out of range.
        OSError: `out` can't be written.
    """
    if out is not None:
        check_output_folder(Path(out))
    arm = np.array([check_number("lever_arm_m", x, -LONGEST_ARM, LONGEST_ARM) for x in lever_arm_m])
    held = check_number("hold_out_h", hold_out_h, 0.0, 24.0) * HOUR
    maps = _read_bench(bench, bench_drift)
    imu, position_fixes = load_imu_at_rate(errors_of, None), read_fixes(fixes)
    record, used = _cut(read_record(log), position_fixes)
    result = aid_record(record, used, imu, arm, held, maps)
    result = replace(
        result,
        name=f"{Path(log).name}, {Path(fixes).name}",
        unused=len(position_fixes) - len(used),
    )
    if out is not None:
        result.write(out)
    return result


def aid_record(
    record: RecordedImu,
    fixes: Fixes,
    imu: Imu,
    lever_arm: Array,
    held: float,
    maps: Mapping[int, BenchMap] | None = None,
) -> AidedDrive:
    """Estimate errors and way from a record that begins with its first fix.

    lever_arm: (3,) m; held: time at the end whose fixes are not used, s; maps: of the bench, by
    axis.
    """
    turned = measure_turn(record.increments, record.pattern_angle)
    sensors = assume_sensors(imu, record)
    drive = sample_drive(record.increments, turned)
    last = int((fixes.time[-1] - held - drive.increments.start) / drive.step)
    if last * drive.step < WINDOW:
        raise HrgError(
            f"{fixes.source}: found {max(last, 0) * drive.step:g} s of fixes before what is held "
            f"out, expected {WINDOW:g} s or more"
        )
    known_at = float(drive.increments.start + last * drive.step)
    start = align_in_motion(drive, fixes, sensors, lever_arm)
    estimate = estimate_drive(drive, fixes, sensors, start, lever_arm, last, maps or {})
    sensors, filtered = estimate.sensors, estimate.filtered
    _check_outliers(fixes, filtered)
    count = len(sensors)
    own = filtered.covariance[-count:, -count:]
    return AidedDrive(
        name=record.source,
        prior_name=f"{imu.name} IMU",
        duration=last * drive.step,
        unused=0,
        filtered=filtered,
        smoothed=estimate.smoothed,
        sensors=sensors,
        bias_map=read_bias_map(sensors, filtered.coefficients, own, known_at),
        prior_map=read_bias_map(sensors, sensors.mean, sensors.covariance, known_at),
        bench_tests=estimate.tests,
        bench_used=estimate.used,
        visited=None if record.pattern_angle is None else record.pattern_angle[: last * drive.rows],
        hold_out=judge_hold_out(
            record.increments.between(last * drive.rows, len(record.increments)),
            turned[last * drive.rows :],
            fixes,
            filtered.state,
            sensors,
            filtered.coefficients,
            lever_arm,
        )
        if held
        else None,
    )


def assume_sensors(imu: Imu, record: RecordedImu) -> SensorStates:
    """States of the sensors, by the errors of an IMU.

    Raises:
        HrgError: whole-angle gyros in a log without pattern angles, or not along the body axes.
    """
    if isinstance(imu.gyros, FmuGyros):
        if record.pattern_angle is None:
            raise HrgError(
                f"{record.source}: found no column pattern_x_deg, expected it: the errors of the "
                f"{imu.name} IMU follow the pattern angle"
            )
        if not np.allclose(imu.mounting.axes, np.eye(AXES)):
            raise HrgError(f"{imu.name} IMU: expected gyros along forward, right, down")
    assumed = assume_errors(imu)
    walks = np.zeros_like(assumed.deviations)
    for number, effect in enumerate(assumed.effects):
        if effect.name == "gyro bias":
            walks[number] = assumed.noise.gyro_rate_random_walk
    return SensorStates(assumed.effects, assumed.deviations, walks, _list_noise(assumed.noise))


def _list_noise(noise: SensorErrors) -> Array:
    return np.repeat([noise.angle_random_walk, noise.velocity_random_walk], AXES)


def _cut(record: RecordedImu, fixes: Fixes) -> tuple[RecordedImu, Fixes]:
    """The record from its first position fix on, and the fixes within it."""
    increments = record.increments
    used = fixes.between(increments.start, float(increments.bounds[-1]))
    count = int(np.count_nonzero(used.has_position))
    if count < FEWEST:
        raise HrgError(
            f"{fixes.source}: found {count} positions in the time of the log, {increments.start:g} "
            f"to {increments.bounds[-1]:g} s, expected {FEWEST} or more; the fixes go from "
            f"{fixes.time[0]:g} to {fixes.time[-1]:g} s"
        )
    begin = float(used.time[used.has_position][0])
    first = max(0, int((begin - increments.start) / increments.interval))
    pattern = record.pattern_angle
    return (
        RecordedImu(
            increments.between(first, len(increments)),
            record.position,
            record.attitude,
            record.source,
            None if pattern is None else pattern[first:],
        ),
        used.between(begin, np.inf),
    )


def _read_bench(
    paths: Sequence[Path | str], drift: tuple[float, float] | None
) -> dict[int, BenchMap]:
    """The bench's maps of three gyros by axis, or none."""
    if not paths and drift is None:
        return {}
    if len(paths) != AXES or drift is None:
        found = f"{len(paths)} results and {'no' if drift is None else 'a'} bench_drift"
        raise HrgError(f"bench: found {found}, expected {AXES} results and a bench_drift")
    bias, scale = (check_number("bench_drift", x, 0.0, 1e4) for x in drift)
    changes = bias * DEG_PER_H, scale * PPM
    return {axis: read_bench_map(path, changes) for axis, path in enumerate(paths)}


def _check_outliers(fixes: Fixes, filtered: Filtered) -> None:
    share = filtered.outliers / max(1, filtered.outliers + len(filtered.updates))
    if share > MOST_OUTLIERS:
        raise HrgError(
            f"{fixes.source}: {share:.0%} of the fixes contradict the log, expected "
            f"{MOST_OUTLIERS:.0%} at most: are they of another drive, in other units, their sigmas "
            "too small, or the clocks apart?"
        )
