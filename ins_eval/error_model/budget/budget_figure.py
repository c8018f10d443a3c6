"""The figure of a budget: what weighs when, how the error comes about, and whose it is."""

from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.error_model.budget.adjoint import BODY, COMPONENTS, Weights, labelled
from ins_eval.error_model.budget.budget import total
from pyhrg.common.units import ARCSEC, HOUR

COLOURS = dict(zip(BODY, ("tab:blue", "tab:orange", "tab:green"), strict=True))
INITIAL, INITIAL_COLOUR = "initial errors", "0.5"
SHOWN = 8
"""Effects with a line and bars of their own; the smallest are shown as one if there are more."""


def draw(found: Weights, shares: xr.Dataset, path: Path, title: str = "Error budget") -> None:
    """Write the figure of weights and of `budget.budget` as PNG."""
    figure = Figure(figsize=(11, 11), layout="constrained")
    rows = figure.subplots(3, 2, sharey="row")
    contribution = _largest(shares.contribution)
    for column, component in enumerate(COMPONENTS):
        own = contribution.sel(component=component)
        _weights(rows[0, column], labelled(found).gyro.sel(component=component) * ARCSEC)
        initial = float(shares.initial.sum("state").sel(component=component))
        _growth(rows[1, column], own.sum("axis"), initial)
        _bars(rows[2, column], own.sum("time"), initial)
        for row, what in enumerate(("weight of the gyros", "made up by then", "by effect, axis")):
            rows[row, column].set_title(f"{component}: {what}")
            rows[row, column].grid(alpha=0.25)
    rows[0, 0].set_ylabel("final error per gyro's error, m/arcsec")
    rows[1, 0].set_ylabel("part of the final error, m")
    rows[0, 1].legend(title="axis", fontsize="small")
    figure.legend(*rows[1, 0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
    north, east = total(shares)
    figure.suptitle(f"{title}: final error {north:.4g} m north, {east:.4g} m east")
    figure.savefig(path, dpi=120, metadata={"Software": None})


def _weights(axes: Axes, weight: xr.DataArray) -> None:
    """Linear near zero, logarithmic beyond: alignment weighs many times what a flight does."""
    for axis, colour in COLOURS.items():
        axes.plot(weight.time / HOUR, weight.sel(axis=axis), colour, linewidth=0.9, label=axis)
    axes.set_yscale(
        "symlog", linscale=2, linthresh=max(float(np.median(np.abs(weight.values))), 1e-9)
    )
    axes.set_xlabel("time, h")


def _growth(axes: Axes, contribution: xr.DataArray, initial: float) -> None:
    hours = contribution.time / HOUR
    axes.set_prop_cycle(color=colormaps["Dark2"](np.arange(SHOWN)))
    for effect in contribution.effect.values:
        axes.plot(hours, contribution.sel(effect=effect).cumsum("time"), label=effect)
    if initial:
        axes.axhline(initial, color=INITIAL_COLOUR, linestyle="--", label=INITIAL)
    total = initial + contribution.sum("effect").cumsum("time")
    axes.plot(hours, total, "k", linewidth=2, label="all")
    axes.set_xlabel("time, h")


def _bars(axes: Axes, contribution: xr.DataArray, initial: float) -> None:
    """Three bars, one an axis, for each effect in gyros and in accelerometers that has any; one for
    what the start was off by."""
    rows: list[tuple[str, np.ndarray]] = []
    for effect in contribution.effect.values:
        by_sensor = contribution.sel(effect=effect).values.reshape(2, len(BODY))
        rows += [
            (effect if sensor in effect else f"{effect}, {sensor}", values)
            for sensor, values in zip(("gyro", "accelerometer"), by_sensor, strict=True)
            if np.any(values != 0)
        ]
    places = -np.arange(float(len(rows)))
    for number, colour in enumerate(COLOURS.values()):
        values = [row[1][number] for row in rows]
        axes.barh(places + 0.27 * (1 - number), values, height=0.25, color=colour)
    names = [row[0] for row in rows]
    if initial:
        names.append(INITIAL)
        places = np.append(places, -float(len(rows)))
        axes.barh(places[-1], initial, height=0.5, color=INITIAL_COLOUR)
    axes.set_yticks(places, names, fontsize="small")
    axes.set_xlabel("part of the final error, m")


def _largest(contribution: xr.DataArray) -> xr.DataArray:
    """The effects that matter most in the end, those beyond `SHOWN` summed into one."""
    if contribution.sizes["effect"] <= SHOWN:
        return contribution
    size = abs(contribution.sum("time")).sum(("axis", "component"))
    order = contribution.effect.values[np.argsort(-size.values)]
    others = contribution.sel(effect=order[SHOWN - 1 :]).sum("effect")
    others = others.expand_dims(effect=["others"])
    return xr.concat([contribution.sel(effect=order[: SHOWN - 1]), others], "effect")
