"""Tables of studies that were never flown but on paper."""

from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd

from ins_eval.mission_model.position_errors import compute_linear_position_errors
from ins_eval.study.predictors import prediction_columns as block
from ins_eval.study.tables import columns
from tests.ins_eval.study.predictors import cases

CLASSES = {"car": (11, 12), "ship": (13,)}
"""Their missions, by seed."""


SHIPS = {"ship": CLASSES["ship"]}


def table(
    count: int, spread: float = 1.0, seed: int = 2, classes: Mapping[str, Sequence[int]] = CLASSES
) -> pd.DataFrame:
    """One calibration and role: triads whose maps are wide by this factor, in each mission."""
    wide = spread * cases.SPREAD
    training = cases.triads(1, 300, wide)
    learnt = block.train(training, *cases.SHEETS)
    triads = cases.triads(seed, count, wide)
    parts = []
    for name, seeds in classes.items():
        for number in seeds:
            weights = cases.mission(number)
            parts_of_error = compute_linear_position_errors(triads, weights, mission=0)
            errors, leaning = parts_of_error.error[:, 0], parts_of_error.mounting[:, 0]
            rules = cases.class_ratios(training.select(slice(40)), weights)
            predicted = block.predict_all(weights, triads, learnt, rules, seed=1)
            ranked = block.tabulate_rankings(weights, triads)
            parts.append(
                pd.DataFrame(
                    {
                        columns.TRIAD: np.arange(count),
                        columns.CALIBRATION: "map",
                        columns.MISSION: f"{name} {number}",
                        columns.CLASS: name,
                        columns.ROLE: "test",
                        columns.FLOWN_NORTH: errors[:, 0],
                        columns.FLOWN_EAST: errors[:, 1],
                        columns.FLOWN_RADIAL: np.hypot(*errors.T),
                        columns.name_part("mounting", "north"): leaning[:, 0],
                        columns.name_part("mounting", "east"): leaning[:, 1],
                        columns.FIXED_STABILITY: _rms(triads.fixed_stability),
                        columns.CIRCUMFERENCE_STABILITY: _rms(triads.circumference_stability),
                        **block.tabulate_predictions(predicted, 0.9),
                        **{key: list(values) for key, values in ranked.items()},
                    }
                )
            )
    return pd.concat(parts, ignore_index=True)


def _rms(values: cases.Array) -> cases.Array:
    return np.asarray(np.sqrt(np.mean(values**2, axis=1)))
