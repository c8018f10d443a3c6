"""Changes of a gyro's mechanisms that explain its forces (docs/methods/witness.md, Eq. 8)."""

from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD, GyroFmu
from pyhrg.witness.filter import filter_rows
from pyhrg.witness.information import factor_covariance
from pyhrg.witness.mechanisms import COUNT, SIGNALS, change_device
from pyhrg.witness.prior import Prior
from pyhrg.witness.replay import SETTLING, Witnesses, guess_course, replay
from pyhrg.witness.responses import FORCES, Responses, compute_design

ROUNDS = 4
"""Number of Gauss-Newton rounds. Derived: a decay time that is off by 2 % is off by 2 % of that
after each round, which is below its noise after four."""
COURSES = 2
"""Number of replays by which the course is found in each round. Derived: each leaves the gyro's
errors as a share of what the one before left, 1e-3."""
BLOCK = 5.0
"""Time over which rows are averaged before they are compared, s. Chosen: pick-off noise, which the
loops differentiate, is then below force noise, and the noise white."""
NOISE_BLOCKS = 600
"""Number of blocks of simulated noise. Chosen: levels are known to 3 %."""


@dataclass(frozen=True)
class FittedChanges:
    """What the forces say if nothing but the mechanisms made them.

    changes: (COUNT,) since the calibration, SI; covariance: of these; temperature, angle: of the
    resonator above the reference, K, and of the pattern, rad, at the end; burst_share: share of the
    rows that were limited; p_value: as of `Filtered`.
    """

    changes: Array
    covariance: Array
    temperature: float
    angle: float
    burst_share: float
    p_value: float


def fit_changes(
    fmu: GyroFmu,
    device: Device,
    witnesses: Witnesses,
    prior: Prior,
    responses: Responses,
    noise: Array,
) -> FittedChanges:
    """The mechanisms' changes by Gauss-Newton: each round replays the device with the changes of
    the last one, and filters all rows again.

    fmu: `HRG`; responses: of the device; noise: as of `measure_block_noise`.
    """
    root = factor_covariance(prior.covariance)
    changes, course = prior.mean, guess_course(device, witnesses)
    for _ in range(ROUNDS):
        changed = change_device(device, changes)
        for _ in range(COURSES):
            course = replay(fmu, changed, witnesses, course).following
        found = replay(fmu, changed, witnesses, course)
        design = _average(compute_design(responses.forces, found.motion), witnesses.interval)
        # what the rows say of the whole changes, not of this round's correction
        replayed = np.where(SIGNALS == "heating", 0.0, changes)
        values = _average(found.residuals, witnesses.interval) + design @ (replayed - prior.mean)
        filtered = filter_rows(design @ root, values, noise, np.eye(COUNT))
        changes = prior.mean + root @ filtered.mean
    return FittedChanges(
        changes=changes,
        covariance=root @ filtered.covariance @ root.T,
        temperature=float(found.motion.temperature[-1]),
        angle=float(witnesses.angle[-1]),
        burst_share=float(np.mean(filtered.weights < 1)),
        p_value=filtered.p_value,
    )


def measure_block_noise(fmu: GyroFmu, device: Device) -> Array:
    """(2,) standard deviation of a block's mean force of a gyro at rest, pick-off noise included.

    fmu: `HRG`.
    """
    steps = round(BLOCK / CONTROL_PERIOD)
    with fmu.power_on(device.fmu_parameters(), 1, 0.0) as gyro:
        moving = {"angularRate": np.zeros((NOISE_BLOCKS, steps))}
        _, means = gyro.record(moving, {}, CONTROL_PERIOD, [], FORCES)
    return np.asarray(np.std(np.diff(means[2:], axis=0), axis=0) / np.sqrt(2))


def _average(rows: Array, interval: float) -> Array:
    """Means over `BLOCK`, without the settling of the loops and what is left at the end."""
    length = max(1, round(BLOCK / interval))
    settled = rows[round(SETTLING / interval) :]
    count = len(settled) // length
    return np.asarray(
        settled[: count * length].reshape(count, length, *rows.shape[1:]).mean(axis=1)
    )
