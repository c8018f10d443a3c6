"""Alignment of a standing vehicle's record."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.analytic import analytic_alignment
from ins_eval.alignment.result import Alignment
from ins_eval.increments import Increments
from ins_eval.sensor_errors import SensorErrors

Array = NDArray[np.float64]


def align(record: Increments, position: Array, errors: SensorErrors) -> Alignment:
    """Attitude at the end of a record of a standing vehicle.

    Args:
        record: all of it is used.
        position: (3,) latitude, longitude (rad), height (m).
        errors: of the sensors; the covariance rests on them.

    Raises:
        AlignmentError: a record that can't be aligned on.
    """
    return analytic_alignment(record, position, errors)
