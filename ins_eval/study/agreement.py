"""Scores of the linear model against the co-simulated sample, noise left out on both sides."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.experiment import cosimulated_of, flown_of, methods
from ins_eval.study.gyros.maker import Method
from ins_eval.study.run.block import Arrays
from ins_eval.study.scores.resampling import CONFIDENCE, bootstrapped
from ins_eval.study.specification import Study
from ins_eval.study.tables import score
from ins_eval.study.tables.score import ALL, Score

Array = NDArray[np.float64]

MOST = 0.01
"""Of the ensemble's rms, that the two may be apart (asked of the study)."""


def scores(study: Study, arrays: Arrays) -> list[Score]:
    """By calibration and class of mission, at the end; none without a sample."""
    return list(_scores(study, arrays)) if study.cosimulated else []


def apart(linear: Array, nonlinear: Array) -> Array:
    """Rms of the difference over rms, of errors (..., r, m, 2)."""
    missed = np.sum((linear - nonlinear) ** 2, axis=(-3, -2, -1))
    return np.asarray(np.sqrt(missed / np.sum(nonlinear**2, axis=(-3, -2, -1))))


def _scores(study: Study, arrays: Arrays) -> Iterator[Score]:
    classes = dict.fromkeys(mission.mission_class for mission in study.missions)
    for method in methods(study):
        for name in (ALL, *classes):
            flying = [
                number
                for number, mission in enumerate(study.missions)
                if name in (ALL, mission.mission_class)
            ]
            yield _score(study, arrays, method, name, flying)


def _score(
    study: Study, arrays: Arrays, method: Method, mission_class: str, flying: list[int]
) -> Score:
    samples = [np.stack(ends, axis=1) for ends in zip(*_ends(arrays, method, flying), strict=True)]
    found = bootstrapped(apart, samples, study.seed)
    return Score(
        score=score.AGREEMENT,
        predictor="",
        calibration=method,
        mission_class=mission_class,
        half=ALL,
        value=found.value,
        low=found.low,
        high=found.high,
        confidence=CONFIDENCE,
        n=len(samples[0]),
        seed=study.seed,
        asked=f"<= {MOST:g}",
        holds=found.value <= MOST,
    )


def _ends(arrays: Arrays, method: Method, flying: list[int]) -> Iterator[tuple[Array, Array]]:
    """(r, 2) linear and nonlinear error of the sample, of each mission."""
    for number in flying:
        nonlinear = cosimulated_of(arrays, method, number)[:, -1]
        done = np.isfinite(nonlinear).all(axis=-1)
        error = flown_of(arrays, method, number)
        yield (error.error - error.noise)[done, -1], nonlinear[done]
