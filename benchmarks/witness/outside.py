"""What the estimate does when a mechanism changed that its prior holds for constant."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from pyhrg.fmu import GyroFmu
from pyhrg.witness.fit import fit_changes, measure_block_noise
from pyhrg.witness.mechanisms import change_device
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import TERMS, measure_output, measure_responses
from tests.pyhrg.witness.flights import GYRO, PRIOR, draw_changes, fly

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
DURATION, SEED = 600.0, 1


def compare_changes(fast: GyroFmu, slow: GyroFmu) -> Iterator[tuple[str, float, float, float]]:
    """Field, rms error of the bias map with the log and without it, rad/s, and p-value, of a flight
    in which that field and all that drifts have changed."""
    responses, noise = measure_responses(slow, GYRO), measure_block_noise(fast, GYRO)
    drifted = change_device(GYRO, draw_changes(PRIOR, np.random.default_rng(SEED)))
    for field, change in CHANGES.items():
        device = replace(drifted, **{field: getattr(drifted, field) + change})
        log = fly(fast, device, DURATION, SEED, self_test=True)
        found = fit_changes(fast, GYRO, read_witnesses(log, GYRO), PRIOR, responses, noise)
        true, estimated, believed = (
            measure_output(slow, each, found.temperature)[:TERMS]
            for each in (
                device,
                change_device(GYRO, found.changes),
                change_device(GYRO, PRIOR.mean),
            )
        )
        yield field, _rms(estimated - true), _rms(believed - true), found.p_value


def _rms(bias: np.ndarray) -> float:
    return float(np.sqrt(bias[0] ** 2 + np.sum(bias[1:] ** 2) / 2))
