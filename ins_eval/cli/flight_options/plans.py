"""Plans from options."""

import argparse
from typing import Any

from ins_eval.alignment.align import SHORTEST
from ins_eval.common.increments import Increments
from ins_eval.flights.plan import WARM_UP, Plan, rows
from pyhrg.common.errors import HrgError
from pyhrg.common.option_numbers import minutes, number, whole

HOURS, SAMPLES, ALIGNMENT, SEED, RUNS = "1", "2", "300", "1", "1"
"""Unless options say otherwise."""
LONGEST_HOURS = 24.0
MOST_INCREMENTS = 10_000_000


def add_options(parser: argparse.ArgumentParser) -> None:
    """Those that a plan is made of."""
    add = parser.add_argument
    add(
        "--hours",
        metavar="H",
        help=f"flight, in whole minutes (default {HOURS}; of a log, what it holds)",
    )
    add("--rate-hz", metavar="HZ", help="of the increments, 10 to 2000 (default: the IMU's)")
    add("--samples", metavar="N", default=SAMPLES, help="increments a step, 2 to 4 "
        f"(default {SAMPLES})")  # fmt: skip
    add("--height", choices=("clamped", "free", "baro"), default="clamped", help="what holds the "
        "height: the true one, nothing, or a loop with the true one (default clamped)")  # fmt: skip
    start = parser.add_mutually_exclusive_group()
    start.add_argument("--align-s", metavar="S", help="from power-on to time 0, alignment in it "
                       f"(default {ALIGNMENT})")  # fmt: skip
    start.add_argument("--start-from-truth", action="store_true", help="no alignment")
    add("--seed", metavar="N", help=f"of everything random (default {SEED})")
    add("--runs", metavar="N", help=f"flights, each with an IMU of its own (default {RUNS})")


def rate(options: argparse.Namespace) -> int | None:
    """That is asked for, Hz.

    Raises:
        HrgError: out of range.
    """
    return None if options.rate_hz is None else whole("--rate-hz", options.rate_hz, 10, 2000)


def of_simulation(options: argparse.Namespace, interval: float) -> Plan:
    """A flight of an IMU with increments over this interval, s.

    Raises:
        HrgError: an option out of range.
    """
    hours = options.hours or HOURS
    spacing = rows(interval, _samples(options))
    wanted = minutes("--hours", hours, LONGEST_HOURS) * 60 / interval
    plan = Plan(
        interval,
        count=max(1, round(wanted / spacing)) * spacing,
        keep_every=spacing,
        alignment=None if options.start_from_truth else _alignment(options, WARM_UP) - WARM_UP,
        seed=whole("--seed", options.seed or SEED, 0, 2**63 - 1),
        runs=whole("--runs", options.runs or RUNS, 1, 1000),
        **_navigator(options),
    )
    if plan.count > MOST_INCREMENTS:
        raise HrgError(
            f"--hours {hours} at {1 / interval:g} Hz: {plan.count} increments; "
            f"expected at most {MOST_INCREMENTS}"
        )
    return plan


def of_log(options: argparse.Namespace, log: str, increments: Increments) -> Plan:
    """A flight of what a log holds after alignment, or of the hours that are asked for.

    Raises:
        HrgError: an option out of range or for simulations only, or too short a log.
    """
    for option in ("rate_hz", "seed", "runs", "start_from_truth"):
        if getattr(options, option):
            flag = "--" + option.replace("_", "-")
            raise HrgError(f"{flag}: is for simulated IMUs, and {log} is a recorded one")
    interval, alignment = increments.interval, _alignment(options)
    spacing = rows(interval, _samples(options))
    count = (len(increments) - round(alignment / interval)) // spacing * spacing
    needed = spacing
    if options.hours:
        asked = minutes("--hours", options.hours, LONGEST_HOURS) * 60 / interval
        needed = max(1, round(asked / spacing)) * spacing
    if count < needed:
        raise HrgError(
            f"{log}: lasts {increments.duration:g} s; expected {alignment:g} s of alignment "
            f"and {needed * interval:g} s of flight"
        )
    count = needed if options.hours else count
    return Plan(interval, count, spacing, alignment=alignment, **_navigator(options))


def _navigator(options: argparse.Namespace) -> dict[str, Any]:
    return {"samples": _samples(options), "height": options.height}


def _samples(options: argparse.Namespace) -> int:
    return whole("--samples", options.samples, 2, 4)


def _alignment(options: argparse.Namespace, warm_up: float = 0.0) -> float:
    return number("--align-s", options.align_s or ALIGNMENT, warm_up + SHORTEST, 7200)
