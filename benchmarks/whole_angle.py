"""The picture of docs/start/student.md: `python -m benchmarks.whole_angle FILE`."""

import sys

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import pyhrg

SWING = 0.25
"""Vibration of the drawn rim over its radius; a real one is a millionth."""
CASE_TURN_DEG = 90.0
DPI = 100


def draw_pattern(axes: Axes, case_deg: float, pattern_deg: float, title: str) -> None:
    """Draw the rim and its vibration from above, at angles of the case and, in it, the pattern."""
    around = np.linspace(0.0, 2 * np.pi, 361)
    wave, case = np.radians(case_deg + pattern_deg), np.radians(case_deg)
    axes.plot(np.cos(around), np.sin(around), color="0.7")
    for swing in (SWING, -SWING):
        radius = 1 + swing * np.cos(2 * (around - wave))
        axes.plot(radius * np.cos(around), radius * np.sin(around), color="tab:orange")
    ends = np.array([-1.45, 1.45])
    axes.plot(ends * np.cos(wave), ends * np.sin(wave), "--", color="tab:orange", label="pattern")
    mark = np.array([1.0, 1.45])
    axes.plot(mark * np.cos(case), mark * np.sin(case), "k", linewidth=4, label="mark on the case")
    axes.set(aspect="equal", xlim=(-1.6, 1.6), ylim=(-1.6, 1.6), title=title)
    axes.axis("off")


def draw_bias_map(axes: Axes) -> None:
    """Draw the bias map of the gyro `typical`, and the only point that a resting test sees."""
    found = pyhrg.run_test("full-circumference", "typical", seed=1).findings["value"]
    pattern = np.linspace(0.0, 180.0, 181)
    fourth = [np.cos(4 * np.radians(pattern)), np.sin(4 * np.radians(pattern))]
    bias = found["mean_of_the_map_deg_per_h"] + (
        found["bias_cos4_deg_per_h"] * fourth[0] + found["bias_sin4_deg_per_h"] * fourth[1]
    )
    axes.plot(pattern, bias)
    axes.plot(pattern[10], bias[10], "o", color="tab:red", label="all that a resting test sees")
    axes.set(xlabel="pattern angle, deg", ylabel="bias, deg/h", xticks=range(0, 181, 45))
    axes.set_title("bias over the pattern angle")
    axes.set_ylim(bias.min() - 0.02, bias.max() + 0.09)
    axes.grid(alpha=0.25)
    axes.legend(loc="upper left")


def draw() -> Figure:
    figure = Figure(figsize=(11, 3.8), layout="constrained")
    before, after, bias = figure.subplots(1, 3, width_ratios=(1, 1, 1.3))
    gain = pyhrg.load_device("typical").bryan_factor
    draw_pattern(before, 0.0, 10.0, "at power-on")
    draw_pattern(after, CASE_TURN_DEG, 10.0 - gain * CASE_TURN_DEG, "the case turned by 90 deg")
    before.legend(loc="lower left", fontsize="small")
    draw_bias_map(bias)
    return figure


if __name__ == "__main__":
    draw().savefig(sys.argv[1], dpi=DPI)
