"""Flights of a plan, as text and as files."""

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.figure import Figure

from ins_eval.alignment.result import Alignment
from ins_eval.common.state import position_error
from ins_eval.error_model.budget_figure import plot_budget
from ins_eval.error_model.error_budget import COLUMNS as SIGMA_COLUMNS
from ins_eval.error_model.error_budget import separate_keys
from ins_eval.flights.linear import COLUMNS, Budget
from ins_eval.flights.plan import Plan
from ins_eval.results import flights
from ins_eval.results.growth_figure import draw_growth
from ins_eval.results.map_figure import draw_map
from ins_eval.results.png import save_png
from pyhrg.common.arrays import Array, to_json_value
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import write_files
from pyhrg.common.made_by import list_versions

SCHEMA = "hrg-nav/1"
DOCUMENT = "nav.json"
COMPONENTS = ("north", "east", "radial")
OWN_ERROR_DIGITS = 3
"""Digits of the navigator's own error, mm, that are printed: rounding makes less."""
LABEL, NUMBER = 42, 12
"""Widths of the printed table's first column and of the others, characters."""


@dataclass(frozen=True)
class Flight:
    """Flights of one plan, with their errors if the truth is known.

    Attributes:
        plan: duration, rates, height aiding, alignment, seed and number of runs.
        trajectory: name of the trajectory.
        imu: name of the IMU.
        start: (3,) position at time 0: latitude, longitude (rad), height (m).
        alignments: alignment of each run; empty if the runs start from the truth.
        dataset: navigated states by run and time, with the linear model's one-sigma. Where a truth
            is known, also true states and errors; for simulated IMUs, the navigator's own error.
        budget: error budget of run 1; None without one.
        sigma_budget: for a log, the final one-sigma by effect and axis (`compute_sigma_budget`).
        imu_digest: SHA-256 of the IMU's parameters or of the log.
        remark: what a user should know of the trajectory.
    """

    plan: Plan
    trajectory: str
    imu: str
    start: Array
    alignments: Sequence[Alignment]
    dataset: xr.Dataset
    budget: Budget | None = None
    sigma_budget: pd.DataFrame | None = None
    imu_digest: str = ""
    remark: str = ""

    __repr__ = describe_briefly

    @property
    def title(self) -> str:
        """Trajectory, length, IMU, rate and height."""
        plan = self.plan
        minutes = plan.duration / 60
        length = f"{minutes / 60:.4g} h" if minutes >= 60 else f"{minutes:.4g} min"
        rate = f"{1 / plan.interval:.4g} Hz"
        return f"{self.trajectory}, {length}, {self.imu} at {rate}, height {plan.height}"

    @property
    def summary(self) -> str:
        """Alignment, errors at the end and error budget, as text."""
        last = self.dataset.isel(time=-1)
        head = f"at the end, after {float(last['time']) / 3600:.4g} h"
        lines = [f"{head:<{LABEL}}" + "".join(f"{name:>{NUMBER}}" for name in COMPONENTS)]
        lines += [_line(label, row) for label, row in _end_rows(self, last)]
        title = f"{self.title}\n{self.remark}" if self.remark else self.title
        return "\n".join([title, "", *_alignment_lines(self), *lines, *_budget_lines(self)])

    @property
    def budget_table(self) -> pd.DataFrame:
        """Contributions to the final position error of run 1, m, by effect and axis; for a log,
        those to its one-sigma. `attrs["units"]` has the units of the columns."""
        if self.sigma_budget is not None:
            table = self.sigma_budget.copy()
        else:
            table = self.budget.table if self.budget else pd.DataFrame()
        table.attrs["units"] = {n: "m" if n.endswith("_m") else "1" for n in table.columns}
        return table

    @property
    def files(self) -> tuple[str, ...]:
        """Names of the files that `write` makes."""
        return tuple(self._list_writers())

    def plot(self) -> Figure:
        """Draw the path on a map, and the error at the end where a truth is known."""
        return draw_map(self.dataset.assign_attrs(title=self.title))

    def plot_growth(self) -> Figure:
        """Draw the position error over time with its one-sigma.

        Raises:
            HrgError: no truth is known.
        """
        if "radial_error" not in self.dataset:
            raise HrgError(f"{self.title}: no truth is known; expected one")
        return draw_growth(self.dataset.assign_attrs(title=self.title))

    def write(self, folder: Path | str) -> None:
        """Write `files` into a folder, all or none.

        Raises:
            OSError: the folder can't be written.
        """
        write_files(Path(folder), self._list_writers())

    def _list_writers(self) -> dict[str, Callable[[Path], Any]]:
        """Functions that write the files, by name."""
        dataset = self.dataset.assign_attrs(title=self.title)
        writers: dict[str, Callable[[Path], Any]] = {
            DOCUMENT: lambda path: path.write_text(
                json.dumps(_make_document(self), indent=2) + "\n"
            ),
            "flights.csv": lambda path: flights.write_csv(dataset, path),
            "flights.parquet": lambda path: flights.write_parquet(dataset, path),
            "flights.nc": lambda path: flights.write_netcdf(dataset, path),
            "map.png": lambda path: save_png(self.plot(), path),
        }
        if "radial_error" in self.dataset:
            writers["growth.png"] = lambda path: save_png(self.plot_growth(), path)
        if self.budget or self.sigma_budget is not None:
            writers["budget.csv"] = lambda path: flights.write_table(self.budget_table, path)
        if budget := self.budget:
            writers["budget.png"] = lambda path: save_png(
                plot_budget(budget.weights, budget.shares, self.title), path
            )
        return writers


