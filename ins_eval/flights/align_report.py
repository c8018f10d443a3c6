"""A standing vehicle's record with its attitude, as text, as a figure and as files."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ins_eval.alignment.measured_noise import MeasuredNoise
from ins_eval.alignment.result import Alignment, History, euler_from_rotation_vector
from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.flights.report import describe_alignment
from ins_eval.results.png import save_png
from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly
from pyhrg.common.files import stage_files
from pyhrg.common.made_by import list_versions
from pyhrg.common.units import DEG, DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.records.imu.log import Increments

PLOTTED = (("heading", 2, "tab:blue"), ("pitch", 1, "tab:orange"), ("roll", 0, "tab:green"))
UNSCALED_PART = 0.1
"""First part of the record, which the scale of the axes ignores. Chosen."""


def plot_alignment(result: Alignment, name: str = "") -> Figure:
    """Plot heading, pitch and roll over the record, with their one-sigma."""
    time, euler, sigma = result.history.time, *euler_history_deg(result.history)
    figure = Figure(figsize=(8, 7), layout="constrained")
    rows = figure.subplots(3, 1, sharex=True)
    for axes, (angle, column, color) in zip(rows, PLOTTED, strict=True):
        value, band = euler[:, column], sigma[:, column]
        axes.fill_between(time, value - band, value + band, color=color, alpha=0.25, linewidth=0)
        axes.plot(time, value, color=color)
        later = slice(round(UNSCALED_PART * len(time)), None)
        low, high = np.min((value - band)[later]), np.max((value + band)[later])
        axes.set_ylim(low - 0.1 * (high - low), high + 0.1 * (high - low))
        axes.set_ylabel(f"{angle}, deg")
        axes.ticklabel_format(useOffset=False)
        axes.grid(alpha=0.25)
        last = f"{angle} {value[-1]:.4f} ± {band[-1]:.4f} deg (one sigma, band)"
        axes.set_title(last, loc="left", fontsize="medium")
    figure.suptitle(f"Alignment, fine{f': {name}' if name else ''}", parse_math=False)
    rows[-1].set_xlabel("time, s")
    rows[-1].set_xlim(time[0], time[-1])
    return figure


def euler_history_deg(history: History) -> tuple[Array, Array]:
    """Return roll, pitch, heading (m, 3), deg, and their one-sigma (m, 3); the heading has no jumps
    and ends between 0 and 360."""
    euler = np.stack(euler_from_mat(history.mat_nb), axis=-1)
    turns = np.array([euler_from_rotation_vector(mat_nb) for mat_nb in history.mat_nb])
    variance = np.einsum("mij,mjk,mik->mi", turns, history.covariance, turns)
    euler[:, 2] = np.unwrap(euler[:, 2])
    euler[:, 2] += np.remainder(euler[-1, 2], 2 * np.pi) - euler[-1, 2]
    return euler / DEG, np.sqrt(variance) / DEG


SCHEMA = "hrg-align/1"
FILES = ("align.json", "align.png")
ANGLES = ("heading", "pitch", "roll")


@dataclass(frozen=True)
class StandingRecord:
    """Increments of a standing vehicle.

    Attributes:
        name: name of the record or of the simulated IMU.
        increments: output of the IMU.
        position: (3,) latitude, longitude (rad), height (m).
        mat_nb: (3, 3) true attitude at the record's end; None if it isn't known.
    """

    name: str
    increments: Increments
    position: Array
    mat_nb: Array | None = None


@dataclass(frozen=True)
class AlignedRecord:
    """A standing vehicle's record with its attitude.

    Attributes:
        record: the record that was aligned on.
        alignment: attitude with its covariance.
        errors: sensor errors that the covariance assumes.
        prior: name of the IMU whose errors these are.
        noise: noise that was measured in the record; None if it was not.
    """

    record: StandingRecord
    alignment: Alignment
    errors: SensorErrors
    prior: str
    noise: MeasuredNoise | None = None

    __repr__ = describe_briefly

    @property
    def summary(self) -> str:
        """Heading, pitch and roll with their one-sigma, as text."""
        record, numbers = self.record, describe_alignment(self.alignment)
        increments, error = record.increments, self._find_error_deg()
        lines = [
            f"{record.name}: {increments.duration:g} s at {1 / increments.interval:g} Hz, "
            f"from {increments.start:g} s, at latitude {np.rad2deg(record.position[0]):.4f} deg",
            "",
            f"{'':<10}{'deg':>12}{'1-sigma':>12}" + (f"{'error':>12}" if error else ""),
        ]
        for name in ANGLES:
            line = f"{name:<10}{numbers[f'{name}_deg']:>12.4f}{numbers[f'{name}_sigma_deg']:>12.4f}"
            lines.append(line + (f"{error[name]:>12.4f}" if error else ""))
        sway = 1000 * self.alignment.sway
        sways = f"the vehicle sways by {sway:.3g} mm (1-sigma, each level axis)"
        return "\n".join([*lines, "", "method: fine", sways, *self._describe_prior()])

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files that `write` makes."""
        return FILES

    def plot(self) -> Figure:
        """Draw how heading, pitch and roll settle, with their one-sigma."""
        return plot_alignment(self.alignment, self.record.name)

    def write(self, folder: Path | str) -> None:
        """Write `align.json` and `align.png` into a folder, both or none.

        Raises:
            OSError: the folder can't be written.
        """
        with stage_files(Path(folder), FILES) as aside:
            text = json.dumps(self._make_document(), indent=2) + "\n"
            (aside / "align.json").write_text(text)
            save_png(self.plot(), aside / "align.png")

    def _describe_prior(self) -> list[str]:
        """What the 1-sigma rests on, in words."""
        measured = self._document_prior().get("measured")
        if measured is None:
            return [f"errors assumed: those of the {self.prior} IMU"]
        return [
            f"noise of this record: {measured['angle_random_walk_deg_per_sqrt_h']:.2g} deg/sqrt(h) "
            f"within {measured['angle_random_walk_relative_sigma']:.0%}, "
            f"{measured['velocity_random_walk_m_per_s_per_sqrt_s']:.2g} m/s/sqrt(s) within "
            f"{measured['velocity_random_walk_relative_sigma']:.0%}",
            f"prior: random walks of the {self.prior} IMU, a decade wide; its biases are assumed",
        ]

    def _document_prior(self) -> dict[str, Any]:
        """What the 1-sigma rests on, for align.json."""
        if self.noise is None:
            return {"prior": self.prior}
        errors, (angle, velocity, _) = self.noise.errors, self.noise.relative_sigma.tolist()
        measured = {
            "angle_random_walk_deg_per_sqrt_h": errors.angle_random_walk / DEG_PER_SQRT_H,
            "angle_random_walk_relative_sigma": angle,
            "velocity_random_walk_m_per_s_per_sqrt_s": errors.velocity_random_walk,
            "velocity_random_walk_relative_sigma": velocity,
        }
        return {"prior": self.prior, "measured": measured}

    def _make_document(self) -> dict[str, Any]:
        record, increments, error = self.record, self.record.increments, self._find_error_deg()
        return {
            "schema": SCHEMA,
            "versions": list_versions(),
            "record": record.name,
            "from_s": increments.start,
            "duration_s": increments.duration,
            "rate_hz": 1 / increments.interval,
            "latitude_deg": float(np.rad2deg(record.position[0])),
            "believed": _list_assumed_errors(self.errors),
            **self._document_prior(),
            "alignment": describe_alignment(self.alignment),
            **({"error_deg": error} if error else {}),
        }

    def _find_error_deg(self) -> dict[str, float] | None:
        """Heading, pitch and roll, aligned less true; None if the truth isn't known."""
        if self.record.mat_nb is None:
            return None
        aligned, true = (euler_from_mat(m) for m in (self.alignment.mat_nb, self.record.mat_nb))
        roll, pitch, heading = np.rad2deg(np.subtract(aligned, true))
        wrapped = (np.array([heading, pitch, roll]) + 180) % 360 - 180
        return dict(zip(ANGLES, map(float, wrapped), strict=True))


def _list_assumed_errors(errors: SensorErrors) -> dict[str, float]:
    return {
        "gyro_bias_deg_per_h": errors.gyro_bias / DEG_PER_H,
        "gyro_bias_instability_deg_per_h": errors.gyro_bias_instability / DEG_PER_H,
        "angle_random_walk_deg_per_sqrt_h": errors.angle_random_walk / DEG_PER_SQRT_H,
        "accelerometer_bias_ug": errors.accelerometer_bias / MICRO_G,
        "accelerometer_bias_instability_ug": errors.accelerometer_bias_instability / MICRO_G,
        "velocity_random_walk_m_per_s_per_sqrt_s": errors.velocity_random_walk,
    }
