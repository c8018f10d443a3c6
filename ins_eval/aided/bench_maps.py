"""Maps of the gyros that a bench measured, as what is known before a drive, and whether the drive
bears them out (docs/methods/aided.md, Eqs. 15 and 16)."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.stats import chi2, norm

from ins_eval.aided.bias_map import respond
from ins_eval.aided.kalman.backward import Adjoint
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.error_budget import BODY
from ins_eval.mission_model.gyro_map import HARMONICS, NAMES, TERMS
from ins_eval.mission_model.missions import STILL
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.toml_table import TomlTable, read_json_table
from pyhrg.common.units import ARCSEC, DEG_PER_H, PPM

INTERVAL = float(norm.ppf(0.975))
"""Half the width of a 95 % interval in standard deviations."""
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
class BenchMap:
    """A gyro's map by a bench: (2 TERMS,) terms of the bias, rad/s, then of the scale-factor error,
    and their variances, infinite where nothing was measured."""

    values: Array
    variances: Array


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


def read_bench_map(path: Path | str, drift: tuple[float, float]) -> BenchMap:
    """The map in a result.json of the bench's test `calibration`, or in a file of its findings.

    drift: standard deviation of a term's change since the bench: of the bias, rad/s, and of the
    scale-factor error.

    Raises:
        HrgError: an unreadable file; no term of the bias map; a term without an interval.
    """
    findings = read_json_table(Path(path)).table("findings")
    values, variances = np.zeros(2 * TERMS), np.full(2 * TERMS, np.inf)
    for key, (place, unit) in _list_keys().items():
        if key in findings.values:
            values[place], sigma = (unit * x for x in _read_finding(findings.table(key)))
            variances[place] = sigma**2 + drift[place // TERMS] ** 2
    if not np.isfinite(variances[:TERMS]).any():
        expected = f"those of the test calibration, such as {next(iter(_list_keys()))}"
        raise findings.error("keys", ", ".join(findings.values) or "none", expected)
    return BenchMap(values, variances)


def _list_keys() -> dict[str, tuple[int, float]]:
    """Place and SI value of the unit of each finding. The scale-factor map is the error of the
    detected angle, whose derivative is the scale-factor error."""
    keys = {f"bias_map_{name}_deg_per_h": (k, DEG_PER_H) for k, name in enumerate(NAMES)}
    keys["scale_factor_error_ppm"] = (TERMS, PPM)
    for k, harmonic in enumerate(HARMONICS):
        cosine, sine = TERMS + 2 * k + 1, TERMS + 2 * k + 2
        keys[f"scale_factor_map_sin{harmonic}_arcsec"] = (cosine, harmonic * ARCSEC)
        keys[f"scale_factor_map_cos{harmonic}_arcsec"] = (sine, -harmonic * ARCSEC)
    return keys


def _read_finding(entry: TomlTable) -> tuple[float, float]:
    """Value and standard deviation."""
    low, high = entry.numbers("interval_95", 2, -1e9, 1e9)
    if not high > low:
        raise entry.error("interval_95", [low, high], "[low, high]")
    return entry.finite_number("value"), (high - low) / (2 * INTERVAL)


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
    told = response @ (sensors.mean - before @ adjoint.gradient[own])
    left = response @ (before - before @ adjoint.information[own, own] @ before) @ response.T
    whiten = _whiten(response @ before @ response.T)
    shares, vectors = np.linalg.eigh(whiten @ left @ whiten.T)
    seen = vectors[:, shares < SEEN].T @ whiten
    distance = seen @ (values - told)
    spread = seen @ (left + np.diag(variances)) @ seen.T
    return BenchTest(name, float(distance @ np.linalg.solve(spread, distance)), len(seen))


def _whiten(covariance: Array) -> Array:
    """(k, m) rows that make a covariance (m, m) of rank k the identity."""
    scale = 1 / np.sqrt(np.diag(covariance))
    values, vectors = np.linalg.eigh(covariance * np.outer(scale, scale))
    kept = values > 1e-12 * values[-1]
    return np.asarray((vectors[:, kept] / np.sqrt(values[kept])).T * scale)
