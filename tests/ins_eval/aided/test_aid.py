"""A drive with position fixes gives the gyros' maps and the way within their sigmas."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from scipy.stats import chi2

import ins_eval
from ins_eval.common.state import track_error
from ins_eval.mission_model.gyro_map import TERMS
from pyhrg.common.errors import HrgError
from tests.ins_eval.aided.drives import IMU, LEVER_ARM, SIGMA, DrivenFiles


def test_maps_are_true_within_their_sigma(driven: DrivenFiles, aided: ins_eval.AidedDrive) -> None:
    fourth = np.array([9 * axis + term for axis in range(3) for term in (3, 4)])
    error = (aided.bias_map.coefficients - driven.maps[:, :TERMS]).ravel()[fourth]
    covariance = aided.bias_map.joint[np.ix_(fourth, fourth)]
    square = error @ np.linalg.solve(covariance, error)
    assert chi2.ppf(1e-3, 6) < square < chi2.ppf(1 - 1e-3, 6)
    _, after = aided.bias_map.measure_amplitudes()
    _, before = aided.prior_map.measure_amplitudes()
    assert np.min(after[:, 1] / before[:, 1]) < 0.1


def test_fixes_agree_with_the_record(aided: ins_eval.AidedDrive) -> None:
    value, low, high = aided.normalized_innovation
    assert low < value < high
    assert aided.filtered.outliers == 0


def test_vehicle_is_aligned_in_motion(driven: DrivenFiles, aided: ins_eval.AidedDrive) -> None:
    track = aided.smoothed.track
    assert np.linalg.norm(track.velocity[0]) > 5
    errors = track_error(track, driven.trajectory.track(track.time))
    every = np.hstack([errors.position, errors.velocity, errors.attitude])
    sigma = np.sqrt(np.diagonal(aided.smoothed.covariance, axis1=1, axis2=2)[:, :9])
    assert np.max(np.abs(every / sigma)) < 5
    assert np.all(np.abs(np.sqrt(np.mean((every / sigma) ** 2, axis=0)) - 1) < 0.6)
    assert np.mean(sigma[:, 0]) < 0.5 * SIGMA
    assert np.rad2deg(sigma[0, 8]) < 0.02


def test_position_without_fixes_is_five_times_better(aided: ins_eval.AidedDrive) -> None:
    hold_out = aided.hold_out
    assert hold_out.time[-1] == pytest.approx(720, abs=2)
    assert hold_out.corrected[-1] < hold_out.uncorrected[-1] / 5


def test_result_is_written(tmp_path: Path, aided: ins_eval.AidedDrive) -> None:
    aided.write(tmp_path / "result")
    assert sorted(path.name for path in (tmp_path / "result").iterdir()) == sorted(aided.files)
    assert "held out: after 11.99 min without fixes" in aided.summary
    table = pd.read_csv(tmp_path / "result" / "coefficients.csv")
    assert np.all(table["sigma_si"] <= table["prior_sigma_si"] * (1 + 1e-9))


FEW = 640
"""Number of fixes in tests of refusals: little more than the alignment takes."""


def test_fixes_in_milliseconds_are_refused(tmp_path: Path, driven: DrivenFiles) -> None:
    table = pd.read_csv(driven.fixes)
    refuse(
        tmp_path,
        driven,
        table.assign(time_s=1000 * table.time_s),
        "found 0 positions in the time of the log, 90 to 2490 s, .* go from 90500 to",
    )


def test_fixes_of_another_drive_or_unit_are_refused(tmp_path: Path, driven: DrivenFiles) -> None:
    table = pd.read_csv(driven.fixes, nrows=FEW)
    mirrored = table.assign(longitude_deg=2 * table.longitude_deg[0] - table.longitude_deg)
    radians = table.assign(latitude_deg=np.deg2rad(table.latitude_deg))
    small_sigmas = table.assign(position_sigma_m=0.1)
    for other in (mirrored, radians, small_sigmas):
        refuse(tmp_path, driven, other, "other.csv: .*(does not settle|contradict the log)")


def test_gyros_without_pattern_angles_have_no_map(tmp_path: Path, driven: DrivenFiles) -> None:
    table = pd.read_csv(driven.log, nrows=40_000)
    log = tmp_path / "plain.csv"
    table[[name for name in table if "pattern" not in name]].to_csv(log, index=False)
    with pytest.raises(HrgError, match=r"plain\.csv: found no column pattern_x_deg"):
        ins_eval.aid(log, driven.fixes, errors_of=IMU)


def refuse(folder: Path, driven: DrivenFiles, fixes: pd.DataFrame, message: str) -> None:
    fixes.to_csv(folder / "other.csv", index=False)
    with pytest.raises(HrgError, match=message):
        ins_eval.aid(driven.log, folder / "other.csv", errors_of=IMU, lever_arm_m=LEVER_ARM)
