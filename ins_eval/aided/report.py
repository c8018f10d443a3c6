"""What a drive with fixes tells: in words, as a figure and as files."""

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.figure import Figure
from scipy.stats import chi2

from ins_eval.aided.bench_maps import BenchTest
from ins_eval.aided.bias_map import BiasMap
from ins_eval.aided.figure import plot_maps
from ins_eval.aided.hold_out import HoldOut
from ins_eval.aided.kalman.backward import Smoothed
from ins_eval.aided.kalman.forward import Filtered
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.alignment.result import euler_from_rotation_vector
from ins_eval.common.rotation import euler_from_mat
from ins_eval.error_model.dynamics import ATTITUDE
from ins_eval.error_model.error_budget import BODY
from ins_eval.error_model.linear_model import AXES
from ins_eval.mission_model.gyro_map import HARMONICS
from ins_eval.results import flights
from ins_eval.results.png import save_png
from pyhrg.common.arrays import Array, to_json_value
from pyhrg.common.errors import describe_briefly
from pyhrg.common.files import write_files
from pyhrg.common.made_by import list_versions
from pyhrg.common.units import DEG_PER_H

SCHEMA = "hrg-aid/1"
DOCUMENT = "aid.json"
CONSISTENT = 0.99
"""Probability of the band of the normalised innovation squared."""
ROUNDING = 1e-9
"""Share of the largest prior below which a harmonic is that of rounding. Chosen."""


