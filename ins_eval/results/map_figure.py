"""The figure of a flight's path: true and navigated on a map, and where they part at its end.

The map is plain: degrees on the axes, lengths true at the middle, a bar of kilometres.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, Rectangle
from matplotlib.ticker import FuncFormatter, MaxNLocator
from matplotlib.transforms import blended_transform_factory

from ins_eval.common import earth
from ins_eval.results.flights import wrap_deg
from pyhrg.common.arrays import Array

MARGIN = 0.08
"""Margin around what is drawn, as a share of the map's larger side."""
SMALLEST = 100.0
"""Smallest side of a map, m: that of a vehicle that stays where it is."""


def unwrap_deg(longitude: Array, near: float) -> Array:
    """Longitudes (m,) without jumps, starting within half a turn of `near`, deg."""
    continuous = np.unwrap(longitude, period=360)
    return np.asarray(continuous - 360 * np.round((continuous[0] - near) / 360))


def lay_out_map(axes: Axes, latitude: Array, longitude: Array) -> None:
    """Limits around these points (unwrapped, deg), equal lengths, labels, and the bar."""
    middle = (np.min(latitude) + np.max(latitude)) / 2
    north, east = find_metres_per_degree(float(middle))
    centre = np.array([(np.min(longitude) + np.max(longitude)) / 2, middle])
    size = np.array([np.ptp(longitude) * east, np.ptp(latitude) * north])
    half = (np.maximum(size, max(np.max(size) / 2, SMALLEST)) / 2) + MARGIN * np.max(size)
    spans = half / np.array([east, north])
    axes.set_xlim(centre[0] - spans[0], centre[0] + spans[0])
    axes.set_ylim(centre[1] - spans[1], centre[1] + spans[1])
    axes.set_aspect(north / east)
    axes.xaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 3, 5, 10]))
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 3, 5, 10]))
    axes.xaxis.set_major_formatter(FuncFormatter(_make_label(2 * spans[0], ("W", "E"))))
    axes.yaxis.set_major_formatter(FuncFormatter(_make_label(2 * spans[1], ("S", "N"))))
    axes.grid(alpha=0.3)
    axes.set_xlabel("longitude")
    axes.set_ylabel("latitude")
    _scale_bar(axes, 2 * half[0], east)


def find_metres_per_degree(latitude: float) -> tuple[float, float]:
    """Metres per degree of latitude and of longitude, on the ellipsoid, at a latitude in deg."""
    radians = np.deg2rad(latitude)
    north = earth.meridian_radius(radians)
    east = earth.transverse_radius(radians) * np.cos(radians)
    return float(np.deg2rad(north)), float(np.deg2rad(east))


