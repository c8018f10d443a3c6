"""Noise of the output angle where none is stated: that of the gyro's own records at rest."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from pyhrg.common.units import ARCSEC, DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.gap.evidence.residuals import is_nominal
from pyhrg.gap.replay.observations import COMMANDS, Observed
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import LEAST_ANGLE
from pyhrg.gap.whitening.whitening import SlowNoise, whitened
from pyhrg.records.campaign import INDEX, CampaignError

Array = NDArray[np.float64]

SHORTEST, LEAST = 60, 600
"""Rows of a stretch, and of all together."""
STILL = 1e-4
"""Rate of a table that rests, rad/s."""
TREND = 2
"""Degree of the drift of a stretch, which any gap may make."""
NOTE = (
    "nominal: states no noise of the output angle: {:.3g} arcsec of white noise and "
    "{:.3g} deg/sqrt(h) of angle random walk are taken from the records at rest"
)
NO_NOISE = (
    f"{INDEX}: nominal: states no noise of the output angle, and logs have {{}} rows at rest; "
    f"expected angle_random_walk_deg_sqrt_h or angle_white_noise_arcsec, or {LEAST} rows at rest"
)


def with_noise(
    simulation: Simulation, believed: Device, tests: Sequence[Observed]
) -> tuple[Device, tuple[str, ...]]:
    """A gyro with the angle's noise, and a sentence where it had to be taken from records.

    White noise and angle random walk are the likeliest in all stretches in which the table rests,
    at one temperature and under the same commands, without rotation and at nominal amplitude; what
    the simulation answers and any drift are taken out of each, and integrated out.

    Args:
        simulation: both fidelities.
        believed: as it is stated.
        tests: of the gyro.

    Raises:
        CampaignError: nothing is stated, and too little rests.
        GyroError: a gyro that the FMU refuses.
    """
    stated = (
        believed.pickoff_noise,
        believed.angle_random_walk,
        believed.rate_random_walk,
        believed.bias_instability,
        believed.angle_quantum,
    )
    if any(stated):
        return believed, ()
    found = [s for test in tests for s in _at_rest(simulation, believed, test)]
    rows = sum(len(stretch.steps) for stretch in found)
    if rows < LEAST:
        raise CampaignError(NO_NOISE.format(rows))
    white, walk = _likeliest(found)
    note = NOTE.format(white / ARCSEC, walk / DEG_PER_SQRT_H)
    return replace(believed, pickoff_noise=white, angle_random_walk=walk), (note,)


@dataclass(frozen=True)
class _Stretch:
    """Rows at rest.

    series: (n, 2 + TREND) what is left of the angle, rad, and the powers of time of a drift.
    steps: (n,) time from the reading before, s.
    """

    series: Array
    steps: Array

    def log_likelihood(self, noise: SlowNoise) -> float:
        """Under a noise, whatever the drift, but for a constant."""
        white = whitened(self.series, self.steps, noise)
        columns, triangle = np.linalg.qr(white.series[:, 1:])
        left = white.series[:, 0] - columns @ (columns.T @ white.series[:, 0])
        drift = 2 * float(np.log(np.abs(np.diag(triangle))).sum())
        return -(float(left @ left) + white.log_determinant + drift) / 2


def _at_rest(simulation: Simulation, believed: Device, test: Observed) -> Iterator[_Stretch]:
    log, rates = test.log, np.abs(test.inputs.table.rates)
    still = test.rows["gyro_angle"] & is_nominal(log, believed)
    still &= (np.maximum(rates[1:], rates[:-1]) < STILL) & (log.virtual_rotation == 0)
    if not still.any() or np.ptp(test.inputs.temperatures) > 0:
        return
    left = log.gyro_angle - simulation.answers(believed, test)["gyro_angle"]
    commands = np.column_stack([getattr(log, name) for name in COMMANDS])
    for (rests, *_), group in groupby(
        range(len(still)), key=lambda i: (bool(still[i]), *commands[i].tolist())
    ):
        rows = list(group)
        if rests and len(rows) >= SHORTEST:
            time = np.linspace(-1.0, 1.0, len(rows))
            series = np.column_stack([left[rows], np.vander(time, TREND + 1)])
            yield _Stretch(
                series, np.diff(log.time[rows], prepend=log.time[rows[0]] - log.interval)
            )


def _likeliest(stretches: Sequence[_Stretch]) -> tuple[float, float]:
    """White noise, rad, and angle random walk, rad/sqrt(s)."""
    changes = [np.diff(stretch.series[:, 0]) for stretch in stretches]
    scale = max(float(np.median([np.std(change) for change in changes])), LEAST_ANGLE)
    root = float(np.sqrt(np.median(np.concatenate([stretch.steps for stretch in stretches]))))

    def noise(logarithms: Array) -> SlowNoise:
        white, walk = scale * np.exp(logarithms)
        return SlowNoise(float(white), float(walk / root))

    def misfit(logarithms: Array) -> float:
        return -sum(stretch.log_likelihood(noise(logarithms)) for stretch in stretches)

    found = minimize(misfit, np.full(2, -1.0), method="Nelder-Mead", bounds=[(-7.0, 3.0)] * 2)
    best = noise(found.x)
    return best.white, best.walk
