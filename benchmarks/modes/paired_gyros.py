"""Two gyros on each axis that calibrate each other: one navigates while virtual rotation turns the
pattern of the other by 180 deg, to or fro; then they change places.

Both feel the same rate, so that the difference of their outputs is that of their errors: mean bias,
harmonics of the bias and of the detected angle over each one's own pattern angle, gain error and
harmonics of the virtual rotation, and the difference of their scale factors. The coefficients are
normal and independent before (`PRIORS`); each change of places conditions them on all that has been
read (least squares, rows of 1 s), and the gyro that navigates next is freed of its own. Of the mean
biases the difference alone is seen: each takes half of it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from ins_eval.imu.gyros import FLIGHT, FmuGyros, resolve_force_in_case
from ins_eval.imu.mounting import Mounting
from ins_eval.imu.stated_gyros import GyroReading
from pyhrg.bench.bench import Bench
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu, record_together
from pyhrg.records.imu.log import Increments

ROTATION = 2 * DEG
"""Virtual rotation of the gyro that does not navigate, as an input rate, rad/s. Chosen: noise of
the rotation grows with it, the time for a turn falls."""
SHARE = 325.0
"""Time between two changes of places, s: 180 deg of pattern, a period of all harmonics."""
REST = 4 * SHARE
"""Time before the start in which each gyro is turned to and fro, s: that of an alignment."""
ORDERS = (2, 4, 8)
ROW = 1.0
"""Length of a row of the estimator, s."""
SETTLE = 10
"""Rows that are left out after a change of places: a rotation that sets in is read 1 ms late."""
MEAN, BIAS, ANGLE, TURNING, GAIN = "mean", "bias", "angle", "turning", "gain"
PRIORS = {MEAN: DEG_PER_H, BIAS: DEG_PER_H, ANGLE: 1e-3, TURNING: 1e-3, GAIN: 1e-3}
"""Standard deviations before: rad/s, rad, ratios. Chosen: at least the sizes of gyros as made."""
SCALE_PRIOR = 1e-4


@dataclass(frozen=True)
class Track:
    """What one gyro showed: (n + 1,) angle and pattern angle, rad, (n,) virtual rotation, rad/s."""

    angle: Array
    pattern: Array
    command: Array

    def list_terms(self, interval: float) -> dict[str, Array]:
        """(n + 1, m) error of the angle by unit coefficients, by kind."""
        harmonics = [f(order * self.pattern) for order in ORDERS for f in (np.cos, np.sin)]
        waves = np.stack(harmonics, axis=1)
        means = (waves[1:] + waves[:-1]) / 2
        ones = np.ones((len(self.command), 1))
        command = self.command[:, None]
        rates = {MEAN: ones, BIAS: means, TURNING: command * means, GAIN: command}
        terms = {kind: _integrate(rate, interval) for kind, rate in rates.items()}
        return terms | {ANGLE: waves - waves[0]}


def _integrate(rates: Array, interval: float) -> Array:
    return np.vstack([np.zeros(rates.shape[1]), np.cumsum(rates, axis=0) * interval])


def free_of_errors(pair: Sequence[Track], interval: float, variance: float) -> tuple[Array, Array]:
    """The pair's output: (n,) increments, rad, of the gyro that navigates less its errors as they
    are known at the change of places before; and what is known at the end, (2, 1 + 2 orders)
    coefficients of mean and bias of each gyro, rad/s.

    variance: of a row of the difference, rad^2.
    """
    terms = [track.list_terms(interval) for track in pair]
    columns = np.hstack([*terms[0].values(), *(-each for each in terms[1].values())])
    columns = np.hstack([columns, (pair[0].angle - pair[0].angle[0])[:, None]])
    one = [np.full(values.shape[1], PRIORS[kind]) for kind, values in terms[0].items()]
    information = np.diag(np.concatenate([*one, *one, [SCALE_PRIOR]]) ** -2.0)
    weighted = np.zeros(len(information))
    coefficients, width = weighted, sum(map(len, one))
    every, share = round(ROW / interval), round(SHARE / interval)
    count = len(pair[0].command)
    increments = np.empty(count)
    for turn, first in enumerate(range(0, count, share)):
        rows = slice(first, min(first + share, count))
        which = turn % 2
        shown = {k: v[rows.start : rows.stop + 1] for k, v in terms[which].items()}
        own = _split(coefficients[which * width :], shown)
        error = sum(shown[kind] @ own[kind] for kind in (MEAN, BIAS, ANGLE))
        increments[rows] = np.diff(pair[which].angle[rows.start : rows.stop + 1] - error)
        read = slice(rows.start + SETTLE * every, rows.stop + 1, every)
        design = np.diff(columns[read], axis=0)
        difference = np.diff(pair[0].angle[read] - pair[1].angle[read])
        information += design.T @ design / variance
        weighted = weighted + design.T @ difference / variance
        coefficients = np.linalg.solve(information, weighted)
    known = [_split(coefficients[i * width :], terms[0]) for i in (0, 1)]
    return increments, np.stack([np.concatenate([own[MEAN], own[BIAS]]) for own in known])


def _split(coefficients: Array, terms: dict[str, Array]) -> dict[str, Array]:
    """One gyro's coefficients by kind, in the order of its terms."""
    ends = np.cumsum([values.shape[1] for values in terms.values()])
    return dict(zip(terms, np.split(coefficients[: ends[-1]], ends[:-1]), strict=True))


