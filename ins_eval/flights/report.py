"""Flights in words and as files."""

import json
import math
import platform
from collections.abc import Callable, Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from ins_eval.alignment.result import Alignment
from ins_eval.common.state import position_error
from ins_eval.error_model.budget.budget_figure import draw as draw_budget
from ins_eval.flights.flown import Flown
from ins_eval.flights.shares import Share, shares, write_shares
from ins_eval.results import tables
from ins_eval.results.growth_figure import growth_figure
from ins_eval.results.map_figure import map_figure
from ins_eval.results.png import save

SCHEMA = "hrg-nav/1"
COMPONENTS = ("north", "east", "radial")
LABEL, NUMBER = 42, 12
"""Widths in the printed table."""


def files(truth: bool, simulated: bool) -> tuple[str, ...]:
    """Names of those that are written of flights with a truth, or of a simulated IMU."""
    names = ["nav.json", "flights.csv", "flights.parquet", "flights.nc", "map.png"]
    return (
        *names,
        *(("growth.png",) if truth else ()),
        *(("budget.csv", "budget.png") if simulated else ()),
    )


def write(flown: Flown, folder: Path, names: tuple[str, ...]) -> None:
    """Write these `files` into an existing folder."""
    dataset = flown.dataset.assign_attrs(title=flown.title)
    writers: Mapping[str, Callable[[Path], None]] = {
        "nav.json": lambda path: _write_text(json.dumps(document(flown), indent=2) + "\n", path),
        "flights.csv": lambda path: tables.write_csv(dataset, path),
        "flights.parquet": lambda path: tables.write_parquet(dataset, path),
        "flights.nc": lambda path: tables.write_netcdf(dataset, path),
        "map.png": lambda path: save(map_figure(dataset), path),
        "growth.png": lambda path: save(growth_figure(dataset), path),
        "budget.csv": lambda path: write_shares(shares(flown.budget), path),
        "budget.png": lambda path: _draw_budget(flown, path),
    }
    for name in names:
        writers[name](folder / name)


def summary(flown: Flown) -> str:
    """What a person wants to read."""
    last = flown.dataset.isel(time=-1)
    head = f"at the end, after {float(last['time']) / 3600:.4g} h"
    rows = _end_rows(flown, last)
    lines = [f"{head:<{LABEL}}" + "".join(f"{name:>{NUMBER}}" for name in COMPONENTS)]
    lines += [_line(label, row) for label, row in rows]
    return "\n".join([flown.title, "", *_alignment_lines(flown), *lines, *_budget_lines(flown)])


def document(flown: Flown) -> dict[str, Any]:
    """Content of nav.json."""
    plan = flown.plan
    result: dict[str, Any] = {
        "schema": SCHEMA,
        "versions": versions(),
        "trajectory": flown.trajectory,
        "imu": flown.imu,
        "duration_s": plan.duration,
        "rate_hz": 1 / plan.interval,
        "samples": plan.samples,
        "height": plan.height,
        "alignment_s": plan.alignment,
        "seed": plan.seed,
        "runs": plan.runs,
        "row_spacing_s": plan.row_spacing,
        "at_the_end": _end_document(flown),
        "alignments": [alignment_document(alignment) for alignment in flown.alignments],
    }
    if "own_north_error" in flown.dataset:
        result["largest_own_error_mm"] = largest_own_error_mm(flown.dataset)
    if flown.budget:
        result["budget_of_run_1"] = [share.document() for share in shares(flown.budget)]
    return result


def versions() -> dict[str, str]:
    """Of this package and of what its numbers rest on."""
    libraries = {name: version(name) for name in ("hrg", "numpy", "scipy", "numba", "filterpy")}
    return {"python": platform.python_version(), **libraries}


def largest_own_error_mm(dataset: xr.Dataset) -> float:
    """Largest horizontal error of the flight on ideal increments, mm."""
    return float(np.max(np.hypot(dataset["own_north_error"], dataset["own_east_error"]))) * 1000


def alignment_document(alignment: Alignment) -> dict[str, Any]:
    """An alignment as numbers with units."""
    roll, pitch, heading = map(float, alignment.euler_sigma_deg)
    return {
        "method": alignment.method,
        "time_s": alignment.time,
        "heading_deg": alignment.heading_deg,
        "heading_sigma_deg": heading,
        "pitch_deg": alignment.pitch_deg,
        "pitch_sigma_deg": pitch,
        "roll_deg": alignment.roll_deg,
        "roll_sigma_deg": roll,
        "sway_m": alignment.sway,
    }


def _end_document(flown: Flown) -> dict[str, Any]:
    last = flown.dataset.isel(time=-1)
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


def _end_rows(flown: Flown, last: xr.Dataset) -> list[tuple[str, list[float]]]:
    if "north_error" not in last:
        return [("from where it was aligned, m", _moved(flown, last))]
    errors = [last[f"{name}_error"].values for name in COMPONENTS]
    rms = [float(np.sqrt(np.mean(error**2))) for error in errors]
    rows = [("position error, m", [float(error[0]) for error in errors])]
    if flown.plan.runs > 1:
        rows = [(f"position error, rms of {flown.plan.runs} runs, m", rms)]
    if "north_sigma" in last:
        sigma = [float(last["north_sigma"]), float(last["east_sigma"])]
        rows.append(("1-sigma by the linear model, m", [*sigma, math.hypot(*sigma)]))
    if "own_north_error" in last:
        own = [1000 * float(last[f"own_{name}_error"]) for name in ("north", "east")]
        rows.append(("navigator's own error, mm", [*own, math.hypot(*own)]))
    return rows


def _moved(flown: Flown, last: xr.Dataset) -> list[float]:
    """North, east and radial, m, from the start to the end."""
    position = np.array([np.deg2rad(last[f"{name}itude"].item()) for name in ("lat", "long")])
    north, east, _ = position_error(np.append(position, last["height"].item()), flown.start)
    return [float(north), float(east), math.hypot(north, east)]


def _alignment_lines(flown: Flown) -> list[str]:
    if not flown.alignments:
        return ["starts from the true position, velocity and attitude", ""]
    which = "alignment" if len(flown.alignments) == 1 else "alignment of run 1"
    return [f"{which}: {flown.alignments[0]}", ""]


def _budget_lines(flown: Flown) -> list[str]:
    if not flown.budget:
        return []
    by_effect: dict[str, list[Share]] = {}
    for share in shares(flown.budget):
        by_effect.setdefault(share.effect, []).append(share)
    sums = {
        effect: [sum(s.north for s in found), sum(s.east for s in found)]
        for effect, found in by_effect.items()
    }
    which = "" if flown.plan.runs == 1 else " of run 1"
    lines = ["", f"budget{which}, m"]
    lines += [_line(effect, [*sums[effect], math.hypot(*sums[effect])]) for effect in sums]
    total = [sum(parts) for parts in zip(*sums.values(), strict=True)]
    return [*lines, _line("sum: the linear model's error", [*total, math.hypot(*total)])]


def _line(label: str, row: list[float]) -> str:
    return f"{label:<{LABEL}}" + "".join(f"{x:>{NUMBER}.4g}" for x in row)


def _draw_budget(flown: Flown, path: Path) -> None:
    assert flown.budget
    draw_budget(flown.budget.weights, flown.budget.shares, path, flown.title)


def _write_text(text: str, path: Path) -> None:
    path.write_text(text)
