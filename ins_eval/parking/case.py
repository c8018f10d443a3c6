"""The cases that are compared: where level gyros' patterns start, and what is known of the bias."""

from dataclasses import dataclass
from enum import Enum


class Start(Enum):
    """Pattern angle of the level gyros at power-on."""

    AS_IT_COMES = "each gyro's own angle, of any value"
    ZERO = "parked where the map crosses its mean"
    FLAT = "parked where the map is flattest"


class Known(Enum):
    """What is taken out of the output."""

    MEAN = "the map's mean"
    AT_START = "of level gyros the map's value where the pattern stands when alignment begins"
    MAP = "bias and scale-factor maps of all gyros, by their electronics"


@dataclass(frozen=True)
class Case:
    """name: in files; label: in words. The vertical gyro starts as it comes in all of them."""

    name: str
    label: str
    start: Start
    known: Known


TODAY = Case("random_mean", "any angle, mean bias taken out", Start.AS_IT_COMES, Known.MEAN)
LIMIT = Case("map", "any angle, whole maps taken out", Start.AS_IT_COMES, Known.MAP)
CASES = (
    TODAY,
    Case(
        "random_at_start",
        "any angle, bias there taken out",
        Start.AS_IT_COMES,
        Known.AT_START,
    ),
    Case("zero_mean", "parked at a zero, mean bias taken out", Start.ZERO, Known.MEAN),
    Case("flat_at_start", "parked at an extreme, bias there taken out", Start.FLAT, Known.AT_START),
    LIMIT,
)
"""All cases; the others are compared with the first."""