def _make_document(flight: Flight) -> dict[str, Any]:
    """Content of nav.json."""
    asked = describe_flight(flight.plan, flight.trajectory, flight.imu, flight.imu_digest)
    result: dict[str, Any] = {
        **{"schema": SCHEMA, **asked},
        "at_the_end": _end_document(flight),
        "alignments": [describe_alignment(alignment) for alignment in flight.alignments],
    }
    if "own_north_error" in flight.dataset:
        own = np.hypot(flight.dataset["own_north_error"], flight.dataset["own_east_error"])
        result["largest_own_error_mm"] = float(np.max(own)) * 1000
    if flight.budget:
        result["budget_of_run_1"] = flight.budget.table.to_dict("records")
    if flight.sigma_budget is not None:
        result["budget_of_one_sigma"] = flight.sigma_budget.to_dict("records")
    return result


def describe_flight(plan: Plan, trajectory: str, imu: str, imu_digest: str) -> dict[str, Any]:
    """What a flight was asked to be, by keys of nav.json, and the versions of what flew it."""
    return {
        "versions": list_versions(),
        "trajectory": trajectory,
        "imu": imu,
        "imu_sha256": imu_digest,
        "duration_s": plan.duration,
        "rate_hz": 1 / plan.interval,
        "samples": plan.samples,
        "height": plan.height,
        "alignment_s": plan.alignment,
        "seed": plan.seed,
        "runs": plan.runs,
        "row_spacing_s": plan.row_spacing,
    }


def describe_alignment(alignment: Alignment) -> dict[str, Any]:
    roll, pitch, heading = map(float, alignment.euler_sigma_deg)
    return {
        "method": "fine",
        "time_s": alignment.time,
        "heading_deg": alignment.heading_deg,
        "heading_sigma_deg": heading,
        "pitch_deg": alignment.pitch_deg,
        "pitch_sigma_deg": pitch,
        "roll_deg": alignment.roll_deg,
        "roll_sigma_deg": roll,
        "sway_m": alignment.sway,
    }


