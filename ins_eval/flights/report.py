"""Flights in words and as files."""

import json
import math
import platform
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from ins_eval.alignment.result import Alignment
from ins_eval.common.state import position_error
from ins_eval.error_model.budget.budget_figure import plot_budget
from ins_eval.flights.flown import COLUMNS, FlightData
from ins_eval.results import tables
from ins_eval.results.growth_figure import draw_growth
from ins_eval.results.map_figure import draw_map
from ins_eval.results.png import save_png

SCHEMA = "hrg-nav/1"
COMPONENTS = ("north", "east", "radial")
LABEL, NUMBER = 42, 12
"""Widths of the printed table's first column and of the others, characters."""


def list_writers(flight: FlightData) -> dict[str, Callable[[Path], Any]]:
    """Functions that write the files of flights, by name: more with a truth or a budget."""
    dataset = flight.dataset.assign_attrs(title=flight.title)
    writers: dict[str, Callable[[Path], Any]] = {
        "nav.json": lambda path: path.write_text(
            json.dumps(make_document(flight), indent=2) + "\n"
        ),
        "flights.csv": lambda path: tables.write_csv(dataset, path),
        "flights.parquet": lambda path: tables.write_parquet(dataset, path),
        "flights.nc": lambda path: tables.write_netcdf(dataset, path),
        "map.png": lambda path: save_png(draw_map(dataset), path),
    }
    if "radial_error" in flight.dataset:
        writers["growth.png"] = lambda path: save_png(draw_growth(dataset), path)
    if budget := flight.budget:
        writers["budget.csv"] = lambda path: tables.write_table(budget.table, path)
        writers["budget.png"] = lambda path: save_png(
            plot_budget(budget.weights, budget.shares, flight.title), path
        )
    return writers


def write(flight: FlightData, folder: Path) -> None:
    """Write all files into an existing folder."""
    for name, writer in list_writers(flight).items():
        writer(folder / name)


def summarize(flight: FlightData) -> str:
    """Alignment, errors at the end and error budget in words."""
    last = flight.dataset.isel(time=-1)
    head = f"at the end, after {float(last['time']) / 3600:.4g} h"
    rows = _end_rows(flight, last)
    lines = [f"{head:<{LABEL}}" + "".join(f"{name:>{NUMBER}}" for name in COMPONENTS)]
    lines += [_line(label, row) for label, row in rows]
    return "\n".join([flight.title, "", *_alignment_lines(flight), *lines, *_budget_lines(flight)])


def make_document(flight: FlightData) -> dict[str, Any]:
    """Content of nav.json."""
    plan = flight.plan
    result: dict[str, Any] = {
        "schema": SCHEMA,
        "versions": list_versions(),
        "trajectory": flight.trajectory,
        "imu": flight.imu,
        "duration_s": plan.duration,
        "rate_hz": 1 / plan.interval,
        "samples": plan.samples,
        "height": plan.height,
        "alignment_s": plan.alignment,
        "seed": plan.seed,
        "runs": plan.runs,
        "row_spacing_s": plan.row_spacing,
        "at_the_end": _end_document(flight),
        "alignments": [describe_alignment(alignment) for alignment in flight.alignments],
    }
    if "own_north_error" in flight.dataset:
        result["largest_own_error_mm"] = find_largest_own_error_mm(flight.dataset)
    if flight.budget:
        result["budget_of_run_1"] = flight.budget.table.to_dict("records")
    return result


def list_versions() -> dict[str, str]:
    """Versions of this package and of the libraries that its numbers rest on."""
    libraries = {name: version(name) for name in ("hrg", "numpy", "scipy", "numba", "filterpy")}
    return {"python": platform.python_version(), **libraries}


def find_largest_own_error_mm(dataset: xr.Dataset) -> float:
    """Largest horizontal error of the flight on ideal increments, mm."""
    return float(np.max(np.hypot(dataset["own_north_error"], dataset["own_east_error"]))) * 1000


def describe_alignment(alignment: Alignment) -> dict[str, Any]:
    """An alignment as numbers with units."""
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


def _end_document(flight: FlightData) -> dict[str, Any]:
    last = flight.dataset.isel(time=-1)
    names = [f"{component}_error_m" for component in COMPONENTS]
    names += ["heading_error_deg", "north_sigma_m", "east_sigma_m", "heading_sigma_deg"]
    names += ["latitude_deg", "longitude_deg"]
    values = {name: name.rpartition("_")[0] for name in names}
    found = {name: last[short].values for name, short in values.items() if short in last}
    numbers = {name: _finite(value.tolist()) for name, value in found.items()}
    return {"time_s": float(last["time"]), **numbers}


def _finite(value: Any) -> Any:
    """What isn't known is null."""
    if isinstance(value, list):
        return [_finite(each) for each in value]
    return value if math.isfinite(value) else None


def _end_rows(flight: FlightData, last: xr.Dataset) -> list[tuple[str, list[float]]]:
    if "north_error" not in last:
        return [("from where it was aligned, m", _measure_motion(flight, last))]
    errors = [last[f"{name}_error"].values for name in COMPONENTS]
    rms = [float(np.sqrt(np.mean(error**2))) for error in errors]
    rows = [("position error, m", [float(error[0]) for error in errors])]
    if flight.plan.runs > 1:
        rows = [(f"position error, rms of {flight.plan.runs} runs, m", rms)]
    if "north_sigma" in last:
        sigma = [float(last["north_sigma"]), float(last["east_sigma"])]
        rows.append(("1-sigma by the linear model, m", [*sigma, math.hypot(*sigma)]))
    if "own_north_error" in last:
        own = [1000 * float(last[f"own_{name}_error"]) for name in ("north", "east")]
        rows.append(("navigator's own error, mm", [*own, math.hypot(*own)]))
    return rows


def _measure_motion(flight: FlightData, last: xr.Dataset) -> list[float]:
    """North, east and radial, m, from the start to the end."""
    position = np.array([np.deg2rad(last[f"{name}itude"].item()) for name in ("lat", "long")])
    north, east, _ = position_error(np.append(position, last["height"].item()), flight.start)
    return [float(north), float(east), math.hypot(north, east)]


def _alignment_lines(flight: FlightData) -> list[str]:
    if not flight.alignments:
        return ["starts from the true position, velocity and attitude", ""]
    which = "alignment" if len(flight.alignments) == 1 else "alignment of run 1"
    return [f"{which}: {flight.alignments[0]}", ""]


def _budget_lines(flight: FlightData) -> list[str]:
    if not flight.budget:
        return []
    table = flight.budget.table
    sums = {
        str(effect): [sum(rows[name]) for name in COLUMNS[2:]]
        for effect, rows in table.groupby("effect", sort=False)
    }
    which = "" if flight.plan.runs == 1 else " of run 1"
    lines = ["", f"budget{which}, m"]
    lines += [_line(effect, [*sums[effect], math.hypot(*sums[effect])]) for effect in sums]
    total = [sum(parts) for parts in zip(*sums.values(), strict=True)]
    return [*lines, _line("sum: the linear model's error", [*total, math.hypot(*total)])]


def _line(label: str, row: list[float]) -> str:
    return f"{label:<{LABEL}}" + "".join(f"{x:>{NUMBER}.4g}" for x in row)
