"""Figure of an alignment: heading, pitch and roll over time, with their one-sigma."""

import numpy as np
from matplotlib.figure import Figure

from ins_eval.alignment.result import Alignment, History, euler_from_rotation_vector
from ins_eval.common.rotation import euler_from_mat
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG

ANGLES = (("heading", 2, "tab:blue"), ("pitch", 1, "tab:orange"), ("roll", 0, "tab:green"))
UNSCALED_PART = 0.1
"""First part of the record, which the scale of the axes ignores. Chosen."""


def plot_alignment(result: Alignment, name: str = "") -> Figure:
    """Plot heading, pitch and roll over the record, with their one-sigma."""
    time, euler, sigma = result.history.time, *euler_history_deg(result.history)
    figure = Figure(figsize=(8, 7), layout="constrained")
    rows = figure.subplots(3, 1, sharex=True)
    for axes, (angle, column, color) in zip(rows, ANGLES, strict=True):
        value, band = euler[:, column], sigma[:, column]
        axes.fill_between(time, value - band, value + band, color=color, alpha=0.25, linewidth=0)
        axes.plot(time, value, color=color)
        later = slice(round(UNSCALED_PART * len(time)), None)
        low, high = np.min((value - band)[later]), np.max((value + band)[later])
        axes.set_ylim(low - 0.1 * (high - low), high + 0.1 * (high - low))
        axes.set_ylabel(f"{angle}, deg")
        axes.ticklabel_format(useOffset=False)
        axes.grid(alpha=0.25)
        last = f"{angle} {value[-1]:.4f} ± {band[-1]:.4f} deg (one sigma, band)"
        axes.set_title(last, loc="left", fontsize="medium")
    figure.suptitle(f"Alignment, fine{f': {name}' if name else ''}", parse_math=False)
    rows[-1].set_xlabel("time, s")
    rows[-1].set_xlim(time[0], time[-1])
    return figure


def euler_history_deg(history: History) -> tuple[Array, Array]:
    """Return roll, pitch, heading (m, 3), deg, and their one-sigma (m, 3); the heading has no jumps
    and ends between 0 and 360."""
    euler = np.stack(euler_from_mat(history.mat_nb), axis=-1)
    turns = np.array([euler_from_rotation_vector(mat_nb) for mat_nb in history.mat_nb])
    variance = np.einsum("mij,mjk,mik->mi", turns, history.covariance, turns)
    euler[:, 2] = np.unwrap(euler[:, 2])
    euler[:, 2] += np.remainder(euler[-1, 2], 2 * np.pi) - euler[-1, 2]
    return euler / DEG, np.sqrt(variance) / DEG
