"""What the estimate does when a mechanism changed that its prior holds for constant."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.witness.electronics import read_change
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import TERMS
from pyhrg.witness.estimate import SIGNIFICANCE
from pyhrg.witness.estimator import arrange_parameters
from pyhrg.witness.fit import Flown, fit_changes
from pyhrg.witness.mechanisms import change_device
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import measure_channels, measure_output, measure_responses
from tests.pyhrg.witness.flights import GYRO, PRIOR, compute_rms, draw_changes, fly

CHANGES = {
    "drive_frame_rotation": 1e-5,
    "frequency_split": 2e-5,
    "phase_error": 4e-5,
    "residual_quadrature": 1e-6,
    "demodulation_offset": 1e-6,
    "feedthrough": 2e-5,
    "pickoff_cubic": 1e-5,
}
"""Changes of the device's fields, SI. Chosen: of the size of the study's drift, 1 to 10 % of the
mechanism."""
DURATION, FLIGHTS = 600.0, 6


@dataclass(frozen=True)
class Compared:
    """A field that changed, beside all that drifts, in some flights.

    estimated, believed, corrected: (n,) rms error over the circumference of the bias map by the
    estimate, without the log, and by the electronics, rad/s; p_values: (n,) of the estimates;
    electronics_followed: (n,) whether the electronics follow theirs.
    """

    field: str
    estimated: Array
    believed: Array
    corrected: Array
    p_values: Array
    electronics_followed: Array

    @property
    def followed(self) -> Array:
        """(n,) which logs are followed."""
        return self.p_values > SIGNIFICANCE

    @property
    def ratio(self) -> Array:
        """(n,) error with the log over that without it; 1 where it is not followed."""
        return np.where(self.followed, self.estimated / self.believed, 1.0)


def compare_changes(fast: GyroFmu, slow: GyroFmu, correcting: GyroFmu) -> Iterator[Compared]:
    responses = measure_responses(slow, GYRO)
    (channels,) = measure_channels(slow, [GYRO])
    parameters = arrange_parameters(GYRO, PRIOR, channels[0], responses)
    drifted = [
        change_device(GYRO, draw_changes(PRIOR, np.random.default_rng(seed)))
        for seed in range(FLIGHTS)
    ]
    for field, change in CHANGES.items():
        devices = [replace(d, **{field: getattr(d, field) + change}) for d in drifted]
        logs = [fly(fast, d, DURATION, seed, self_test=True) for seed, d in enumerate(devices)]
        gyros = [Flown(GYRO, read_witnesses(log, GYRO), PRIOR, responses) for log in logs]
        errors, followed = [], []
        fits = fit_changes(fast, slow, gyros)
        for seed, (device, found) in enumerate(zip(devices, fits, strict=True)):
            true, estimated, believed, calibrated = (
                measure_output(slow, each, found.temperature)[:TERMS]
                for each in (
                    device,
                    change_device(GYRO, found.changes),
                    change_device(GYRO, PRIOR.mean),
                    GYRO,
                )
            )
            change, is_followed = read_change(
                correcting, replace(device, model=parameters), DURATION, seed, self_test=True
            )
            maps = (estimated, believed, calibrated + change)
            errors.append([compute_rms(each - true) for each in maps])
            followed.append(is_followed)
        p_values = np.array([each.p_value for each in fits])
        yield Compared(field, *np.array(errors).T, p_values, np.array(followed))
