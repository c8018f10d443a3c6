"""Noise of the output angle where none is stated: estimated from the records at rest."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from scipy.optimize import minimize

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.gap.evidence.noise.rest_stretches import RestStretches, find_rest_stretches
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import MIN_ANGLE_NOISE, build_angle_noise
from pyhrg.gap.whitening.whitening import NoiseModel, whiten
from pyhrg.records.campaign import INDEX, CampaignError

Stretch = tuple[Array, Array]
"""Consecutive rows at rest: (n, 2 + DRIFT_DEGREE) residual of the angle, rad, and powers of time of
a drift; (n,) time since the reading before, s."""

MIN_ROWS = 600
"""Rows that all stretches must have together. Chosen."""
DRIFT_DEGREE = 4
"""Degree of the polynomial in time that is removed from each stretch: a gap and the room's
temperature make any drift. Chosen."""
NOTE = "nominal: states no {}, which is taken from the records at rest: {:.3g} {}"
WORDS = {
    "angle_white_noise": ("white noise of the output angle", ARCSEC, "arcsec"),
    "angle_random_walk": ("angle random walk", DEG_PER_SQRT_H, "deg/sqrt(h)"),
}
"""A noise in words, with its unit, SI, and the unit's name."""
NO_NOISE = (
    f"{INDEX}: nominal: states no noise of the output angle, and logs have {{}} rows at rest; "
    "expected angle_random_walk_deg_sqrt_h or angle_white_noise_arcsec, or "
    f"{MIN_ROWS} rows at rest. Not at rest: {{}}"
)


def complete_stated_noise(
    simulation: Simulation, nominal: Device, tests: Sequence[ObservedTest]
) -> tuple[Device, tuple[str, ...]]:
    """The gyro with the noise of its output angle, and a sentence on each that had to be estimated.
    A `CampaignError` where no noise is stated, and too few rows are at rest.

    Levels are the maximum-likelihood estimates over all stretches at rest (`find_rest_stretches`).
    The simulation is subtracted, and a polynomial drift of each stretch is integrated out.
    """
    stretches = [
        stretch
        for test, rest in zip(tests, require_noise(nominal, tests), strict=False)
        for stretch in _read_stretches(simulation, nominal, test, rest)
    ]
    if not stretches:
        return nominal, ()
    levels = _estimate_noise(stretches, build_angle_noise(nominal), _list_unstated(nominal))
    notes = []
    for name, level in levels.items():
        words, unit, unit_name = WORDS[name]
        notes.append(NOTE.format(words, level / unit, unit_name))
    return replace(nominal, **cast(Any, levels)), tuple(notes)


def _list_unstated(nominal: Device) -> tuple[str, ...]:
    """Fields of the noises that a gyro must have and its maker does not state. Where nothing says
    how readings scatter, but slow noise is stated, that is the white noise."""
    if nominal.angle_white_noise or nominal.quantization_step:
        return ()
    slow = nominal.angle_random_walk, nominal.rate_random_walk, nominal.bias_instability
    return ("angle_white_noise",) if any(slow) else ("angle_white_noise", "angle_random_walk")


def require_noise(nominal: Device, tests: Sequence[ObservedTest]) -> list[RestStretches]:
    """Rows at rest of each test, to estimate from them what is not stated of the noise of the
    output angle; none where they are too few. A `CampaignError` where then no noise is known."""
    unstated = _list_unstated(nominal)
    if not unstated:
        return []
    rests = [find_rest_stretches(nominal, test) for test in tests]
    rows = sum(len(stretch) for rest in rests for stretch in rest.stretches)
    if rows >= MIN_ROWS:
        return rests
    if "angle_random_walk" not in unstated:
        return []
    refused = sum((rest.refused for rest in rests), Counter[str]())
    reasons = ", ".join(f"{count} {reason}" for reason, count in refused.most_common())
    raise CampaignError(NO_NOISE.format(rows, reasons))


def _compute_log_likelihood(stretch: Stretch, noise: NoiseModel) -> float:
    """Log likelihood under a noise with the drift integrated out, up to a constant."""
    white = whiten(*stretch, noise)
    columns, triangle = np.linalg.qr(white.series[:, 1:])
    residual = white.series[:, 0] - columns @ (columns.T @ white.series[:, 0])
    drift = 2 * float(np.log(np.abs(np.diag(triangle))).sum())
    return -(float(residual @ residual) + white.log_determinant + drift) / 2


def _read_stretches(
    simulation: Simulation, nominal: Device, test: ObservedTest, rest: RestStretches
) -> Iterator[Stretch]:
    if not rest.stretches:
        return
    log = test.log
    residual = log.gyro_angle - simulation.simulate(nominal, test)["gyro_angle"]
    for rows in rest.stretches:
        time = np.linspace(-1.0, 1.0, len(rows))
        series = np.column_stack([residual[rows], np.vander(time, DRIFT_DEGREE + 1)])
        yield series, np.diff(log.time[rows], prepend=log.time[rows[0]] - log.interval)


def _estimate_noise(
    stretches: Sequence[Stretch], stated: NoiseModel, names: Sequence[str]
) -> dict[str, float]:
    """Maximum-likelihood level of each noise that is not stated, SI."""
    changes = [np.diff(series[:, 0]) for series, _ in stretches]
    scale = max(float(np.median([np.std(change) for change in changes])), MIN_ANGLE_NOISE)
    root = float(np.sqrt(np.median(np.concatenate([steps for _, steps in stretches]))))
    scales = {"angle_white_noise": scale, "angle_random_walk": scale / root}

    def list_levels(logarithms: Array) -> dict[str, float]:
        return {n: scales[n] * math.exp(x) for n, x in zip(names, logarithms, strict=True)}

    def misfit(logarithms: Array) -> float:
        noise = replace(stated, **cast(Any, list_levels(logarithms)))
        return -sum(_compute_log_likelihood(stretch, noise) for stretch in stretches)

    count = len(names)
    start, bounds = np.full(count, -1.0), [(-7.0, 3.0)] * count
    return list_levels(minimize(misfit, start, method="Nelder-Mead", bounds=bounds).x)
