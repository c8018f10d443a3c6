"""How far apart two colours look."""

import re

import numpy as np

SMALLEST_DIFFERENCE = 0.1
"""Smallest distance in OKLab of colours that stand for different things. A distance of 0.02 is just
noticeable."""
_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_LAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)


def measure_difference(one: str, other: str) -> float:
    """Distance in OKLab (Ottosson 2020) of two colours, "rgb(0, 114, 178)" or "#0072b2"."""
    return float(np.linalg.norm(_convert(one) - _convert(other)))


def _convert(colour: str) -> np.ndarray:
    if colour.startswith("#"):
        digits = colour[1:] if len(colour) == 7 else "".join(2 * digit for digit in colour[1:])
        levels = [int(digits[i : i + 2], 16) for i in (0, 2, 4)]
    else:
        levels = [int(level) for level in re.findall(r"\d+", colour)[:3]]
    encoded = np.array(levels) / 255
    linear = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    return np.asarray(_LAB @ np.cbrt(_CONES @ linear))
