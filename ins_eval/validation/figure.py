"""The figure of a validation: position-error growth, promised and flown."""

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ins_eval.metrics import median_interval
from ins_eval.validation.study import Validation
from pyhrg.units import DEG_PER_H, NAUTICAL_MILE


def draw(result: Validation, path: Path) -> None:
    """Write the figure as PNG."""
    hours = result.time / 3600
    figure = Figure(figsize=(8, 5), layout="constrained")
    axes = figure.add_subplot()
    for number, triad in enumerate(result.flown):
        label = f"flown, {len(result.flown)} triads" if number == 0 else None
        axes.plot(hours, triad / NAUTICAL_MILE, color="0.75", linewidth=0.8, label=label)
    median = np.median(result.flown, axis=0) / NAUTICAL_MILE
    axes.plot(hours, median, color="black", linewidth=2.2, label="flown, median (band: 95 %)")
    band = np.array([median_interval(radial) for radial in result.flown.T]) / NAUTICAL_MILE
    axes.fill_between(hours, band[:, 0], band[:, 1], color="black", alpha=0.15, linewidth=0)

    def promise(radial: NDArray[np.float64], stability: float, color: str, name: str) -> None:
        label = f"promised by the {name} test ({stability / DEG_PER_H:.2g} deg/h)"
        axes.plot(hours, radial / NAUTICAL_MILE, color, linestyle="--", linewidth=2, label=label)

    new, old = result.full_circumference, result.fixed_position
    promise(result.predicted_full_circumference, new.stability, "tab:blue", "full-circumference")
    promise(result.predicted_fixed_position, old.stability, "tab:red", "fixed-position")
    axes.set_yscale("log")
    floor = min(result.predicted_fixed_position[-1], median[-1] * NAUTICAL_MILE) / NAUTICAL_MILE
    axes.set_ylim(bottom=floor / 100)
    axes.set_xlim(0, hours[-1])
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel("radial position error, nautical miles")
    axes.set_title(f"Whole-angle HRG triads on {result.mission}: promised and flown")
    axes.grid(which="both", alpha=0.25)
    axes.legend(loc="lower right", framealpha=0.95)
    figure.savefig(path, dpi=120, metadata={"Software": None})
