"""Maps of the gyros that a bench measured, as what is known before a drive, and whether the drive
bears them out (docs/methods/aided.md, Eqs. 15 and 16)."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from ins_eval.aided.bias_map import respond
from ins_eval.aided.kalman.backward import Adjoint
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.error_budget import BODY
from ins_eval.mission_model.bench_map import BenchMap
from ins_eval.mission_model.missions import STILL
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError

CONTRADICTION = 1e-3
"""A map whose distance from what the drive tells is less probable than this contradicts it. Chosen:
one in a thousand of right ones."""
SEEN = 0.1
"""A drive has seen a direction of the maps if it leaves at most this share of its variance. Chosen:
others say more of the prior than of the drive."""
TOGETHER = "all"
POWER_ON = -STILL
"""Time of the bench's maps, s, where effects follow the warming after power-on: not yet warm."""


@dataclass(frozen=True)
class BenchTest:
    """Whether a drive bears out the bench's map of a gyro.

    gyro: its name, or `TOGETHER`; square: of the distance of the bench's map from what the drive
    tells without it, normalised, in the directions that the drive has seen; degrees: number of
    these.
    """

    gyro: str
    square: float
    degrees: int

    @property
    def p_value(self) -> float:
        """Probability of a square as large, if the map is right."""
        return float(chi2.sf(self.square, self.degrees)) if self.degrees else 1.0

    @property
    def contradicts(self) -> bool:
        return self.p_value < CONTRADICTION


def take_bench_maps(sensors: SensorStates, maps: Mapping[int, BenchMap]) -> SensorStates:
    """The states with a bench's maps, by the gyro's axis."""
    return sensors.condition(*_stack(sensors, maps))


def choose_bench_maps(
    sensors: SensorStates, maps: Mapping[int, BenchMap], adjoint: Adjoint
) -> tuple[dict[int, BenchMap], tuple[BenchTest, ...]]:
    """The bench's maps that a drive does not contradict, each by itself and together, and the
    tests (Eq. 16).

    sensors: states without the maps; adjoint: at the beginning of a drive that was filtered with
    these.
    """
    tests = {axis: _test(BODY[axis], sensors, {axis: each}, adjoint) for axis, each in maps.items()}
    kept = {axis: each for axis, each in maps.items() if not tests[axis].contradicts}
    if len(kept) < 2:
        return kept, tuple(tests.values())
    together = _test(TOGETHER, sensors, kept, adjoint)
    return {} if together.contradicts else kept, (*tests.values(), together)


def _stack(sensors: SensorStates, maps: Mapping[int, BenchMap]) -> tuple[Array, Array, Array]:
    """(m, c) response of the terms that were measured and that coefficients make, (m,) values and
    variances.

    Raises:
        HrgError: a gyro without such a term.
    """
    every = respond(sensors, POWER_ON)
    rows, values, variances = [np.empty((0, len(sensors)))], [np.empty(0)], [np.empty(0)]
    sizes = np.sqrt(np.diag(sensors.covariance))
    for axis, each in maps.items():
        own = np.isfinite(each.variances) & np.any(every[axis] * sizes != 0, axis=1)
        if not own.any():
            found = f"bench: {BODY[axis]}: found no term that the errors of the IMU have"
            raise HrgError(f"{found}, expected whole-angle gyros, or the mean bias of others")
        rows.append(every[axis, own])
        values.append(each.values[own])
        variances.append(each.variances[own])
    return np.concatenate(rows), np.concatenate(values), np.concatenate(variances)


def _test(
    name: str, sensors: SensorStates, maps: Mapping[int, BenchMap], adjoint: Adjoint
) -> BenchTest:
    response, values, variances = _stack(sensors, maps)
    own, before = slice(COUNT, None), sensors.covariance
    estimate = response @ (sensors.mean - before @ adjoint.gradient[own])
    left = response @ (before - before @ adjoint.information[own, own] @ before) @ response.T
    whiten = _whiten(response @ before @ response.T)
    shares, vectors = np.linalg.eigh(whiten @ left @ whiten.T)
    seen = vectors[:, shares < SEEN].T @ whiten
    distance = seen @ (values - estimate)
    spread = seen @ (left + np.diag(variances)) @ seen.T
    return BenchTest(name, float(distance @ np.linalg.solve(spread, distance)), len(seen))


def _whiten(covariance: Array) -> Array:
    """(k, m) rows that make a covariance (m, m) of rank k the identity."""
    scale = 1 / np.sqrt(np.diag(covariance))
    values, vectors = np.linalg.eigh(covariance * np.outer(scale, scale))
    kept = values > 1e-12 * values[-1]
    return np.asarray((vectors[:, kept] / np.sqrt(values[kept])).T * scale)
