"""Checks of numeric arguments; a message names the argument, what was found and expected."""

import math

from pyhrg.common.errors import HrgError

HIGHEST_SEED = 2**63 - 1
"""Largest seed: the largest signed integer of 64 bits."""


def check_number(name: str, value: float, low: float, high: float) -> float:
    """The number, if it is finite and between the bounds, ends included.

    Raises:
        HrgError: it is not.
    """
    if not (math.isfinite(value) and low <= value <= high):
        raise HrgError(f"{name}: found {value:g}, expected a number from {low:g} to {high:g}")
    return float(value)


def check_whole_number(name: str, value: int, low: int, high: int) -> int:
    """The whole number, if it is between the bounds, ends included.

    Raises:
        HrgError: it is not.
    """
    if value != int(value) or not low <= value <= high:
        raise HrgError(f"{name}: found {value}, expected a whole number from {low} to {high}")
    return int(value)


def check_seed(value: int) -> int:
    """A seed of random numbers.

    Raises:
        HrgError: it is none.
    """
    return check_whole_number("seed", value, 0, HIGHEST_SEED)


def check_whole_minutes(name: str, hours: float, most_hours: float) -> int:
    """Hours as whole minutes, at least one.

    Raises:
        HrgError: the hours are out of range or no whole minutes.
    """
    minutes = hours * 60
    if not 0.98 <= minutes <= most_hours * 60 or abs(minutes - round(minutes)) > 0.02:
        raise HrgError(
            f"{name}: found {hours:g}, expected hours up to {most_hours:g} in whole minutes "
            "(1 min is 0.0167)"
        )
    return round(minutes)
