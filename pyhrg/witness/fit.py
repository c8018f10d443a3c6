"""Changes of a gyro's mechanisms that explain its forces (docs/methods/witness.md, Eq. 8)."""

from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD, GyroFmu, record_together
from pyhrg.witness.design import Motion, compute_change_design, evaluate_motion
from pyhrg.witness.filter import filter_rows
from pyhrg.witness.following import begin, follow, follow_slowly
from pyhrg.witness.information import compute_normalized_square, factor_covariance
from pyhrg.witness.mechanisms import COUNT, FOLLOWED, TEMPERATURE_RATE, change_device
from pyhrg.witness.prior import Prior
from pyhrg.witness.replay import SETTLING, Replay, Witnesses
from pyhrg.witness.responses import FORCES, Responses, measure_responses

STAGES = 6
"""Largest number of times that the gyro is replayed with the changes of the time before. Chosen:
four are usual."""
CONVERGENCE_CHI2 = 1.0
"""The fit has converged when a stage moves no gyro's changes by more than this, as a normalised
square. Chosen."""
CORRECTION_CHI2 = 10.0
"""Largest move of the changes, as a normalised square, that what `HRG` shows beyond `HRGSlow` is
taken to survive. Derived: a move by 2e5 made it wrong by 235, so 10 makes it wrong by 0.01."""
BLOCK = 5.0
"""Time over which rows are averaged before they are compared, s. Chosen: pick-off noise, which the
loops differentiate, is then below force noise."""
SIGNIFICANCE = 1e-3
"""Probability of innovations below which the model is said not to hold. Chosen."""
MOST_BURSTS = 0.15
"""Largest share of a log's rows that may be bursts. More are no bursts, but forces that do not go
together with the pattern angle, as where their clocks run apart. Chosen: bursts in a tenth of the
rows leave the estimate consistent (tests/pyhrg/witness/test_filter.py)."""
SCATTER_BLOCKS = 200
"""Number of blocks of simulated noise by which bursts are judged. Chosen: known to 5 %."""


@dataclass(frozen=True)
class Flown:
    """One gyro of a fit.

    Attributes:
        device: the gyro as it is believed.
        witnesses: witness channels of the gyro's flight.
        prior: prior of the gyro's changes.
        responses: responses of the device; its noise is that of the forces.
        delay_sigma: standard deviation of the prior of the time by which the amplitude force was
            recorded late, s; the other channels have one clock.
    """

    device: Device
    witnesses: Witnesses
    prior: Prior
    responses: Responses
    delay_sigma: float = 0.0


@dataclass(frozen=True)
class FittedChanges:
    """Changes that explain the forces if nothing but the mechanisms made them.

    Attributes:
        changes: (COUNT,) since the calibration, SI.
        covariance: (COUNT, COUNT) covariance of the changes.
        responses: sensitivities of the changed gyro.
        temperature, angle: temperature of the resonator above its reference, K, and pattern angle,
            rad, at the log's end.
        burst_share: share of the rows that were limited.
        p_value: probability of innovations as far from white as these, if the model holds.
        moved: normalised square of what the last stage changed.
        delay, delay_sigma: time by which the amplitude force was recorded late, with its standard
            deviation, s.
    """

    changes: Array
    covariance: Array
    responses: Responses
    temperature: float
    angle: float
    burst_share: float
    p_value: float
    moved: float
    delay: float
    delay_sigma: float

    @property
    def is_explained(self) -> bool:
        """Whether the mechanisms explain the forces. Changes of others are not to be followed."""
        are_bursts = self.burst_share <= MOST_BURSTS
        return are_bursts and self.p_value > SIGNIFICANCE and self.moved < CONVERGENCE_CHI2


def fit_changes(fast: GyroFmu, slow: GyroFmu, gyros: Sequence[Flown]) -> list[FittedChanges]:
    """The mechanisms' changes of gyros in flights of one length, by Gauss-Newton.

    Each stage replays the gyros with the changes of the last one and filters all rows. The first
    stage knows `HRGSlow` alone. Later ones take sensitivities and what `HRG` shows beyond `HRGSlow`
    anew, as long as changes move. A gyro that has settled is left alone, so that its estimate does
    not depend on the others.

    fast: `HRG`; slow: `HRGSlow`.
    """
    followed = [begin(each.device, each.witnesses) for each in gyros]
    responses = [each.responses for each in gyros]
    scatters = _measure_scatter(fast, [each.device for each in gyros])
    fitted: dict[int, FittedChanges] = {}
    moving = list(range(len(gyros)))
    for stage in range(STAGES):
        starts = {n: fitted[n].changes if stage else gyros[n].prior.mean for n in moving}
        changed = {n: change_device(gyros[n].device, starts[n]) for n in moving}
        if stage:
            for n in moving:
                if not followed[n].is_corrected:
                    responses[n] = measure_responses(slow, changed[n], responses[n].noise)
            replays = follow((fast, slow), changed, followed)
        else:
            replays = follow_slowly(slow, changed, followed)
        for n in moving:
            fitted[n] = _fit_stage(gyros[n], replays[n], starts[n], responses[n], scatters[n])
            followed[n].is_corrected &= fitted[n].moved < CORRECTION_CHI2
        moving = [
            n for n in moving if not followed[n].is_corrected or fitted[n].moved >= CONVERGENCE_CHI2
        ]
    return [fitted[n] for n in range(len(gyros))]


