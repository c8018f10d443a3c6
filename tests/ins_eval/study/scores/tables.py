"""Tables of studies that were never flown but on paper."""

import numpy as np
import pandas as pd

from ins_eval.study.predictors import prediction_columns as block
from ins_eval.study.tables import columns
from tests.ins_eval.study.predictors import cases, flights

CLASSES = {"car": (11, 12), "ship": (13,)}
"""Their missions, by seed."""


def table(count: int, spread: float = 1.0, seed: int = 2) -> pd.DataFrame:
    """One calibration and half: triads whose maps are wide by this factor, in three missions."""
    wide = spread * cases.SPREAD
    learnt = block.train(cases.triads(1, 300, wide), cases.ACCELEROMETER_BIAS)
    triads = cases.triads(seed, count, wide)
    parts = []
    for name, seeds in CLASSES.items():
        for number in seeds:
            weights = cases.mission(number)
            errors = flights.errors(triads, weights)[:, 0]
            predicted = block.predict_all(weights, triads, learnt, seed=1)
            ranked = block.tabulate_rankings(weights, triads, learnt)
            parts.append(
                pd.DataFrame(
                    {
                        columns.TRIAD: np.arange(count),
                        columns.CALIBRATION: "map",
                        columns.MISSION: f"{name} {number}",
                        columns.CLASS: name,
                        columns.HALF: "test",
                        columns.FLOWN_NORTH: errors[:, 0],
                        columns.FLOWN_EAST: errors[:, 1],
                        columns.FLOWN_RADIAL: np.hypot(*errors.T),
                        **block.tabulate_predictions(predicted, 0.9),
                        **{key: list(values) for key, values in ranked.items()},
                    }
                )
            )
    return pd.concat(parts, ignore_index=True)
