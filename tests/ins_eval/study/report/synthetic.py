"""A made-up study, for the report's tests alone: nothing of it was simulated."""

from typing import Any

import numpy as np
import pandas as pd
from scipy import stats

from ins_eval.study.study_data import StudyData, check_study_data
from ins_eval.study.tables import columns as c
from ins_eval.study.tables import score as scored

MISSIONS = {
    "car": "car",
    "city-drive": "car",
    "airliner": "airliner",
    "aircraft": "aircraft with rolls",
    "ship": "ship",
    "missile": "missile",
    "great-circle": "great circle",
    "weaving": "weaving",
}
SPREAD = {"mean": 3000.0, "map": 250.0}
"""Of the made-up map errors, m."""


CONDITIONS = {"straight & level": "the pattern stays", "self-calibrated": "maps of its own"}
"""Title and what is special; the second is where claims fail."""
TRAINING = 2
"""Number of training triads, which no score and no figure shows."""
LEAD = {
    "device": "table2",
    "mission": "car",
    "fixed_stability_deg_h": 0.0009,
    "circumference_stability_deg_h": 0.1,
    "time_s": [1800.0, 3600.0],
    "flown_m": [[3000.0, 9260.0], [1000.0, 3704.0], [7000.0, 18520.0]],
    "start_angles_deg": [[0.0, 60.0, 120.0], [60.0, 120.0, 0.0], [120.0, 0.0, 60.0]],
}


def synthetic(triads: int = 40, seed: int = 5, conditions: bool = True) -> StudyData:
    """Triads through every mission and calibration, and in conditions."""
    generator = np.random.default_rng(seed)
    blocks = [
        _flights(mission, place, calibration, triads, generator)
        for calibration in SPREAD
        for place, mission in enumerate(MISSIONS)
    ]
    if conditions:
        blocks += [_apart(title, triads, generator) for title in CONDITIONS]
    table = pd.concat(blocks, ignore_index=True)
    about = {"schema": "hrg-study/1", "seed": seed, "triads": triads, "hours": 2.0}
    about |= {"interval_percent": 90.0, "conditions": CONDITIONS, "lead": LEAD}
    return check_study_data(table, about | {"scores": scores(table, seed)})


def _apart(title: str, triads: int, generator: np.random.Generator) -> pd.DataFrame:
    flights = _flights("ship", 4, "mean", triads, generator)
    return flights.assign(**{c.CLASS: title, c.ROLE: "condition"})


def _flights(
    mission: str, place: int, calibration: str, triads: int, generator: np.random.Generator
) -> pd.DataFrame:
    quality = np.exp(0.6 * np.sin(1.0 + np.arange(triads) * 2.4))
    spread = SPREAD[calibration] * quality[:, None] * (0.3 + 0.2 * place)
    known = spread * generator.standard_normal((triads, 2))
    rest = {
        "warming": 0.1 * spread * generator.standard_normal((triads, 2)),
        "environment": 0.02 * spread * generator.standard_normal((triads, 2)),
        "drift": 0.01 * spread * generator.standard_normal((triads, 2)),
        "accelerometers": 8.0 * generator.standard_normal((triads, 2)),
        "mounting": 200.0 * generator.standard_normal((triads, 2)),
        "alignment": 2.0 * generator.standard_normal((triads, 2)),
        "noise": 15.0 * generator.standard_normal((triads, 2)),
    }
    parts = {"map": known} | rest
    flown = np.sum([*parts.values()], axis=0)
    radial = np.hypot(*flown.T)
    columns: dict[str, Any] = {
        c.TRIAD: np.arange(triads),
        c.CALIBRATION: calibration,
        c.MISSION: mission,
        c.CLASS: MISSIONS[mission],
        c.ROLE: np.where(np.arange(triads) < TRAINING, "train", "test"),
        c.HOURS: 2.0,
        c.FLOWN_BY: c.COSIMULATED,
        c.FLOWN_NORTH: flown[:, 0],
        c.FLOWN_EAST: flown[:, 1],
        c.FLOWN_RADIAL: radial,
        c.GROWTH: list(radial[:, None] * (np.arange(1, 13) / 12) ** 1.4),
        c.LINEAR_RADIAL: 1.004 * radial,
        c.FIXED_STABILITY: 0.004 * generator.lognormal(0, 0.8, triads),
        c.CIRCUMFERENCE_STABILITY: 0.1 * quality * SPREAD[calibration] / SPREAD["mean"],
        c.MAP_RMS: 0.1 * quality,
    }
    gyros = quality[:, None] * generator.lognormal(0, 0.3, (triads, 3))
    columns |= {
        c.GYROS_LINEAR: list(spread[:, :1] * gyros),
        c.GYROS_FITTED: list(spread[:, :1] * gyros * generator.lognormal(0, 0.05, (triads, 3))),
        c.GYROS_FIXED: list(0.004 * generator.lognormal(0, 0.8, (triads, 3))),
        c.GYROS_TURN_ON: list(0.001 * generator.lognormal(0, 0.8, (triads, 3))),
        c.GYROS_TURN_ON_ANYWHERE: list(0.1 * gyros * generator.lognormal(0, 0.3, (triads, 3))),
        c.GYROS_CIRCUMFERENCE: list(0.1 * gyros * generator.lognormal(0, 0.2, (triads, 3))),
    }
    for name, error in parts.items():
        columns |= {c.name_part(name, "north"): error[:, 0], c.name_part(name, "east"): error[:, 1]}
    fixed = 0.05 * spread[:, 0] * generator.lognormal(0, 0.8, triads)
    circumference = spread[:, 0] * generator.lognormal(0, 0.3, triads)
    typical = {
        "fixed_rule": fixed,
        "circumference_rule": circumference,
        "fixed_class": 20 * fixed,
        "circumference_class": 1.18 * circumference,
        "class_error": np.full(triads, 1.18 * SPREAD[calibration]),
        "fixed_mean": np.hypot(*known.T) * generator.lognormal(0, 0.5, triads),
        "fitted_map": np.hypot(*known.T),
        "fitted_map_any_angle": 1.18 * spread[:, 0],
        "true_parameters": np.hypot(*(known + rest["warming"]).T),
    }
    for key, median in typical.items():
        width = 2.5 if key in ("fitted_map", "true_parameters") else 8.0
        columns |= {
            f"{key}_median_m": median,
            f"{key}_low_m": median / width,
            f"{key}_high_m": median * width,
        }
    for key in ("fitted_map", "true_parameters"):
        columns |= {f"{key}_north_m": known[:, 0], f"{key}_east_m": known[:, 1]}
    return pd.DataFrame(columns)