def _fit_stage(
    gyro: Flown,
    replayed: Replay,
    start: Array,
    responses: Responses,
    scatter: Array,
) -> FittedChanges:
    """start: (COUNT,) changes of the replayed gyro; scatter: (2,) of the blocks. A force that was
    not recorded is left out."""
    witnesses, prior = gyro.witnesses, gyro.prior
    root = factor_covariance(prior.covariance)
    noise = responses.noise / np.sqrt(BLOCK)
    residuals = _average(replayed.residuals, witnesses.interval)
    recorded = np.isfinite(residuals).all(axis=0)
    design = _average_design(responses, replayed.motion)
    late = _average_delay(witnesses.forces - replayed.residuals, witnesses.interval)
    scaled = np.concatenate([design @ root, gyro.delay_sigma * late[:, :, None]], axis=2)
    # the replay leaves out the bias by the rate of temperature
    values = residuals + design @ (np.where(TEMPERATURE_RATE, 0.0, start) - prior.mean)
    filtered = filter_rows(
        scaled[:, recorded],
        values[:, recorded],
        noise[recorded],
        np.eye(COUNT + 1),
        np.maximum(scatter, noise)[recorded],
    )
    changes = prior.mean + root @ filtered.mean[:COUNT]
    covariance = root @ filtered.covariance[:COUNT, :COUNT] @ root.T
    return FittedChanges(
        changes=changes,
        covariance=covariance,
        responses=responses,
        temperature=float(replayed.motion.temperature[-1]),
        angle=float(witnesses.angle[-1]),
        burst_share=float(np.mean(filtered.weights < 1)),
        p_value=filtered.p_value,
        moved=compute_normalized_square(changes - start, covariance)[0],
        delay=gyro.delay_sigma * float(filtered.mean[COUNT]),
        delay_sigma=gyro.delay_sigma * float(np.sqrt(filtered.covariance[COUNT, COUNT])),
    )


def _average_design(responses: Responses, motion: Motion) -> Array:
    """(b, 2, COUNT) sensitivities, averaged over `BLOCK`."""
    terms = evaluate_motion(motion).reshape(len(motion.angle), -1)
    flat = responses.forces.reshape(COUNT, 2, -1)
    averaged = [_average(terms * each[:, None], motion.interval) for each in motion.signals.T]
    design = np.empty((len(averaged[0]), 2, COUNT))
    for place, rows in enumerate(averaged):
        acting = place == FOLLOWED
        design[:, :, acting] = np.einsum("bt,cft->bfc", rows, flat[acting])
    changing = compute_change_design(responses.forces, motion, responses.angular_gain)
    return design + _average(changing, motion.interval)


def _average_delay(forces: Array, interval: float) -> Array:
    """(b, 2) change of blocks of simulated forces (n, 2) per second of delay of the first one."""
    slopes = np.gradient(forces, interval, axis=0)
    return _average(slopes * np.array([-1.0, 0.0]), interval)


def _measure_scatter(fast: GyroFmu, devices: Sequence[Device]) -> Array:
    """(d, 2) standard deviation about its neighbours of a block's mean force of gyros at rest,
    pick-off noise included."""
    steps = round(BLOCK / CONTROL_PERIOD)
    moving = [{"angularRate": np.zeros((SCATTER_BLOCKS, steps))}] * len(devices)
    with ExitStack() as stack:
        gyros = [stack.enter_context(fast.power_on(d.fmu_parameters(), 1, 0.0)) for d in devices]
        held: list[dict[str, Array]] = [{}] * len(gyros)
        recorded = record_together(gyros, moving, held, CONTROL_PERIOD, [], FORCES)
    steps_between = [np.diff(means[2:], axis=0) for _, means in recorded]
    return np.std(steps_between, axis=1) / np.sqrt(2)


def _average(rows: Array, interval: float) -> Array:
    """Means over `BLOCK`, without the settling of the loops and what is left at the end."""
    length = max(1, round(BLOCK / interval))
    settled = rows[round(SETTLING / interval) :]
    count = len(settled) // length
    return np.asarray(
        settled[: count * length].reshape(count, length, *rows.shape[1:]).mean(axis=1)
    )
