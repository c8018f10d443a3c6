"""An alignment in words and as files."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.alignment_figure import plot_alignment
from ins_eval.alignment.measured_noise import MeasuredNoise
from ins_eval.alignment.result import Alignment
from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.flights.report import describe_alignment, list_versions
from ins_eval.results.png import save_png
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.records.imu.increments import Increments

SCHEMA = "hrg-align/1"
FILES = ("align.json", "align.png")
ANGLES = ("heading", "pitch", "roll")


@dataclass(frozen=True)
class StandingRecord:
    """Increments of a standing vehicle.

    position: (3,) latitude, longitude (rad), height (m); mat_nb: (3, 3) true attitude at the
    record's end, None if it isn't known.
    """

    name: str
    increments: Increments
    position: NDArray[np.float64]
    mat_nb: NDArray[np.float64] | None = None


def summarize(record: StandingRecord, alignment: Alignment) -> str:
    """Heading, pitch and roll with their one-sigma, in words."""
    numbers = describe_alignment(alignment)
    increments = record.increments
    lines = [
        f"{record.name}: {increments.duration:g} s at {1 / increments.interval:g} Hz, "
        f"from {increments.start:g} s, at latitude {np.rad2deg(record.position[0]):.4f} deg",
        "",
        f"{'':<10}{'deg':>12}{'1-sigma':>12}" + ("" if record.mat_nb is None else f"{'error':>12}"),
    ]
    error = None if record.mat_nb is None else find_angle_errors_deg(alignment, record.mat_nb)
    for name in ANGLES:
        line = f"{name:<10}{numbers[f'{name}_deg']:>12.4f}{numbers[f'{name}_sigma_deg']:>12.4f}"
        lines.append(line + (f"{error[name]:>12.4f}" if error else ""))
    sway = f"the vehicle sways by {1000 * alignment.sway:.3g} mm (1-sigma, each level axis)"
    return "\n".join([*lines, "", "method: fine", sway])


def describe_prior(imu: str, noise: MeasuredNoise | None) -> list[str]:
    """What the 1-sigma rests on, in words."""
    if noise is None:
        return [f"errors assumed: those of the {imu} IMU"]
    found = document_prior(imu, noise)["measured"]
    return [
        f"noise of this record: {found['angle_random_walk_deg_per_sqrt_h']:.2g} deg/sqrt(h) within "
        f"{found['angle_random_walk_relative_sigma']:.0%}, "
        f"{found['velocity_random_walk_m_per_s_per_sqrt_s']:.2g} m/s/sqrt(s) within "
        f"{found['velocity_random_walk_relative_sigma']:.0%}",
        f"prior: random walks of the {imu} IMU, a decade wide; its biases are assumed",
    ]


def document_prior(imu: str, noise: MeasuredNoise | None) -> dict[str, Any]:
    """What the 1-sigma rests on, for align.json."""
    if noise is None:
        return {"prior": imu}
    measured = {
        "angle_random_walk_deg_per_sqrt_h": noise.errors.angle_random_walk / DEG_PER_SQRT_H,
        "angle_random_walk_relative_sigma": float(noise.relative_sigma[0]),
        "velocity_random_walk_m_per_s_per_sqrt_s": noise.errors.velocity_random_walk,
        "velocity_random_walk_relative_sigma": float(noise.relative_sigma[1]),
    }
    return {"prior": imu, "measured": measured}


def make_document(
    record: StandingRecord, alignment: Alignment, errors: SensorErrors, prior: dict[str, Any]
) -> dict[str, Any]:
    """Content of align.json."""
    increments = record.increments
    result = {
        "schema": SCHEMA,
        "versions": list_versions(),
        "record": record.name,
        "from_s": increments.start,
        "duration_s": increments.duration,
        "rate_hz": 1 / increments.interval,
        "latitude_deg": float(np.rad2deg(record.position[0])),
        "believed": list_assumed_errors(errors),
        **prior,
        "alignment": describe_alignment(alignment),
    }
    if record.mat_nb is not None:
        result["error_deg"] = find_angle_errors_deg(alignment, record.mat_nb)
    return result


def write(
    record: StandingRecord,
    alignment: Alignment,
    errors: SensorErrors,
    prior: dict[str, Any],
    folder: Path,
) -> None:
    """Write `FILES` into an existing folder."""
    text = json.dumps(make_document(record, alignment, errors, prior), indent=2) + "\n"
    (folder / "align.json").write_text(text)
    save_png(plot_alignment(alignment, record.name), folder / "align.png")


def list_assumed_errors(errors: SensorErrors) -> dict[str, float]:
    """Sensor errors that the covariance rests on."""
    return {
        "gyro_bias_deg_per_h": errors.gyro_bias / DEG_PER_H,
        "gyro_bias_instability_deg_per_h": errors.gyro_bias_instability / DEG_PER_H,
        "angle_random_walk_deg_per_sqrt_h": errors.angle_random_walk / DEG_PER_SQRT_H,
        "accelerometer_bias_ug": errors.accelerometer_bias / MICRO_G,
        "accelerometer_bias_instability_ug": errors.accelerometer_bias_instability / MICRO_G,
        "velocity_random_walk_m_per_s_per_sqrt_s": errors.velocity_random_walk,
    }


def find_angle_errors_deg(alignment: Alignment, mat_nb: np.ndarray) -> dict[str, float]:
    """Heading, pitch and roll, aligned less true."""
    roll, pitch, heading = np.rad2deg(
        np.subtract(euler_from_mat(alignment.mat_nb), euler_from_mat(mat_nb))
    )
    wrapped = (np.array([heading, pitch, roll]) + 180) % 360 - 180
    return dict(zip(ANGLES, map(float, wrapped), strict=True))