@dataclass(frozen=True)
class AidedDrive:
    """A drive with fixes.

    name: names of log and fixes.
    prior_name: name of the IMU whose errors were the prior.
    duration: time over which fixes were used, s.
    unused: number of fixes outside the log.
    filtered, smoothed: results of the filter and of the smoother.
    sensors: states of the sensor errors.
    bias_map, prior_map: bias maps after and before the drive.
    visited: (m, 3) pattern angles, rad; None for gyros without them.
    bench_tests: tests of the bench's maps against the drive.
    bench_used: axes whose bench map is part of the prior.
    hold_out: errors in the held-out hours; None if nothing was held out.
    """

    name: str
    prior_name: str
    duration: float
    unused: int
    filtered: Filtered
    smoothed: Smoothed
    sensors: SensorStates
    bias_map: BiasMap
    prior_map: BiasMap
    visited: Array | None
    bench_tests: tuple[BenchTest, ...]
    bench_used: frozenset[int]
    hold_out: HoldOut | None

    __repr__ = describe_briefly

    @property
    def normalized_innovation(self) -> tuple[float, float, float]:
        """Mean normalised innovation squared over its degrees of freedom, and the band in which it
        is with a probability of `CONSISTENT` if prior and sigmas are right."""
        updates = self.filtered.updates
        degrees = sum(len(update.innovation) for update in updates)
        tail = (1 - CONSISTENT) / 2
        low, high = chi2.ppf((tail, 1 - tail), degrees) / degrees
        return sum(update.square for update in updates) / degrees, float(low), float(high)

    @property
    def table(self) -> pd.DataFrame:
        """Mean and harmonics' amplitudes of each gyro's bias, deg/h, with one-sigma after and
        before the drive."""
        size, sigma = self.bias_map.measure_amplitudes()
        _, before = self.prior_map.measure_amplitudes()
        means = self.bias_map.coefficients[:, 0]
        left, first = (np.sqrt(m.covariance[:, 0, 0]) for m in (self.bias_map, self.prior_map))
        rows = []
        for axis, name in enumerate(BODY):
            rows.append((name, 0, means[axis], left[axis], first[axis]))
            rows += [
                (name, h, size[axis, k], sigma[axis, k], before[axis, k])
                for k, h in enumerate(HARMONICS)
                if before[axis, k] > ROUNDING * np.max(before)
            ]
        names = ["gyro", "harmonic", "bias_deg_per_h", "sigma_deg_per_h", "prior_sigma_deg_per_h"]
        table = pd.DataFrame(rows, columns=names)
        table[names[2:]] /= DEG_PER_H
        return table

    @property
    def coefficients(self) -> pd.DataFrame:
        """All coefficients of the sensors' effects, SI, with one-sigma after and before."""
        count = len(self.sensors)
        effects = [effect for effect in self.sensors.effects for _ in range(AXES)]
        sigma = np.sqrt(np.diag(self.filtered.covariance)[-count:])
        columns = {
            "effect": [effect.name for effect in effects],
            "correlation_time_s": [effect.correlation_time for effect in effects],
            "axis": list(BODY) * len(self.sensors.effects),
            "value_si": self.filtered.coefficients,
            "sigma_si": sigma,
            "prior_sigma_si": np.sqrt(np.diag(self.sensors.covariance)),
        }
        return pd.DataFrame(columns)

    @property
    def summary(self) -> str:
        """Fixes, attitude at the beginning, maps and what they are worth, in words."""
        value, low, high = self.normalized_innovation
        used = len(self.filtered.updates)
        verdict = "as it should be" if low <= value <= high else "not as the prior has it"
        heading, sigma = self._read_heading()
        lines = [
            self.name,
            f"{self.duration / 60:.4g} min with fixes: {used} used, {self.filtered.outliers} that "
            f"contradict, {self.unused} outside the log",
            f"normalised innovation squared {value:.3f} of 1 (99 % band {low:.3f} to {high:.3f}): "
            f"{verdict}",
            f"aligned in motion: heading {heading:.4f} +- {sigma:.4f} deg at "
            f"{self.smoothed.track.time[0]:.6g} s",
            "",
            f"{'gyro':<10}{'bias':>12}{'deg/h':>12}{'1-sigma':>12}{'before':>12}",
        ]
        for row in self.table.itertuples(index=False):
            title = f"harmonic {row.harmonic}" if row.harmonic else "mean"
            lines.append(
                f"{row.gyro:<10}{title:>12}{row.bias_deg_per_h:>12.5f}{row.sigma_deg_per_h:>12.5f}"
                f"{row.prior_sigma_deg_per_h:>12.5f}"
            )
        return "\n".join(
            [
                *lines,
                "",
                f"prior: errors of the {self.prior_name}",
                *map(_describe_test, self.bench_tests),
                *self._tell_bench(),
                *self._tell_worth(),
            ]
        )

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files that `write` makes."""
        return tuple(self._list_writers())

    @property
    def dataset(self) -> xr.Dataset:
        """Smoothed states with their one-sigma, at the ends of the filter's segments."""
        track = self.smoothed.track
        sigma = flights.tabulate_sigmas(track.time, self.smoothed.covariance)
        return xr.merge([flights.tabulate_navigated([track]), sigma])

    def plot(self) -> Figure:
        """Bias maps over the pattern angle, and the held-out position error."""
        return plot_maps(self.bias_map, self.prior_map, self.visited, self.hold_out, self.name)

    def write(self, folder: Path | str) -> None:
        """Write `files` into a folder, all or none.

        Raises:
            OSError: the folder can't be written.
        """
        write_files(Path(folder), self._list_writers())

    def _read_heading(self) -> tuple[float, float]:
        """Heading and its one-sigma, deg, at the first smoothed state."""
        mat_nb = self.smoothed.track.mat_nb[0]
        turns = euler_from_rotation_vector(mat_nb)[2]
        variance = turns @ self.smoothed.covariance[0][ATTITUDE, ATTITUDE] @ turns
        heading = float(np.rad2deg(euler_from_mat(mat_nb)[2]) % 360)
        return heading, float(np.rad2deg(np.sqrt(variance)))

    def _tell_bench(self) -> list[str]:
        if not self.bench_tests:
            return []
        used = ", ".join(BODY[axis] for axis in sorted(self.bench_used))
        return [f"bench's maps in the prior: {used or 'none'}"]

    def _tell_worth(self) -> list[str]:
        if self.hold_out is None:
            return []
        end = [float(x[-1]) for x in (self.hold_out.corrected, self.hold_out.uncorrected)]
        minutes = self.hold_out.time[-1] / 60
        return [
            f"held out: after {minutes:.4g} min without fixes {end[0]:.0f} m from them with the "
            f"errors taken out, {end[1]:.0f} m without"
        ]

    def _list_writers(self) -> dict[str, Callable[[Path], Any]]:
        dataset = self.dataset.assign_attrs(title=self.name)
        return {
            DOCUMENT: lambda path: path.write_text(
                json.dumps(to_json_value(self._make_document()), indent=2) + "\n"
            ),
            "coefficients.csv": lambda path: flights.write_table(self.coefficients, path),
            "track.csv": lambda path: flights.write_csv(dataset, path),
            "aid.png": lambda path: save_png(self.plot(), path),
        }

    def _make_document(self) -> dict[str, Any]:
        value, low, high = self.normalized_innovation
        heading, sigma = self._read_heading()
        document = {
            "schema": SCHEMA,
            "versions": list_versions(),
            "drive": self.name,
            "prior": self.prior_name,
            "duration_s": self.duration,
            "fixes": {
                "used": len(self.filtered.updates),
                "contradicting": self.filtered.outliers,
                "outside": self.unused,
            },
            "normalized_innovation_squared": {"value": value, "low": low, "high": high},
            "heading_deg": heading,
            "heading_sigma_deg": sigma,
            "bias_map": self.table.to_dict("records"),
            "bench": {
                "tests": [{**asdict(t), "p_value": t.p_value} for t in self.bench_tests],
                "used": [BODY[axis] for axis in sorted(self.bench_used)],
            },
        }
        if self.hold_out is not None:
            document["held_out"] = {
                "duration_s": float(self.hold_out.time[-1]),
                "corrected_m": float(self.hold_out.corrected[-1]),
                "uncorrected_m": float(self.hold_out.uncorrected[-1]),
            }
        return document


def _describe_test(test: BenchTest) -> str:
    if not test.degrees:
        return f"bench's map, {test.gyro}: the drive has seen none of it"
    verdict = "contradicts the drive" if test.contradicts else "agrees with the drive"
    return f"bench's map, {test.gyro}: {verdict} (square {test.square:.3g} of {test.degrees})"