def record_pair(
    benches: Sequence[Bench], rotation: Array, force: Array, interval: float
) -> tuple[Track, Track]:
    """Two gyros on one axis that change places.

    rotation: (n,) true rotation, rad; force: (n, 3) m/s^2, along the axes of the case.
    """
    count = len(rotation)
    turn = np.arange(count) // round(SHARE / interval)
    sign = np.where(turn // 2 % 2, -1.0, 1.0)
    commands = [ROTATION * sign * (turn % 2 != which) for which in (0, 1)]
    inputs = {"angularRate": rotation / interval}
    inputs |= {f"acceleration{axis}": force[:, i] for i, axis in enumerate("XYZ")}
    moving = {name: values[:, None] for name, values in inputs.items()}
    names = ["gyroAngle", "patternAngle"]
    with benches[0].power_on(FLIGHT) as one, benches[1].power_on(FLIGHT) as other:
        gyros = [one, other]
        starts = [[gyro.read(name) for name in names] for gyro in gyros]
        held = [{"virtualRotation": command} for command in commands]
        recorded = record_together(gyros, [moving, moving], held, interval, names)
    tracks = [
        Track(*np.vstack([start, ends]).T, command)
        for start, (ends, _), command in zip(starts, recorded, commands, strict=True)
    ]
    return cast(tuple[Track, Track], tuple(tracks))


def find_variance(pair: Sequence[Device]) -> float:
    """Of a row of the difference, rad^2: angle random walk and noise of the virtual rotation."""
    walks = sum(device.angle_random_walk**2 for device in pair)
    rotation = max(device.model.get("noise.virtualRotation", 0.0) for device in pair) * ROTATION
    return (walks + rotation**2) * ROW


def calibrate_at_rest(fmu: GyroFmu, pair: Sequence[Device], seed: int) -> Array:
    """(2, 1 + 2 orders) mean and harmonics of the bias of each gyro, rad/s, as the pair knows them
    after `REST` without any motion."""
    interval = 0.1
    count = round(REST / interval)
    benches = [Bench(fmu, device, seed=seed + i) for i, device in enumerate(pair)]
    tracks = record_pair(benches, np.zeros(count), np.zeros((count, 3)), interval)
    _, known = free_of_errors(tracks, interval, find_variance(pair))
    return known


def evaluate_map(coefficients: Array, angles: Array) -> Array:
    """Bias at pattern angles by the coefficients of a gyro, rad/s."""
    harmonics = [f(order * angles) for order in ORDERS for f in (np.cos, np.sin)]
    return np.asarray(coefficients[0] + coefficients[1:] @ np.stack(harmonics))


@dataclass(frozen=True)
class PairedGyros(FmuGyros):
    """Three pairs of gyros, which calibrate each other at rest for `REST` before the motion begins,
    and go on; `differences` are those of the first of each, `partners` the second of each."""

    partners: tuple[Device, ...] = ()

    def measure(
        self, truth: Increments, mounting: Mounting, generator: np.random.Generator
    ) -> GyroReading:
        """Simulate the pairs on the true motion."""
        benches = self.draw(generator)
        still = round(REST / truth.interval)
        components = mounting.project(truth.rotation)
        outputs = []
        for axis, (bench, partner) in enumerate(zip(benches, self.partners, strict=True)):
            other = Bench(bench.fmu, partner, seed=int(generator.integers(2**63)))
            force = resolve_force_in_case(truth, mounting.axes[axis])
            force = np.vstack([np.tile(force[0], (still, 1)), force])
            rotation = np.concatenate([np.zeros(still), components[:, axis]])
            tracks = record_pair([bench, other], rotation, force, truth.interval)
            variance = find_variance([bench.device, partner])
            increments, _ = free_of_errors(tracks, truth.interval, variance)
            outputs.append(increments[still:])
        return GyroReading(np.stack(outputs, axis=1))
