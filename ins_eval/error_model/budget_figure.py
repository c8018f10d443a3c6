"""Figure of an error budget: weights over time, growth of the error, contributions by effect."""

from itertools import cycle

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ins_eval.error_model.error_budget import (
    BODY,
    COMPONENTS,
    INITIAL,
    Weights,
    separate_keys,
    sum_contributions,
)
from ins_eval.error_model.linear_model import AXES
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, HOUR

LINES = dict(zip(BODY, ("-", "--", ":"), strict=True))
HATCHES = dict(zip(BODY, ("", "////", "...."), strict=True))
"""An axis is told by its line and its hatch; colours belong to the effects."""
INITIAL_COLOUR = "0.5"
EFFECT_COLOURS = colormaps["tab10"](np.delete(np.arange(10), 7))
"""Colours of the effects; the eighth of the map is the grey of the initial errors."""
MAX_SHOWN_EFFECTS = 8
"""Largest number of effects that are shown apart; beyond it, the smallest are shown as one."""


def plot_budget(weights: Weights, budget: xr.Dataset, title: str = "Error budget") -> Figure:
    """Plot weights and the budget that `compute_budget` made of them."""
    figure = Figure(figsize=(11, 11), layout="constrained")
    rows = figure.subplots(3, 2, sharey="row")
    named = [separate_keys(effect)[0] for effect in budget.effect.values]
    contribution = _select_largest(budget.contribution.assign_coords(effect=named))
    for column, component in enumerate(COMPONENTS):
        own = contribution.sel(component=component)
        _plot_weights(rows[0, column], weights.model.time, weights.sensors[:, column, :AXES])
        initial = float(budget.initial.sum("state").sel(component=component))
        _plot_growth(rows[1, column], own.sum("axis"), initial)
        _plot_bars(rows[2, column], own.sum("time"), initial)
        for row, title_end in enumerate(
            ("weight of the gyros", "cumulative", "by effect and axis")
        ):
            rows[row, column].set_title(f"{component}: {title_end}")
            rows[row, column].grid(alpha=0.25)
    rows[0, 0].set_ylabel("final error per gyro error,\nm/arcsec, symlog axis")
    rows[1, 0].set_ylabel("contribution to the final error, m")
    rows[0, 1].legend(title="axis", fontsize="small")
    rows[2, 1].legend(handles=[_make_patch(axis) for axis in BODY], title="axis", fontsize="small")
    figure.legend(*rows[1, 0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
    north, east = sum_contributions(budget)
    figure.suptitle(
        f"{title}: final error {north:.4g} m north, {east:.4g} m east", parse_math=False
    )
    return figure


def _plot_weights(axes: Axes, bounds: Array, gyros: Array) -> None:
    """Plot weights (n, 3) in steps with bounds (n + 1,), s: linear near zero and logarithmic
    beyond, because those of the alignment are many times those of the flight."""
    hours, weights = 0.5 * (bounds[1:] + bounds[:-1]) / HOUR, gyros * ARCSEC
    for (axis, line), weight in zip(LINES.items(), weights.T, strict=True):
        axes.plot(hours, weight, "k", linestyle=line, linewidth=1.1, label=axis)
    axes.set_yscale("symlog", linscale=2, linthresh=max(float(np.median(np.abs(weights))), 1e-9))
    axes.set_xlabel("time, h")


def _plot_growth(axes: Axes, contribution: xr.DataArray, initial: float) -> None:
    hours = contribution.time / HOUR
    axes.set_prop_cycle(color=EFFECT_COLOURS)
    for effect in contribution.effect.values:
        axes.plot(hours, contribution.sel(effect=effect).cumsum("time"), label=effect)
    if initial:
        axes.axhline(initial, color=INITIAL_COLOUR, linestyle="--", label=INITIAL)
    total = initial + contribution.sum("effect").cumsum("time")
    axes.plot(hours, total, "k", linewidth=2, label="all")
    axes.set_xlabel("time, h")


def _plot_bars(axes: Axes, contribution: xr.DataArray, initial: float) -> None:
    """Plot three bars, one an axis, for each effect that is not 0, and one for initial errors."""
    rows: list[tuple[str, np.ndarray]] = []
    colours: list[Array] = []
    for effect, colour in zip(contribution.effect.values, cycle(EFFECT_COLOURS)):
        by_sensor = contribution.sel(effect=effect).values.reshape(2, len(BODY))
        shown = [
            (effect if sensor in effect else f"{effect}, {sensor}", values)
            for sensor, values in zip(("gyro", "accelerometer"), by_sensor, strict=True)
            if np.any(values != 0)
        ]
        rows += shown
        colours += [colour] * len(shown)
    places = -np.arange(float(len(rows)))
    for number, hatch in enumerate(HATCHES.values()):
        values = [row[1][number] for row in rows]
        axes.barh(
            places + 0.27 * (1 - number),
            values,
            height=0.25,
            color=colours,
            hatch=hatch,
            edgecolor="white",
            linewidth=0,
        )
    names = [row[0] for row in rows]
    if initial:
        names.append(INITIAL)
        places = np.append(places, -float(len(rows)))
        axes.barh(places[-1], initial, height=0.5, color=INITIAL_COLOUR)
    axes.set_yticks(places, names, fontsize="small")
    axes.set_xlabel("contribution to the final error, m")


def _make_patch(axis: str) -> Patch:
    return Patch(facecolor="0.4", hatch=HATCHES[axis], edgecolor="white", linewidth=0, label=axis)


def _select_largest(contribution: xr.DataArray) -> xr.DataArray:
    """Keep the largest contributions; sum those beyond `MAX_SHOWN_EFFECTS` into one."""
    if contribution.sizes["effect"] <= MAX_SHOWN_EFFECTS:
        return contribution
    size = abs(contribution.sum("time")).sum(("axis", "component"))
    order = contribution.effect.values[np.argsort(-size.values)]
    others = contribution.sel(effect=order[MAX_SHOWN_EFFECTS - 1 :]).sum("effect")
    others = others.expand_dims(effect=["others"])
    return xr.concat([contribution.sel(effect=order[: MAX_SHOWN_EFFECTS - 1]), others], "effect")
