"""The plan of a flight, from the numbers that a user gives."""

from dataclasses import dataclass
from typing import Literal, get_args

from ins_eval.alignment.align import MIN_DURATION
from ins_eval.mission_model.missions import SETTLING
from pyhrg.common.arguments import (
    check_number,
    check_seed,
    check_whole_minutes,
    check_whole_number,
)
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

HeightMode = Literal["clamped", "free", "baro"]
"""What holds the height: the true one, nothing, or a loop with the true one."""

ROW_SPACING = 10.0
"""Time between rows of the result that is aimed at, s; a whole number of steps must fit into it."""
LONGEST_HOURS = 24.0
LONGEST_ALIGNMENT = 7200.0
"""Longest time from power-on to time 0, s."""
MAX_INCREMENTS = 10_000_000
MAX_RUNS = 1000


@dataclass(frozen=True)
class Plan:
    """How to fly.

    Attributes:
        interval: duration of one increment, s.
        count: number of increments from time 0 on.
        keep_every: number of increments between rows of the result.
        samples: number of increments a navigation step, 2 to 4.
        height: height aiding: "clamped", "free" or "baro".
        alignment: duration before time 0 without the warm-up, s, or None to start from the true
            attitude.
        seed: seed of all random numbers.
        runs: number of flights, each with an IMU of its own.
    """

    interval: float
    count: int
    keep_every: int
    samples: int = 2
    height: HeightMode = "clamped"
    alignment: float | None = 300.0
    seed: int = 1
    runs: int = 1

    @property
    def duration(self) -> float:
        """Duration of the flight, s."""
        return self.count * self.interval

    @property
    def row_spacing(self) -> float:
        """Time between rows of the result, s."""
        return self.keep_every * self.interval


def plan_simulation(
    interval: float,
    *,
    hours: float = 1.0,
    samples: int = 2,
    height: HeightMode = "clamped",
    align_s: float | None = 300.0,
    seed: int = 1,
    runs: int = 1,
) -> Plan:
    """Plan of flights of a simulated IMU, whose increments last `interval` s; options as of
    `ins_eval.fly`."""
    spacing = count_row_increments(interval, check_whole_number("samples", samples, 2, 4))
    plan = Plan(
        interval,
        count=_count_increments(hours, interval, spacing),
        keep_every=spacing,
        samples=samples,
        height=_check_height(height),
        alignment=None if align_s is None else _check_alignment(align_s, SETTLING) - SETTLING,
        seed=check_seed(seed),
        runs=check_whole_number("runs", runs, 1, MAX_RUNS),
    )
    if plan.count > MAX_INCREMENTS:
        raise HrgError(
            f"hours: found {hours:g} at {1 / interval:g} Hz, {plan.count} increments; "
            f"expected at most {MAX_INCREMENTS}"
        )
    return plan


def plan_log(
    name: str,
    increments: Increments,
    *,
    hours: float | None = None,
    samples: int = 2,
    height: HeightMode = "clamped",
    align_s: float = 300.0,
) -> Plan:
    """Plan of the dead reckoning of a recorded log; options as of `ins_eval.fly_log`."""
    interval, alignment = increments.interval, _check_alignment(align_s)
    spacing = count_row_increments(interval, check_whole_number("samples", samples, 2, 4))
    count = (len(increments) - round(alignment / interval)) // spacing * spacing
    needed = spacing if hours is None else _count_increments(hours, interval, spacing)
    if count < needed:
        raise HrgError(
            f"{name}: lasts {increments.duration:g} s; expected {alignment:g} s of alignment "
            f"and {needed * interval:g} s of flight"
        )
    return Plan(
        interval,
        count if hours is None else needed,
        spacing,
        samples=samples,
        height=_check_height(height),
        alignment=alignment,
    )


def count_row_increments(interval: float, samples: int) -> int:
    """Number of increments between rows of the result: whole steps, about `ROW_SPACING`, that fill
    the minute if any number does."""
    wanted = ROW_SPACING / interval
    minute = round(60 / interval)
    fitting = [n for n in range(samples, minute + 1, samples) if minute % n == 0]
    if abs(minute * interval - 60) > 1e-6 or not fitting:
        fitting = [samples * max(1, round(wanted / samples))]
    return min(fitting, key=lambda n: abs(n - wanted))


def _count_increments(hours: float, interval: float, spacing: int) -> int:
    wanted = check_whole_minutes("hours", hours, LONGEST_HOURS) * 60 / interval
    return max(1, round(wanted / spacing)) * spacing


def _check_alignment(align_s: float, warm_up: float = 0.0) -> float:
    return check_number("align_s", align_s, warm_up + MIN_DURATION, LONGEST_ALIGNMENT)


def _check_height(height: HeightMode) -> HeightMode:
    if height not in get_args(HeightMode):
        expected = ", ".join(get_args(HeightMode))
        raise HrgError(f"height: found {height!r}, expected {expected}")
    return height