def find_round_length(limit: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that is not above the limit."""
    power = 10.0 ** np.floor(np.log10(limit))
    return float(max(step for step in (1, 2, 5) if step * power <= limit * (1 + 1e-9)) * power)


def _scale_bar(axes: Axes, width: float, metres: float) -> None:
    """A bar in the lower left corner, of a round length up to a quarter of the map's width."""
    length = find_round_length(width / 4)
    left = axes.get_xlim()[0] + 0.04 * width / metres
    across = blended_transform_factory(axes.transData, axes.transAxes)
    bar = Rectangle((left, 0.04), length / metres, 0.012, color="black", transform=across)
    axes.add_patch(bar)
    text = f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m"
    axes.text(left + length / metres / 2, 0.06, text, ha="center", va="bottom", transform=across)


def _make_label(span: float, sides: tuple[str, str]) -> Callable[[float, object], str]:
    """Labels of ticks, five or so to a span; 0 and half a turn have no side."""
    decimals = max(0, -int(np.floor(np.log10(span / 5))))

    def label(value: float, _: object = None) -> str:
        around = float(wrap_deg(np.array(value)))
        side = "" if around in (0.0, -180.0) else sides[around > 0]
        return f"{abs(around):.{decimals}f}°{side}"

    return label


TRUE_COLOR, NAVIGATED_COLOR = "black", "tab:blue"


def draw_map(flights: xr.Dataset) -> Figure:
    """Path of a Dataset of `results.flights`; with a truth, a second map in metres shows the errors
    at the end, and their 1-sigma ellipse where there is one."""
    known = "true_latitude" in flights
    figure = Figure(figsize=(11, 5.5) if known else (6.5, 5.5), layout="constrained")
    if known:
        path, end = figure.subplots(1, 2, width_ratios=(1.35, 1))
        _draw_end(end, flights)
    else:
        path = figure.add_subplot()
    _draw_path(path, flights)
    figure.suptitle(str(flights.attrs.get("title", "")), parse_math=False)
    return figure


def _draw_path(axes: Axes, flights: xr.Dataset) -> None:
    prefixes = ("", "true_") if "true_latitude" in flights else ("",)
    near = float(flights["longitude"].values.flat[0])
    latitudes, longitudes = [], []
    for prefix in prefixes:
        latitude = np.atleast_2d(flights[f"{prefix}latitude"].values)
        longitude = [
            unwrap_deg(row, near) for row in np.atleast_2d(flights[f"{prefix}longitude"].values)
        ]
        _draw_lines(axes, latitude, np.stack(longitude), prefix == "true_")
        latitudes.append(latitude.ravel())
        longitudes.append(np.concatenate(longitude))
    lay_out_map(axes, np.concatenate(latitudes), np.concatenate(longitudes))
    east, north = longitudes[-1], latitudes[-1]
    _mark(axes, east[0], north[0], marker="o", color="tab:green", label="start")
    _mark(axes, east[-1], north[-1], marker="s", color="tab:red", label="end")
    if len(prefixes) == 2 and flights.sizes.get("run", 1) == 1:
        style = {"marker": "s", "color": NAVIGATED_COLOR, "zorder": 3.5, "label": "end, navigated"}
        _mark(axes, longitudes[0][-1], latitudes[0][-1], **style)
    axes.legend(loc="best", fontsize="small", framealpha=0.9)
    axes.set_title("path", fontsize="medium")


def _draw_lines(axes: Axes, latitude: Array, longitude: Array, true: bool) -> None:
    style: dict[str, Any] = {"color": TRUE_COLOR, "linewidth": 1.0, "zorder": 3, "label": "truth"}
    if not true:
        runs = len(latitude)
        name = "navigated" if runs == 1 else f"navigated, {runs} runs"
        thick = {"linewidth": 2.5} if runs == 1 else {"linewidth": 0.8, "alpha": 0.6}
        style = {"color": NAVIGATED_COLOR, **thick, "label": name}
    for number, (north, east) in enumerate(zip(latitude, longitude, strict=True)):
        axes.plot(east, north, **{**style, "label": style["label"] if number == 0 else None})


def _mark(axes: Axes, longitude: float, latitude: float, **style: Any) -> None:
    outline = {"linestyle": "none", "markersize": 8, "markeredgecolor": "black", "zorder": 4}
    axes.plot(longitude, latitude, **{**outline, **style})


def _draw_end(axes: Axes, flights: xr.Dataset) -> None:
    last = flights.isel(time=-1)
    east, north = (np.atleast_1d(last[f"{name}_error"].values) for name in ("east", "north"))
    reach = float(np.max(np.hypot(north, east)))
    axes.plot(0, 0, "+", color=TRUE_COLOR, markersize=12, label="truth")
    axes.plot(east, north, "o", color=NAVIGATED_COLOR, markersize=6, label="navigated")
    if "north_sigma" in flights:
        reach = max(reach, float(np.hypot(last["north_sigma"], last["east_sigma"])))
        axes.add_patch(_ellipse(last))
    limit = 1.25 * max(reach, 1e-4)
    axes.set_xlim(-limit, limit)
    axes.set_ylim(-limit, limit)
    axes.set_aspect("equal")
    axes.locator_params(nbins=6)
    axes.grid(alpha=0.3)
    axes.set_xlabel("east error, m")
    axes.set_ylabel("north error, m")
    axes.set_title(f"at the end, after {float(last['time']) / 3600:.3g} h", fontsize="medium")
    axes.legend(loc="best", fontsize="small", framealpha=0.9)


def _ellipse(last: xr.Dataset) -> Ellipse:
    """One-sigma ellipse of the position error, by the linear model."""
    cross = float(last["north_east_covariance"])
    east, north = float(last["east_sigma"]) ** 2, float(last["north_sigma"]) ** 2
    variances, axes = np.linalg.eigh(np.array([[east, cross], [cross, north]]))
    width, height = 2 * np.sqrt(np.maximum(variances, 0))
    angle = np.rad2deg(np.arctan2(axes[1, 0], axes[0, 0]))
    label = "1-sigma, linear model (39 %)"
    return Ellipse((0, 0), width, height, angle=angle, fill=False, color="tab:orange", label=label)
