"""Distances in nautical miles and kilometres, in the same words everywhere."""

from pyhrg.common.pages.svg import format_number
from pyhrg.common.units import NAUTICAL_MILE

NMI = "nmi (1 nmi = 1.852 km)"
"""Unit of an axis or a table whose numbers are nautical miles."""
DIGITS = 2
"""Significant digits of a distance in a sentence. Chosen: intervals are wider."""
_UP = 1 + 1e-12
"""Factor by which ties are rounded up, as the page's script rounds them."""


def format_distance(metres: float) -> str:
    """A distance, such as 3.9 nmi (7.3 km)."""
    return f"{_format_miles(metres)} nmi ({_format_kilometres(metres)} km)"


def format_range(low: float, high: float) -> str:
    """A range of distances, m, such as 0.19 to 10 nmi (0.35 to 19 km)."""
    miles, kilometres = (
        f"{show(low)} to {show(high)}" for show in (_format_miles, _format_kilometres)
    )
    return f"{miles} nmi ({kilometres} km)"


def _format_miles(metres: float) -> str:
    return format_number(metres / NAUTICAL_MILE * _UP, DIGITS)


def _format_kilometres(metres: float) -> str:
    return format_number(metres / 1000 * _UP, DIGITS)
