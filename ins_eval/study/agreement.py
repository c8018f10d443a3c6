"""Scores of the linear model against the co-simulated samples, all without noise."""

from collections.abc import Iterator

import numpy as np

from ins_eval.study.experiment import (
    NOISELESS,
    STEADY_LOOPS,
    list_methods,
    select_cosimulated,
    select_errors,
)
from ins_eval.study.gyros.makers_calibration import Method
from ins_eval.study.run.block import Arrays
from ins_eval.study.scores.judge import judge_bounds
from ins_eval.study.scores.resampling import bootstrap
from ins_eval.study.specification import Study
from ins_eval.study.tables import score
from ins_eval.study.tables.score import ALL, Score
from pyhrg.common.arrays import Array

LARGEST_RELATIVE_DIFFERENCE = 0.01
"""Largest accepted ratio of the rms difference to the rms error. Chosen."""


def score_agreement(study: Study, arrays: Arrays) -> list[Score]:
    """Scores by sample, calibration and mission class, at the end; none without a sample."""
    samples = (
        (study.agreement, NOISELESS, score.AGREEMENT),
        (study.steady_agreement, STEADY_LOOPS, score.STEADY_AGREEMENT),
    )
    return [
        found
        for size, flights, key in samples
        if size
        for found in _score_groups(study, arrays, flights, key)
    ]


def compute_relative_difference(linear: Array, nonlinear: Array) -> Array:
    """(...,) ratio of the rms difference to the rms nonlinear error; errors are (..., r, m, 2)."""
    difference = np.sum((linear - nonlinear) ** 2, axis=(-3, -2, -1))
    return np.asarray(np.sqrt(difference / np.sum(nonlinear**2, axis=(-3, -2, -1))))


def _score_groups(study: Study, arrays: Arrays, flights: str, key: str) -> Iterator[Score]:
    classes = dict.fromkeys(mission.mission_class for mission in study.missions)
    for method in list_methods(study):
        for name in (ALL, *classes):
            missions = [
                number
                for number, mission in enumerate(study.missions)
                if name in (ALL, mission.mission_class)
            ]
            errors = zip(*_select_final_errors(arrays, method, missions, flights), strict=True)
            samples = [np.stack(each, axis=1) for each in errors]
            estimate = bootstrap(compute_relative_difference, samples, study.seed)
            yield estimate.score(
                score=key,
                predictor="",
                calibration=method,
                mission_class=name,
                role=ALL,
                n=len(samples[0]),
                seed=study.seed,
                asked=f"<= {LARGEST_RELATIVE_DIFFERENCE:g}",
                verdict=judge_bounds(estimate, high=LARGEST_RELATIVE_DIFFERENCE),
            )


def _select_final_errors(
    arrays: Arrays, method: Method, missions: list[int], flights: str
) -> Iterator[tuple[Array, Array]]:
    """(r, 2) linear and nonlinear error of a sample at the end, for each mission."""
    for number in missions:
        nonlinear = select_cosimulated(arrays, method, number, flights)[:, -1]
        done = np.isfinite(nonlinear).all(axis=-1)
        error = select_errors(arrays, method, number)
        yield (error.error - error.noise)[done, -1], nonlinear[done]
