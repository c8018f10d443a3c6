"""A plain map: degrees on the axes, lengths true at the middle, a bar of kilometres."""

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
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
