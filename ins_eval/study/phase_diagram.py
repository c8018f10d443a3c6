"""The phase diagram: share of flights whose error each bench test predicts within a factor, over
the ratio of map and noise and over the rate of turning (study_predictors.md, Eq. 16).

The training triads fly from many start angles by the linear model, on a turntable that turns
steadily in heading for an hour. Their maps are scaled to each ratio of map and noise. Only the map
of bias and scale factor at power-on and the gyros' noise have weights here: not warming, specific
force, accelerometers or mounting.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.common import earth
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.error_model.linear_model import AXES, linearize, model_alignment
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.mission_model.gyro_map import TERMS, turn_weights, undo_start
from ins_eval.mission_model.mission_weights import STEP
from ins_eval.mission_model.missions import SETTLING, STILL, StudyMission
from ins_eval.mission_model.noise_weights import compute_error_weights, compute_noise_covariances
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.mission_model.signals import list_signal_effects
from ins_eval.navigation.height import Clamped
from ins_eval.study.predictors.parts.map_drift import MapDrift
from ins_eval.study.predictors.stability_rule import compute_rule_distance
from ins_eval.study.scores.resampling import bootstrap
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, HOUR

LATITUDE = 40 * DEG
"""Latitude of the turntable, rad. Chosen: about that of the ready car."""
DURATION = HOUR
"""Time of navigation, s. Chosen."""


@dataclass(frozen=True)
class TurningWeights:
    """Position error at the end per unit of each gyro error.

    Attributes:
        maps: (1, 2, 2 TERMS, 3) m per coefficient of a map that starts at angle 0, as
            `MissionWeights.gyros`.
        noise: (KINDS, 3, 2, 2) covariance, m^2, per squared unit of each kind of each gyro's noise.
    """

    maps: Array
    noise: Array


@cache
def compute_turning_weights(pattern_rate: float) -> TurningWeights:
    """Weights of `DURATION` of navigation in which the pattern of the vertical gyro turns at a
    rate, rad/s, after an alignment at rest."""
    effects = list_signal_effects()[: 2 * TERMS]
    aligning = model_alignment(_turn(0.0, SETTLING - STILL, 0.0), effects)
    turning = _turn(pattern_rate / ANGULAR_GAIN, 0.0, DURATION)
    flying = linearize(turning, Clamped(np.zeros(1)), effects)
    carried = np.zeros((COUNT, len(effects) * AXES))
    for model in (aligning, flying):
        inputs = model.inputs.reshape(len(model), COUNT, -1)
        for transition, given in zip(model.transition, inputs, strict=True):
            carried = transition @ carried + given
    transition = np.concatenate([aligning.transition, flying.transition])
    per_rate = np.concatenate([m.constant_errors[:, :, :AXES] for m in (aligning, flying)])
    by_rate = compute_error_weights(transition, per_rate, np.array([len(transition)]))
    return TurningWeights(
        maps=carried[:2].reshape(1, 2, len(effects), AXES),
        noise=compute_noise_covariances(by_rate, STEP, round(SETTLING / STEP)),
    )


def _turn(rate: float, start: float, end: float) -> Motion:
    """On a table that turns about the vertical at a rate, rad/s, from heading 0. Since power-on at
    -`STILL` the case has turned with the Earth."""
    count = round((end - start) / STEP)
    time = start + STEP / PARTS * np.arange(PARTS * count + 1.0)
    elapsed, zero = time - start, np.zeros_like(time)
    latitude = np.full_like(time, LATITUDE)
    cos, sin = np.cos(rate * elapsed), np.sin(rate * elapsed)
    mat_nb = np.zeros((len(time), AXES, AXES))
    mat_nb[:, 0, 0], mat_nb[:, 0, 1], mat_nb[:, 1, 0], mat_nb[:, 1, 1] = cos, -sin, sin, cos
    mat_nb[:, 2, 2] = 1.0
    rates = np.einsum("mji,mj->mi", mat_nb, earth.rotation_rate(latitude))
    rates[:, 2] += rate
    before = (start + STILL) * earth.rotation_rate(latitude[:1])
    mean = (rates[1:] + rates[:-1]) / 2 * STEP / PARTS
    return Motion(
        step=STEP,
        start=start,
        latitude=latitude,
        height=zero,
        velocity=np.zeros((len(time), AXES)),
        mat_nb=mat_nb,
        rate=rates,
        force=np.stack([zero, zero, -earth.gravity(latitude, zero)], axis=-1),
        turned=np.cumsum(np.concatenate([before, mean]), axis=0),
    )


FACTOR = 2.0
"""A test tells a flight's truth if flown and predicted error are within this factor. Chosen."""
TURNING = np.geomspace(0.01, 100.0, 9)
"""Turns of the vertical gyro's pattern, revolutions per hour. Chosen: 0.01 is the Earth's own turn,
100 a table at 36 deg/s."""
RATIOS = np.geomspace(0.1, 100.0, 13)
"""Rms of the bias map over the in-run stability at a fixed position. Chosen."""
ANGLES = 64
"""Number of start angles from which each triad flies. Chosen."""
FIXED, CIRCUMFERENCE, MAP = "fixed position", "full circumference", "fitted map"
COLUMNS = ("turning_rev_per_h", "map_over_noise", "test", "share", "low", "high", "triads")


@dataclass(frozen=True)
class _Gyros:
    """Figures of r triads.

    Attributes:
        maps: (r, 2 TERMS, 3) true coefficients.
        drifting, missed: (r, 2 TERMS, 3) standard deviations of their drift, which grows with the
            map, and of the bench's error, which does not.
        noise: (r, KINDS, 3) strengths.
        stability: (r,) at the fixed position, rad/s.
        size: (r,) rms of the bias map, rad/s.
    """

    maps: Array
    drifting: Array
    missed: Array
    noise: Array
    stability: Array
    size: Array


