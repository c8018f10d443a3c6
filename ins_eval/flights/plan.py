"""What a flight is asked to be."""

from dataclasses import dataclass
from typing import Literal

HeightMode = Literal["clamped", "free", "baro"]

WARM_UP = 20.0
"""Time from a simulated IMU's power-on to the beginning of alignment, s."""
ROW_SPACING = 10.0
"""Time between rows of the result, s: about, since steps must fit into it."""


@dataclass(frozen=True)
class Plan:
    """How to fly.

    interval: of the increments, s; count: of increments from time 0 on; keep_every: increments
    between rows of the result; samples: increments a navigation step, 2 to 4; height: what holds
    it; alignment: duration before time 0, without the warm-up, s, or None to start from the true
    attitude; seed: of everything random; runs: flights, each with an IMU of its own.
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
        """Of the flight, s."""
        return self.count * self.interval

    @property
    def row_spacing(self) -> float:
        """s."""
        return self.keep_every * self.interval


def rows(interval: float, samples: int) -> int:
    """Increments between rows: whole steps, about `ROW_SPACING`, that fill the minute if any do."""
    wanted = ROW_SPACING / interval
    minute = round(60 / interval)
    fitting = [n for n in range(samples, minute + 1, samples) if minute % n == 0]
    if abs(minute * interval - 60) > 1e-6 or not fitting:
        fitting = [samples * max(1, round(wanted / samples))]
    return min(fitting, key=lambda n: abs(n - wanted))
