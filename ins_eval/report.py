"""Files of a validation: JSON, CSV and the figure, all or none."""

import csv
import json
import os
import shutil
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

from ins_eval.metrics import median_interval
from ins_eval.study import Validation
from ins_eval.verdict import Ratio, ratio, verdict

Array = NDArray[np.float64]

SCHEMA = "hrg-validation/1"
NAUTICAL_MILE = 1852.0
DEG_PER_H = np.pi / 180 / 3600


class Staging:
    """A folder aside, whose files appear in `out` together or not at all.

    Raises:
        OSError: on entry, if the output folder can't be written.
    """

    def __init__(self, out: Path) -> None:
        self.out = out
        self.aside = out.parent / f".{out.name}.{os.getpid()}"

    def __enter__(self) -> Path:
        if self.out.exists() and not os.access(self.out, os.W_OK | os.X_OK):
            raise PermissionError(13, "Permission denied")
        if self.out.exists() and not self.out.is_dir():
            raise NotADirectoryError(20, "Not a directory")
        self.aside.mkdir(parents=True)
        return self.aside

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        try:
            if kind is None:
                self.out.mkdir(exist_ok=True)
                for file in sorted(self.aside.iterdir()):
                    os.replace(file, self.out / file.name)
        finally:
            shutil.rmtree(self.aside, ignore_errors=True)


def ratios(result: Validation) -> tuple[Ratio, Ratio]:
    """Flown over promised at the mission's end: fixed position, full circumference."""
    flown = result.flown[:, -1]
    return (
        ratio(flown, float(result.predicted_fixed_position[-1])),
        ratio(flown, float(result.predicted_full_circumference[-1])),
    )


def summary(result: Validation) -> str:
    """What a person wants to read: the table, the figures and the verdict."""
    flown = result.flown[:, -1] / NAUTICAL_MILE
    low, high = median_interval(flown)
    lines = [
        result.table,
        "",
        f"Radial position error after {result.hours:g} h of {result.mission}, nautical miles (median):",
        f"  promised by the fixed-position test      {result.predicted_fixed_position[-1] / NAUTICAL_MILE:8.3f}",
        f"  promised by the full-circumference test  {result.predicted_full_circumference[-1] / NAUTICAL_MILE:8.3f}",
        f"  flown by {len(flown)} triads" + " " * (22 - len(str(len(flown)))) + f"        {np.median(flown):8.3f}   (95 %: {low:.3f} to {high:.3f})",
        "",
        verdict(*ratios(result)),
    ]
    return "\n".join(lines)


def write(result: Validation, folder: Path) -> None:
    """Write validation.json, position_error.csv and validation.png into an existing folder."""
    text = json.dumps(document(result), indent=2) + "\n"
    (folder / "validation.json").write_text(text)
    _write_errors(result, folder / "position_error.csv")
    _draw(result, folder / "validation.png")


def document(result: Validation) -> dict[str, Any]:
    """Content of validation.json."""
    flown = result.flown[:, -1] / NAUTICAL_MILE
    fixed, circumference = ratios(result)

    def bench(name: str) -> dict[str, Any]:
        test = getattr(result, name)
        return {
            "bias_stability_deg_per_h": test.stability / DEG_PER_H,
            "bias_repeatability_deg_per_h": test.repeatability / DEG_PER_H,
            "bias_deg_per_h": test.bias / DEG_PER_H,
            "runs": [
                {
                    "mean_deg_per_h": run.mean / DEG_PER_H,
                    "standard_deviation_deg_per_h": run.deviation / DEG_PER_H,
                    "points": len(run.points),
                }
                for run in test.runs
            ],
        }

    def promise(radial: Array, kept: Ratio) -> dict[str, Any]:
        return {
            "radial_error_nmi": float(radial[-1]) / NAUTICAL_MILE,
            "flown_over_predicted": kept.value,
            "flown_over_predicted_interval_95": [kept.low, kept.high],
            "judged": kept.word,
        }

    return {
        "schema": SCHEMA,
        "seed": result.seed,
        "hours": result.hours,
        "mission": result.mission,
        "bench": {name: bench(name) for name in ("fixed_position", "full_circumference")},
        "predicted": {
            "fixed_position": promise(result.predicted_fixed_position, fixed),
            "full_circumference": promise(result.predicted_full_circumference, circumference),
        },
        "flown": {
            "radial_error_nmi": float(np.median(flown)),
            "interval_95_nmi": list(median_interval(flown)),
            "n": len(flown),
            "triads_nmi": flown.tolist(),
        },
        "verdict": verdict(fixed, circumference),
    }


def _write_errors(result: Validation, path: Path) -> None:
    names = [f"triad_{i + 1:03}_m" for i in range(len(result.flown))]
    predicted = ["predicted_fixed_position_m", "predicted_full_circumference_m"]
    columns = np.column_stack(
        [
            result.time,
            result.predicted_fixed_position,
            result.predicted_full_circumference,
            np.median(result.flown, axis=0),
            result.flown.T,
        ]
    )
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["time_s", *predicted, "flown_median_m", *names])
        writer.writerows([f"{value:.6g}" for value in row] for row in columns)


def _draw(result: Validation, path: Path) -> None:
    hours = result.time / 3600
    figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
    for number, triad in enumerate(result.flown):
        label = f"flown, {len(result.flown)} triads" if number == 0 else None
        axes.plot(hours, triad / NAUTICAL_MILE, color="0.75", linewidth=0.8, label=label)
    median = np.median(result.flown, axis=0) / NAUTICAL_MILE
    axes.plot(hours, median, color="black", linewidth=2.2, label="flown, median")
    for promised, color, name, test in (
        (result.predicted_full_circumference, "tab:blue", "full-circumference", result.full_circumference),
        (result.predicted_fixed_position, "tab:red", "fixed-position", result.fixed_position),
    ):
        label = f"promised by the {name} test ({test.stability / DEG_PER_H:.2g} deg/h)"
        axes.plot(hours, promised / NAUTICAL_MILE, color=color, linestyle="--", linewidth=2, label=label)
    axes.set_yscale("log")
    axes.set_ylim(bottom=max(1e-3, float(result.predicted_fixed_position[0]) / NAUTICAL_MILE))
    axes.set_xlim(0, hours[-1])
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel("radial position error, nautical miles")
    axes.set_title(f"Whole-angle HRG triads on {result.mission}: promised and flown")
    axes.grid(which="both", alpha=0.25)
    axes.legend(loc="lower right", framealpha=0.95)
    figure.savefig(path, dpi=120, metadata={"Software": None})
    plt.close(figure)
