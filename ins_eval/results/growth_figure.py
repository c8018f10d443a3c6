"""The figure of how the position error grows, with its 1-sigma around zero."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyhrg.common.arrays import Array

KILOMETRES_FROM = 5000.0
"""Errors beyond this are drawn in km, m."""


def draw_growth(flights: xr.Dataset) -> Figure:
    """North, east and radial error over time of a Dataset as `compare_with_truth` gives it."""
    figure = Figure(figsize=(8, 8), layout="constrained")
    panels = figure.subplots(3, 1, sharex=True)
    hours = flights["time"].values / 3600
    scale, unit = _scale(flights)
    for axes, name in zip(panels, ("north", "east", "radial"), strict=True):
        _draw_sigma(axes, hours, _sigma(flights, name), name == "radial", scale)
        _draw_runs(axes, hours, np.atleast_2d(flights[f"{name}_error"].values) / scale)
        axes.set_ylabel(f"{name} error, {unit}")
        axes.grid(alpha=0.3)
        axes.set_xlim(0, hours[-1])
    panels[0].legend(loc="best", fontsize="small", framealpha=0.9)
    panels[2].legend(loc="best", fontsize="small", framealpha=0.9)
    panels[2].set_ylim(bottom=0)
    panels[2].set_xlabel("time since alignment, h")
    figure.suptitle(str(flights.attrs.get("title", "")), parse_math=False)
    return figure


def _scale(flights: xr.Dataset) -> tuple[float, str]:
    largest = float(flights["radial_error"].max())
    if largest >= KILOMETRES_FROM:
        return 1000.0, "km"
    return (1.0, "m") if largest >= 0.1 else (0.001, "mm")


def _sigma(flights: xr.Dataset, name: str) -> Array | None:
    """1-sigma of a component; of the radial error its root mean square."""
    if "north_sigma" not in flights:
        return None
    if name == "radial":
        return np.hypot(flights["north_sigma"].values, flights["east_sigma"].values)
    return np.asarray(flights[f"{name}_sigma"].values)


def _draw_sigma(
    axes: Axes, hours: Array, sigma: Array | None, one_sided: bool, scale: float
) -> None:
    if sigma is None:
        return
    label = "root mean square" if one_sided else "±1-sigma"
    low = np.zeros_like(sigma) if one_sided else -sigma
    axes.fill_between(
        hours, low / scale, sigma / scale, color="tab:orange", alpha=0.3, linewidth=0,
        label=f"{label}, linear model",
    )  # fmt: skip


def _draw_runs(axes: Axes, hours: Array, errors: Array) -> None:
    runs = len(errors)
    label = "flown" if runs == 1 else f"flown, {runs} runs"
    width = 1.2 if runs == 1 else 0.7
    for number, error in enumerate(errors):
        shown = None if number else label
        axes.plot(hours, error, color="tab:blue", linewidth=width, alpha=0.9, label=shown)
