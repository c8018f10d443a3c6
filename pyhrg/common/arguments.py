"""Checks of numeric arguments; a message names the argument, what was found and expected."""

import os
from numbers import Integral, Real
from typing import Any

from pyhrg.common.errors import HrgError, quote

MOST_WORKERS = 1024
"""Largest number of workers. Chosen: more than any machine has cores."""


def check_number(name: str, value: float, low: float, high: float) -> float:
    """The number, if it is finite and between the bounds, ends included."""
    if not _is_a(Real, value) or not low <= value <= high:
        found = f"{value:g}" if isinstance(value, float) else quote(value)
        raise HrgError(f"{name}: found {found}, expected a number from {low:g} to {high:g}")
    return float(value)


def check_whole_number(name: str, value: int, low: int, high: int) -> int:
    """The whole number, if it is between the bounds, ends included."""
    if not _is_a(Real, value) or not low <= value <= high or value != int(value):
        raise HrgError(
            f"{name}: found {quote(value)}, expected a whole number from {low} to {high}"
        )
    return int(value)


def check_seed(value: int) -> int:
    if not _is_a(Integral, value) or not 0 <= value < 2**63:
        raise HrgError(f"seed: found {quote(value)}, expected a whole number from 0 to 2^63 - 1")
    return int(value)


def choose_workers(workers: int | None) -> int:
    """Number of workers: the given one, or as many as this process has cores."""
    if workers is None:
        return count_cores()
    if not _is_a(Integral, workers) or not 1 <= workers <= MOST_WORKERS:
        expected = f"expected a whole number from 1 to {MOST_WORKERS}"
        raise HrgError(f"workers: found {quote(workers)}, {expected}")
    return int(workers)


def _is_a(kind: type, value: Any) -> bool:
    """Whether a value is a number of this kind; true and false are none."""
    return isinstance(value, kind) and not isinstance(value, bool)


def count_cores() -> int:
    """Number of cores that this process may use; of the machine's where the system does not say."""
    if hasattr(os, "sched_getaffinity"):  # Linux
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def check_whole_minutes(name: str, hours: float, most_hours: float) -> int:
    """Hours as whole minutes, at least one."""
    minutes = hours * 60
    if not 0.98 <= minutes <= most_hours * 60 or abs(minutes - round(minutes)) > 0.02:
        raise HrgError(
            f"{name}: found {hours:g}, expected hours up to {most_hours:g} in whole minutes "
            "(1 min is 0.0167)"
        )
    return round(minutes)
