"""Noise of the output angle where none is stated: estimated from the records at rest."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby

import numpy as np
from scipy.optimize import minimize

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.gap.evidence.residuals import is_nominal
from pyhrg.gap.replay.observations import COMMAND_COLUMNS, ObservedTest
from pyhrg.gap.replay.reading_noise import REST_RATE
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import MIN_ANGLE_NOISE
from pyhrg.gap.whitening.whitening import NoiseModel, whiten
from pyhrg.records.campaign import INDEX, CampaignError

Stretch = tuple[Array, Array]
"""Consecutive rows at rest: (n, 2 + DRIFT_DEGREE) residual of the angle, rad, and powers of time of
a drift; (n,) time since the reading before, s."""

MIN_STRETCH_ROWS, MIN_ROWS = 60, 600
"""Rows that a stretch at rest must have, and all stretches together. Chosen."""
DRIFT_DEGREE = 2
"""Degree of the polynomial that is removed from each stretch: a gap may make any drift. Chosen."""
NOTE = (
    "nominal: states no noise of the output angle: {:.3g} arcsec of white noise and "
    "{:.3g} deg/sqrt(h) of angle random walk are taken from the records at rest"
)
NO_NOISE = (
    f"{INDEX}: nominal: states no noise of the output angle, and logs have {{}} rows at rest; "
    f"expected angle_random_walk_deg_sqrt_h or angle_white_noise_arcsec, or {MIN_ROWS} rows at rest"
)


def complete_stated_noise(
    simulation: Simulation, nominal: Device, tests: Sequence[ObservedTest]
) -> tuple[Device, tuple[str, ...]]:
    """The gyro with the noise of its output angle, and a sentence where this had to be estimated. A
    `CampaignError` where no noise is stated, and too few rows are at rest.

    White noise and angle random walk are the maximum-likelihood estimates over all stretches at
    rest: without rotation, at one temperature, under constant commands and at nominal amplitude.
    The simulation is subtracted, and a polynomial drift of each stretch is integrated out.
    """
    stated = (
        nominal.angle_white_noise,
        nominal.angle_random_walk,
        nominal.rate_random_walk,
        nominal.bias_instability,
        nominal.quantization_step,
    )
    if any(stated):
        return nominal, ()
    stretches = [s for test in tests for s in _find_stretches(simulation, nominal, test)]
    rows = sum(len(steps) for _, steps in stretches)
    if rows < MIN_ROWS:
        raise CampaignError(NO_NOISE.format(rows))
    white, walk = _estimate_noise(stretches)
    note = NOTE.format(white / ARCSEC, walk / DEG_PER_SQRT_H)
    return replace(nominal, angle_white_noise=white, angle_random_walk=walk), (note,)


def _log_likelihood(stretch: Stretch, noise: NoiseModel) -> float:
    """Log likelihood under a noise with the drift integrated out, up to a constant."""
    white = whiten(*stretch, noise)
    columns, triangle = np.linalg.qr(white.series[:, 1:])
    residual = white.series[:, 0] - columns @ (columns.T @ white.series[:, 0])
    drift = 2 * float(np.log(np.abs(np.diag(triangle))).sum())
    return -(float(residual @ residual) + white.log_determinant + drift) / 2


def _find_stretches(
    simulation: Simulation, nominal: Device, test: ObservedTest
) -> Iterator[Stretch]:
    log, rates = test.log, np.abs(test.inputs.table.rates)
    is_rest = test.rows["gyro_angle"] & is_nominal(log, nominal)
    is_rest &= (np.maximum(rates[1:], rates[:-1]) < REST_RATE) & (log.virtual_rotation == 0)
    if not is_rest.any() or np.ptp(test.inputs.temperatures) > 0:
        return
    residual = log.gyro_angle - simulation.simulate(nominal, test)["gyro_angle"]
    commands = np.column_stack([getattr(log, name) for name in COMMAND_COLUMNS])
    for (is_stretch, *_), group in groupby(
        range(len(is_rest)), key=lambda i: (bool(is_rest[i]), *commands[i].tolist())
    ):
        rows = list(group)
        if is_stretch and len(rows) >= MIN_STRETCH_ROWS:
            time = np.linspace(-1.0, 1.0, len(rows))
            series = np.column_stack([residual[rows], np.vander(time, DRIFT_DEGREE + 1)])
            yield series, np.diff(log.time[rows], prepend=log.time[rows[0]] - log.interval)


def _estimate_noise(stretches: Sequence[Stretch]) -> tuple[float, float]:
    """Maximum-likelihood white noise, rad, and angle random walk, rad/sqrt(s)."""
    changes = [np.diff(series[:, 0]) for series, _ in stretches]
    scale = max(float(np.median([np.std(change) for change in changes])), MIN_ANGLE_NOISE)
    root = float(np.sqrt(np.median(np.concatenate([steps for _, steps in stretches]))))

    def noise(logarithms: Array) -> NoiseModel:
        white, walk = scale * np.exp(logarithms)
        return NoiseModel(float(white), float(walk / root))

    def misfit(logarithms: Array) -> float:
        return -sum(_log_likelihood(stretch, noise(logarithms)) for stretch in stretches)

    optimum = minimize(misfit, np.full(2, -1.0), method="Nelder-Mead", bounds=[(-7.0, 3.0)] * 2)
    best = noise(optimum.x)
    return best.angle_white_noise, best.angle_random_walk
