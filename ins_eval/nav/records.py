"""Records that are aligned on: recorded logs, or a simulated IMU on a vehicle that stands."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.increments import Increments

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Record:
    """Increments of a standing vehicle; position: (3,) latitude, longitude (rad), height (m);
    mat_nb: true attitude at the record's end, None if it isn't known."""

    name: str
    increments: Increments
    position: Array
    mat_nb: Array | None = None