def compute_phase_diagram(training: TriadBlock, drift: MapDrift, seed: int) -> list[dict[str, Any]]:
    """Rows of `COLUMNS`: the share of flights that each test predicts within `FACTOR`, with its
    interval over triads.

    Each of fixed position and circumference is scaled by a constant for each turning rate: the
    fixed position's is right where noise alone makes the error, the circumference's where the map
    alone does. The fitted map has its own expected error.

    Args:
        training: triads whose shapes of maps, noise and bench errors are taken.
        drift: distribution of the maps' drift.
        seed: seed of start angles, noise, bench errors and bootstrap.
    """
    gyros = _describe_gyros(training, drift)
    rows: list[dict[str, Any]] = []
    for turning in TURNING.tolist():
        for ratio, shares in _fly(gyros, turning, seed):
            for test, inside in shares.items():
                average = bootstrap(_average, [inside.mean(axis=1, keepdims=True)], seed)
                values = (
                    turning,
                    ratio,
                    test,
                    average.value,
                    average.low,
                    average.high,
                    len(inside),
                )
                rows.append(dict(zip(COLUMNS, values, strict=True)))
    return rows


def compute_turning(mission: StudyMission) -> float:
    """Turns of the pattern that turns most in a mission, in both directions, revolutions per
    hour."""
    seconds = round(mission.hours * HOUR)
    rotation = mission.trajectory().increments(0.0, 1.0, seconds).rotation
    turned = ANGULAR_GAIN * np.abs(rotation).sum(axis=0).max() / (2 * np.pi)
    return float(turned / mission.hours)


def compute_map_over_noise(triads: TriadBlock) -> Array:
    """(r,) rms of the fitted bias maps over the in-run stability at the fixed position."""
    return _compute_size(triads.fitted_map) / _compute_triad_rms(triads.fixed_stability)


def _describe_gyros(training: TriadBlock, drift: MapDrift) -> _Gyros:
    maps = undo_start(training.in_flight[:, : 2 * TERMS], training.start_angle)
    power = np.mean(maps[:, 1:TERMS] ** 2, axis=1)[:, None]
    own = slice(0, 2 * TERMS)
    return _Gyros(
        maps=maps,
        drifting=np.sqrt(drift.relative[own, None] * power),
        missed=np.sqrt(drift.common[own, None] + training.map_variance),
        noise=training.noise,
        stability=_compute_triad_rms(training.fixed_stability),
        size=_compute_size(maps),
    )


def _fly(gyros: _Gyros, turning: float, seed: int) -> Iterator[tuple[float, Mapping[str, Array]]]:
    """(r, ANGLES) whether each test tells the truth, for each of `RATIOS`."""
    random = np.random.default_rng(seed)
    weights = compute_turning_weights(2 * np.pi * turning / HOUR)
    turned = turn_weights(weights.maps, random.uniform(0.0, np.pi, (ANGLES, 3)))[:, 0]
    deviates = random.standard_normal((2, len(gyros.maps), ANGLES, *gyros.maps.shape[1:]))
    covariance = np.einsum("rka,kaij->rij", gyros.noise**2, weights.noise)
    root = np.linalg.cholesky(covariance)
    noise = np.einsum("rij,rnj->rni", root, random.standard_normal((*deviates.shape[1:3], 2)))
    by_map = np.einsum("nica,rca->rni", turned, gyros.maps)
    drifted, missed = (
        np.einsum("nica,rnca,rca->rni", turned, each, sigma)
        for each, sigma in zip(deviates, (gyros.drifting, gyros.missed), strict=True)
    )
    rule = _compute_rule(gyros.stability)
    quiet = np.median(_compute_distance(noise) / rule)
    turned_map = np.median(_compute_distance(by_map) / _compute_rule(gyros.size))
    for ratio in RATIOS.tolist():
        scale = (ratio * gyros.stability / gyros.size)[:, None, None]
        flown = _compute_distance(scale * by_map + noise)
        predicted = {
            FIXED: quiet * rule,
            CIRCUMFERENCE: turned_map * rule * np.hypot(1.0, ratio),
            MAP: _compute_distance(scale * (by_map + drifted) + missed),
        }
        yield (
            ratio,
            {
                test: (np.abs(np.log(flown / each)) <= np.log(FACTOR)).astype(float)
                for test, each in predicted.items()
            },
        )


def _average(shares: Array) -> Array:
    """(...,) mean of shares (..., r, 1) over triads."""
    return np.asarray(shares.mean(axis=(-2, -1)))


def _compute_rule(stability: Array) -> Array:
    """(r, 1) distance at the end by the usual rule, m."""
    return compute_rule_distance(np.repeat(stability[:, None], 3, axis=1), np.array([DURATION]))


def _compute_distance(error: Array) -> Array:
    return np.asarray(np.linalg.norm(error, axis=-1))


def _compute_size(maps: Array) -> Array:
    """(r,) rms over gyros and angles of bias maps without their means, rad/s."""
    return np.asarray(np.sqrt(np.mean(np.sum(maps[:, 1:TERMS] ** 2, axis=1) / 2, axis=-1)))


def _compute_triad_rms(values: Array) -> Array:
    return np.asarray(np.sqrt(np.mean(values**2, axis=1)))


def write_rows(rows: Sequence[Mapping[str, Any]], path: Path) -> None:
    """Write rows of `COLUMNS` as CSV, with a header."""
    table = pd.DataFrame(rows, columns=list(COLUMNS))
    table.to_csv(path, index=False, float_format="%.6g", na_rep="nan", lineterminator="\r\n")
