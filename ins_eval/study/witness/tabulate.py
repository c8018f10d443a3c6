"""The rows of witness.csv: flights whose gyros' channels were read."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study.predictors import true_parameters
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from ins_eval.study.predictors.prediction import NormalPrediction
from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from ins_eval.study.witness.block import ERRORS, TESTS
from pyhrg.common.arrays import Array

AXES = ("north", "east")
LINEAR = ("bound", "true")
"""Predictions that the linear model takes out of a flight."""
KEYS = ("calibration", "mission_class", "mission", "triad", "self_test_s")
"""Columns that name a flight."""


def tabulate_witnesses(
    found: Mapping[str, Array],
    triads: TriadBlock,
    weights: MissionWeights,
    sensors: tuple[float, float],
    inside: float,
    seed: int,
    tests: Sequence[float] = TESTS,
) -> pd.DataFrame:
    """Rows of the witnessed triads in one mission, of each self-test in turn.

    found: (r, t, ...) fields of `WitnessedFlight`; weights: at the mission's end alone;
    sensors: standard deviations of the accelerometers' biases, m/s^2, and of each input axis' lean,
    rad; inside: probability of the intervals; tests: (t,) durations of the self-test, s.
    """
    rows = np.flatnonzero(np.isfinite(found["flown"][:, 0, 0]))
    chosen = triads.select(rows.tolist())
    bench = collect_bench_figures(chosen).noise
    other, true_other = (
        compute_unpredictable_covariance(weights, noise, *sensors)
        for noise in (bench, chosen.noise)
    )
    true = true_parameters.predict(weights, chosen.in_flight, true_other)
    tables = []
    for place, test in enumerate(tests):
        here = {name: values[rows, place] for name, values in found.items()}
        predictions = {
            key: NormalPrediction(here[key][:, None], here[f"{key}_covariance"][:, None] + other)
            for key in ("known", "estimated")
        }
        generator = np.random.default_rng([seed, place])
        bound = _attain_bound(here, true.expected[:, 0], generator)
        predictions["bound"] = NormalPrediction(bound[:, None], predictions["estimated"].covariance)
        predictions["true"] = true
        columns: dict[str, Any] = {"triad": rows, "self_test_s": np.full(len(rows), test)}
        # maps that no flight has are taken out by the linear model
        here |= {f"by_{key}": here["flown"] - predictions[key].expected[:, 0] for key in LINEAR}
        for name in (*ERRORS, *(f"by_{key}" for key in LINEAR)):
            columns |= {f"{name}_{axis}_m": here[name][:, i] for i, axis in enumerate(AXES)}
        for key, prediction in predictions.items():
            ends = {"low": (1 - inside) / 2, "median": 0.5, "high": (1 + inside) / 2}
            columns |= {
                f"{key}_{name}_m": prediction.radius(share)[:, 0] for name, share in ends.items()
            }
        columns |= {name: here[name].sum(axis=1) for name in ("squares", "degrees", "followed")}
        missed = here["estimated"] - true.expected[:, 0]
        columns["position_square"] = np.einsum(
            "ri,rij,rj->r", missed, np.linalg.inv(here["estimated_covariance"]), missed
        )
        columns["smallest_p"] = here["p_values"].min(axis=1)
        tables.append(pd.DataFrame(columns))
    return pd.concat(tables, ignore_index=True)


def _attain_bound(found: Mapping[str, Array], true: Array, generator: np.random.Generator) -> Array:
    """(r, 2) position error by an estimate that attains the bound: it goes from what is known
    before the flight towards the error by the true maps as far as the channels tell, and has their
    noise."""
    after, before = found["estimated_covariance"], found["known_covariance"]
    left = after @ np.linalg.inv(before)
    step = np.einsum("rij,rj->ri", np.eye(2) - left, true - found["known"])
    values, vectors = np.linalg.eigh(after - left @ after)
    root = vectors * np.sqrt(np.maximum(values, 0.0))[:, None, :]
    noise = np.einsum("rij,rj->ri", root, generator.standard_normal(true.shape))
    return np.asarray(found["known"] + step + noise)
