"""Parts that the figures of all tests share."""

from collections.abc import Callable
from typing import Any, Literal, cast

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyhrg.common.errors import HrgError

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
"""Colours that are distinct for colour-blind readers too (Okabe and Ito)."""


def finish_axes(
    axes: Axes, x: str, y: str, grid: Literal["major", "both"] = "major", **limits: Any
) -> None:
    """Label axes, set limits (keywords of `Axes.set`), draw a faint grid and a legend."""
    axes.set(xlabel=x, ylabel=y, **limits)
    axes.grid(alpha=0.3, which=grid)
    axes.legend()


def draw_in_place(draw: Callable[[Figure], None], ax: Axes | None) -> list[Axes]:
    """The axes that a function draws into an empty figure: a new one, or in the place of `ax`.

    Raises:
        HrgError: `ax` has no place in a grid.
    """
    if ax is None:
        from matplotlib import pyplot

        figure = pyplot.figure(figsize=(8, 5), layout="constrained")
        draw(figure)
        return figure.axes
    place = ax.get_subplotspec()
    if place is None:
        raise HrgError("ax: found axes outside a grid, expected axes of plt.subplots")
    part = ax.figure.add_subfigure(place)
    ax.remove()
    draw(cast("Figure", part))  # a SubFigure draws as a Figure does
    return part.axes


def move_legends(figure: Figure) -> None:
    """Put each legend to the right of its axes, where no data are."""
    for axes in figure.axes:
        if legend := axes.get_legend():
            legend.set_loc("upper left")
            legend.set_bbox_to_anchor((1.0, 1.0))