def scores(table: pd.DataFrame, seed: int) -> list[dict[str, Any]]:
    """Rough scores of every kind; their intervals are no better than the study."""
    told = []
    judged = table[table[c.ROLE] != "train"]
    for (calibration, role), rows in judged.groupby([c.CALIBRATION, c.ROLE]):
        groups = [(scored.ALL, rows), *rows.groupby(c.CLASS)]
        for name, flights in groups:
            place = {"calibration": calibration, "role": role, "mission_class": name}
            common = place | {"confidence": 0.95, "n": flights[c.TRIAD].nunique(), "seed": seed}
            told += [common | entry for entry in _of_class(flights, str(name))]
    return told


def _of_class(flights: pd.DataFrame, name: str) -> list[dict[str, Any]]:
    flown = flights[c.FLOWN_RADIAL]
    failing = "fails" if name == "self-calibrated" else "holds"
    told = []
    for predictor in c.PREDICTORS:
        median = flights[predictor.median]
        r2 = 1 - float(((flown - median) ** 2).sum() / ((flown - flown.mean()) ** 2).sum())
        ratio = float((flown / median).median())
        inside = int(((flights[predictor.low] < flown) & (flown < flights[predictor.high])).sum())
        exact = stats.binomtest(inside, len(flights)).proportion_ci(0.95)
        asked = {
            "fixed_rule": {"asked": "below 0.5 or above 2", "verdict": "holds"},
            "circumference_class": {"asked": "within a factor of 1.3", "verdict": failing},
        }.get(predictor.key, {})
        is_fitted = predictor.key == "fitted_map"
        told += [
            _entry(scored.R2_RADIAL, predictor.key, r2, 0.02)
            | ({"asked": ">= 0.97", "verdict": "undecided"} if is_fitted else {}),
            _entry(scored.R2_COMPONENTS, predictor.key, r2, 0.02),
            _entry(scored.MEDIAN_RATIO, predictor.key, ratio, 0.1 * ratio) | asked,
            _entry(scored.COVERAGE, predictor.key, inside / len(flights), 0.0)
            | {"low": exact.low, "high": exact.high, "seed": None}
            | ({"asked": "0.9 within its interval", "verdict": "holds"} if is_fitted else {}),
        ]
    told.append(_entry(scored.R2_MOUNTED, "fitted_map", 0.98, 0.01))
    told.append(_entry(scored.AGREEMENT, "", 0.004, 0.001) | {"verdict": "holds"})
    for key, bench, asked in (
        ("fixed_rule", c.FIXED_STABILITY, "within 0.2 of 0"),
        ("circumference_rule", c.CIRCUMFERENCE_STABILITY, ">= 0.95"),
    ):
        rank = float(stats.spearmanr(flights[bench], flights[c.FLOWN_RADIAL])[0])
        verdict = {"asked": asked, "verdict": "holds"}
        told.append(_entry(scored.SPEARMAN, key, rank, 0.1) | verdict)
        told.append(_entry(scored.FLIGHT_SPEARMAN, key, rank, 0.2))
    for key in c.FIGURE_TITLES:
        told.append(_entry(scored.SPEARMAN, key, 0.5, 0.1))
    for key in ("fixed_class", "circumference_class"):
        told.append(_entry(scored.CLASS_CONSTANT, key, 0.5, 0.05))
    told.append(_entry(scored.SPEARMAN, "circumference_rule", 0.02, 0.1) | {"shuffled": True})
    return told


def _entry(score: str, predictor: str, value: float, half_width: float) -> dict[str, Any]:
    ends = {"low": value - half_width, "high": value + half_width}
    return {"score": score, "predictor": predictor, "value": value} | ends
