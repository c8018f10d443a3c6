"""The bias that alignment hides: after a turn the east gyro's reappears as position error."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy.linalg import expm

from ins_eval.alignment.analytic import static_alignment
from ins_eval.alignment.gyrocompass import bias_sensitivity
from ins_eval.alignment.kalman import standing
from ins_eval.common import earth
from ins_eval.common.increments import Increments
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.state import State, position_error
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.trajectory import Knots, Trajectory
from pyhrg.common.units import DEG, DEG_PER_H, NAUTICAL_MILE

Array = NDArray[np.float64]

STILL = 300.0
"""Alignment, before time 0, s."""
TURN = 20.0
"""Duration of the turn after it, s."""
INTERVAL = 0.05
KEPT = 60.0
"""Between kept positions, s."""
TURNS_DEG = (0.0, 90.0, 180.0)


@dataclass(frozen=True)
class Growth:
    """time: (m,) s; flown, predicted: (m, 2) north and east position error, m."""

    time: Array
    flown: Array
    predicted: Array


def growth(latitude: float, bias: float, turn: float, duration: float) -> Growth:
    """Align heading north with a biased right gyro, turn on the spot, and stand.

    Args:
        latitude: rad; bias: rad/s; turn: rad; duration: after alignment, whole minutes, s.
    """
    ideal = _turning(latitude, turn, duration)
    total = round((STILL + duration) / INTERVAL)
    true = ideal.increments(-STILL, INTERVAL, total)
    biased = true.rotation + np.array([0.0, bias, 0.0]) * INTERVAL
    measured = Increments(INTERVAL, biased, true.velocity, -STILL)
    zero = round(STILL / INTERVAL)
    start = State(
        latitude, 0.0, 0.0, np.zeros(3), static_alignment(measured.between(0, zero), latitude)
    )
    flight = measured.between(zero, total)
    track = navigate(start, flight, Clamped(np.zeros(len(flight) + 1)), round(KEPT / INTERVAL))
    flown = position_error(track.position, np.array([latitude, 0.0, 0.0]))[:, :2]
    return Growth(track.time, flown, predicted(latitude, bias, turn, track.time - TURN / 2))


def predicted(latitude: float, bias: float, turn: float, time: Array) -> Array:
    """(m, 2) north and east position error, m, in closed form, after a sudden turn at time 0.

    The matrix exponential of the errors' constant dynamics: what alignment
    hid stays in the heading, and the bias points elsewhere.

    Args:
        latitude: rad; bias: of the right gyro, rad/s; turn: from north, rad; time: (m,) since, s.
    """
    turned = mat_from_euler(np.array(0.0), np.array(0.0), np.array(turn))
    biases = np.array([0.0, bias, *[0.0] * 4])
    initial = np.zeros(standing.STATES)
    initial[standing.ATTITUDE] = bias_sensitivity(latitude, earth.gravity(latitude, 0.0)) @ biases
    initial[standing.GYRO] = turned @ biases[:3]
    dynamics = standing.dynamics(latitude, 0.0)
    return np.array([(expm(dynamics * t) @ initial)[standing.DISPLACEMENT] for t in time])


def draw(latitude: float, bias: float, duration: float, path: Path) -> None:
    """Write the figure as PNG: radial position error without a turn, after 90 and 180 deg."""
    figure = Figure(figsize=(8, 5), layout="constrained")
    axes = figure.add_subplot()
    for turn, color in zip(TURNS_DEG, ("tab:green", "tab:orange", "tab:red"), strict=True):
        result = growth(latitude, bias, turn * DEG, duration)
        hours = result.time / 3600
        flown = np.hypot(*result.flown.T) / NAUTICAL_MILE
        closed = np.hypot(*result.predicted.T) / NAUTICAL_MILE
        label = f"turned by {turn:.0f} deg after alignment" if turn else "not turned"
        axes.plot(hours, flown, color=color, linewidth=2.2, label=label)
        axes.plot(hours, closed, color="black", linestyle=":", linewidth=1.4)
    axes.plot([], [], color="black", linestyle=":", label="closed form")
    axes.set_xlim(0, duration / 3600)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel("radial position error, nautical miles")
    axes.set_title(
        f"What alignment hides: an east gyro's bias of {bias / DEG_PER_H:g} deg/h, "
        f"at {latitude / DEG:g} deg"
    )
    axes.grid(alpha=0.25)
    axes.legend(loc="upper left")
    figure.savefig(path, dpi=120, metadata={"Software": None})


def _turning(latitude: float, turn: float, duration: float) -> Trajectory:
    time = np.arange(-STILL - 10.0, duration + 10.0, 1.0)
    s = np.clip(time / TURN, 0.0, 1.0)
    still = np.zeros_like(time)
    yaw = turn * s**3 * (10 - 15 * s + 6 * s**2)
    return Trajectory(
        "turn", Knots(time, np.full_like(time, latitude), still, still, still, still, yaw)
    )


if __name__ == "__main__":
    draw(40 * DEG, 0.01 * DEG_PER_H, 7200.0, Path("hidden-bias.png"))
