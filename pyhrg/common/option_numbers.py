"""Numbers on the command line."""

import math
from collections.abc import Callable

from pyhrg.common.errors import HrgError


def whole(option: str, text: str, low: int, high: int) -> int:
    """Read a whole number.

    Raises:
        HrgError: names the option, what was found and what is expected.
    """
    value = _read(int, text)
    if not low <= value <= high:
        raise HrgError(f"{option} {text}: expected a whole number from {low} to {high}")
    return int(value)


def number(option: str, text: str, low: float, high: float) -> float:
    """Read a number.

    Raises:
        HrgError: names the option, what was found and what is expected.
    """
    value = _read(float, text)
    if not low <= value <= high:
        raise HrgError(f"{option} {text}: expected a number from {low:g} to {high:g}")
    return value


def minutes(option: str, hours: str, most: float) -> int:
    """Read hours that are whole minutes, at least one.

    Raises:
        HrgError: names the option, what was found and what is expected.
    """
    value = _read(float, hours) * 60
    if not 0.98 <= value <= most * 60 or abs(value - round(value)) > 0.02:
        raise HrgError(
            f"{option} {hours}: expected hours up to {most:g}, in whole minutes (1 min is 0.0167)"
        )
    return round(value)


def _read(kind: Callable[[str], float], text: str) -> float:
    """Its value; NaN, which lies in no range, if it is none."""
    try:
        return kind(text)
    except ValueError:
        return math.nan
