"""An alignment in words and as files."""

import json
from pathlib import Path
from typing import Any

import numpy as np

from ins_eval.alignment import alignment_figure
from ins_eval.alignment.result import Alignment
from ins_eval.cli.flight_options.records import Record
from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.flights.report import alignment_document, versions
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H, MICRO_G

SCHEMA = "hrg-align/1"
FILES = ("align.json", "align.png")
ANGLES = ("heading", "pitch", "roll")


def summary(record: Record, alignment: Alignment) -> str:
    """What a person wants to read."""
    numbers = alignment_document(alignment)
    increments = record.increments
    lines = [
        f"{record.name}: {increments.duration:g} s at {1 / increments.interval:g} Hz, "
        f"from {increments.start:g} s, at latitude {np.rad2deg(record.position[0]):.4f} deg",
        "",
        f"{'':<10}{'deg':>12}{'1-sigma':>12}" + ("" if record.mat_nb is None else f"{'error':>12}"),
    ]
    error = None if record.mat_nb is None else angle_errors_deg(alignment, record.mat_nb)
    for name in ANGLES:
        line = f"{name:<10}{numbers[f'{name}_deg']:>12.4f}{numbers[f'{name}_sigma_deg']:>12.4f}"
        lines.append(line + (f"{error[name]:>12.4f}" if error else ""))
    return "\n".join([*lines, "", *_found(alignment)])


def document(record: Record, alignment: Alignment, errors: SensorErrors) -> dict[str, Any]:
    """Content of align.json."""
    increments = record.increments
    result = {
        "schema": SCHEMA,
        "versions": versions(),
        "record": record.name,
        "from_s": increments.start,
        "duration_s": increments.duration,
        "rate_hz": 1 / increments.interval,
        "latitude_deg": float(np.rad2deg(record.position[0])),
        "believed": believed(errors),
        "alignment": alignment_document(alignment),
    }
    if record.mat_nb is not None:
        result["error_deg"] = angle_errors_deg(alignment, record.mat_nb)
    return result


def write(record: Record, alignment: Alignment, errors: SensorErrors, folder: Path) -> None:
    """Write `FILES` into an existing folder."""
    text = json.dumps(document(record, alignment, errors), indent=2) + "\n"
    (folder / "align.json").write_text(text)
    alignment_figure.draw(alignment, folder / "align.png", record.name)


def believed(errors: SensorErrors) -> dict[str, float]:
    """Sensor errors that the covariance rests on."""
    return {
        "gyro_bias_deg_per_h": errors.gyro_bias / DEG_PER_H,
        "gyro_bias_instability_deg_per_h": errors.gyro_bias_instability / DEG_PER_H,
        "angle_random_walk_deg_per_sqrt_h": errors.angle_random_walk / DEG_PER_SQRT_H,
        "accelerometer_bias_ug": errors.accelerometer_bias / MICRO_G,
        "accelerometer_bias_instability_ug": errors.accelerometer_bias_instability / MICRO_G,
        "velocity_random_walk_m_per_s_per_sqrt_s": errors.velocity_random_walk,
    }


def angle_errors_deg(alignment: Alignment, mat_nb: np.ndarray) -> dict[str, float]:
    """Heading, pitch and roll, aligned less true."""
    roll, pitch, heading = np.rad2deg(
        np.subtract(euler_from_mat(alignment.mat_nb), euler_from_mat(mat_nb))
    )
    wrapped = (np.array([heading, pitch, roll]) + 180) % 360 - 180
    return dict(zip(ANGLES, map(float, wrapped), strict=True))


def _found(alignment: Alignment) -> list[str]:
    """How it was done, and what disturbed it."""
    lines = [f"method: {alignment.method}"]
    if alignment.sway is not None:
        lines.append(
            f"the vehicle sways by {1000 * alignment.sway:.3g} mm (1-sigma, each level axis)"
        )
    return lines