def _end_document(flight: Flight) -> dict[str, Any]:
    last = flight.dataset.isel(time=-1)
    names = [f"{component}_error_m" for component in COMPONENTS]
    names += ["heading_error_deg", "north_sigma_m", "east_sigma_m", "heading_sigma_deg"]
    names += ["latitude_deg", "longitude_deg"]
    values = {name: name.rpartition("_")[0] for name in names}
    errors = {name: last[short].values for name, short in values.items() if short in last}
    numbers = to_json_value(errors)
    return {"time_s": float(last["time"]), **numbers}


def _end_rows(flight: Flight, last: xr.Dataset) -> list[tuple[str, list[float]]]:
    if "north_error" not in last:
        return [("from where it was aligned, m", _measure_motion(flight, last)), *_sigma_rows(last)]
    errors = [last[f"{name}_error"].values for name in COMPONENTS]
    rms = [float(np.sqrt(np.mean(error**2))) for error in errors]
    rows = [("position error, m", [float(error[0]) for error in errors])]
    if flight.plan.runs > 1:
        rows = [(f"position error, rms of {flight.plan.runs} runs, m", rms)]
    rows += _sigma_rows(last)
    if "own_north_error" in last:
        own = [1000 * float(last[f"own_{name}_error"]) for name in ("north", "east")]
        shown = [round(error, OWN_ERROR_DIGITS) + 0.0 for error in (*own, math.hypot(*own))]
        rows.append(("navigator's own error, mm (to 0.001)", shown))
    return rows


def _sigma_rows(last: xr.Dataset) -> list[tuple[str, list[float]]]:
    sigma = [float(last["north_sigma"]), float(last["east_sigma"])]
    return [("1-sigma by the linear model, m", [*sigma, math.hypot(*sigma)])]


def _measure_motion(flight: Flight, last: xr.Dataset) -> list[float]:
    """North, east and radial, m, from the start to the end."""
    position = np.array([np.deg2rad(last[f"{name}itude"].item()) for name in ("lat", "long")])
    north, east, _ = position_error(np.append(position, last["height"].item()), flight.start)
    return [float(north), float(east), math.hypot(north, east)]


def _alignment_lines(flight: Flight) -> list[str]:
    if not flight.alignments:
        return ["starts from the true position, velocity and attitude", ""]
    which = "alignment" if len(flight.alignments) == 1 else "alignment of run 1"
    return [f"{which}: {flight.alignments[0]}", ""]


def _budget_lines(flight: Flight) -> list[str]:
    if flight.sigma_budget is not None:
        parts = flight.sigma_budget.groupby("effect", sort=False)[list(SIGMA_COLUMNS[2:])]
        rows = parts.agg(lambda each: float(np.linalg.norm(each)))
        lines = [
            _line(str(effect), [*row, math.hypot(*row)])
            for effect, row in zip(rows.index, rows.to_numpy().tolist(), strict=True)
        ]
        return ["", "budget of the 1-sigma, m; squares add up", *lines]
    if not flight.budget:
        return []
    table = flight.budget.table
    sums = {
        str(effect): [sum(rows[name]) for name in COLUMNS[2:]]
        for effect, rows in table.groupby("effect", sort=False)
    }
    which = "" if flight.plan.runs == 1 else " of run 1"
    lines = ["", f"budget{which}, m"]
    lines += [_cause_line(effect, [*row, math.hypot(*row)]) for effect, row in sums.items()]
    total = [sum(parts) for parts in zip(*sums.values(), strict=True)]
    return [*lines, _line("sum: the linear model's error", [*total, math.hypot(*total)])]


def _cause_line(effect: str, row: list[float]) -> str:
    """A line whose keys, if the effect names any, stand behind the numbers."""
    name, keys = separate_keys(effect)
    return f"{_line(name, row)}   {keys}".rstrip()


def _line(label: str, row: list[float]) -> str:
    return f"{label:<{LABEL}}" + "".join(f"{x:>{NUMBER}.4g}" for x in row)
