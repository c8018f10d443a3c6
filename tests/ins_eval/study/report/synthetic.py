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
UNSEEN = ("ship", "missile", "airliner", "weaving")
SPREAD = {"mean": 3000.0, "map": 250.0}
"""Of the made-up map errors, m."""


CONDITIONS = {"straight & level": "the pattern stays", "self-calibrated": "maps of its own"}
"""Title and what is special; the second is where the thesis does not hold."""


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
    about |= {"interval_percent": 90.0, "conditions": CONDITIONS}
    return check_study_data(table, about | {"scores": scores(table, seed)})


def _apart(title: str, triads: int, generator: np.random.Generator) -> pd.DataFrame:
    flights = _flights("ship", 4, "mean", triads, generator)
    return flights.assign(**{c.CLASS: title, c.HALF: "condition"})


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
        c.HALF: "test" if MISSIONS[mission] in UNSEEN else "train",
        c.HOURS: 2.0,
        c.FLOWN_NORTH: flown[:, 0],
        c.FLOWN_EAST: flown[:, 1],
        c.FLOWN_RADIAL: radial,
        c.GROWTH: list(radial[:, None] * (np.arange(1, 13) / 12) ** 1.4),
        c.RMS_OVER_ANGLES: np.sqrt(2) * spread[:, 0],
        c.COSIMULATED: np.where(np.arange(triads) % 10 == 0, 1.004 * radial, np.nan),
        c.FIXED_STABILITY: 0.004 * generator.lognormal(0, 0.8, triads),
        c.CIRCUMFERENCE_STABILITY: 0.1 * quality * SPREAD[calibration] / SPREAD["mean"],
        c.MAP_RMS: 0.1 * quality,
        c.UNPREDICTABLE: np.hypot(0.14 * spread[:, 0], 24.0),
    }
    gyros = quality[:, None] * generator.lognormal(0, 0.3, (triads, 3))
    columns |= {
        c.GYROS_FLOWN: list(spread[:, :1] * gyros),
        c.GYROS_FITTED: list(spread[:, :1] * gyros * generator.lognormal(0, 0.05, (triads, 3))),
        c.GYROS_FIXED: list(0.004 * generator.lognormal(0, 0.8, (triads, 3))),
        c.GYROS_CIRCUMFERENCE: list(0.1 * gyros * generator.lognormal(0, 0.2, (triads, 3))),
    }
    for name, error in parts.items():
        columns |= {c.name_part(name, "north"): error[:, 0], c.name_part(name, "east"): error[:, 1]}
    typical = {
        "fixed_rule": 0.05 * spread[:, 0] * generator.lognormal(0, 0.8, triads),
        "circumference_rule": spread[:, 0] * generator.lognormal(0, 0.3, triads),
        "manoeuvre_theory": 1.18 * spread[:, 0],
        "fitted_map": np.hypot(*known.T),
        "fitted_map_any_angle": 1.18 * spread[:, 0],
        "bench_oracle": np.hypot(*known.T),
        "oracle": np.hypot(*(known + rest["warming"]).T),
        "oracle_any_angle": 1.18 * spread[:, 0],
    }
    for key, median in typical.items():
        width = 2.5 if key in ("fitted_map", "bench_oracle", "oracle") else 8.0
        columns |= {
            f"{key}_median_m": median,
            f"{key}_low_m": median / width,
            f"{key}_high_m": median * width,
        }
    for key in ("fitted_map", "oracle"):
        columns |= {f"{key}_north_m": known[:, 0], f"{key}_east_m": known[:, 1]}
    return pd.DataFrame(columns)


def scores(table: pd.DataFrame, seed: int) -> list[dict[str, Any]]:
    """Rough scores of every kind; their intervals are no better than the study."""
    told = []
    for (calibration, half), rows in table.groupby([c.CALIBRATION, c.HALF]):
        groups = [(scored.ALL, rows), *rows.groupby(c.CLASS)]
        for name, flights in groups:
            place = {"calibration": calibration, "half": half, "mission_class": name}
            common = place | {"confidence": 0.95, "n": flights[c.TRIAD].nunique(), "seed": seed}
            told += [common | entry for entry in _of_class(flights, str(name))]
    return told


def _of_class(flights: pd.DataFrame, name: str) -> list[dict[str, Any]]:
    flown = flights[c.FLOWN_RADIAL]
    told = []
    for predictor in c.PREDICTORS:
        median = flights[predictor.median]
        r2 = 1 - float(((flown - median) ** 2).sum() / ((flown - flown.mean()) ** 2).sum())
        ratio = float((flown / median).median())
        inside = int(((flights[predictor.low] < flown) & (flown < flights[predictor.high])).sum())
        exact = stats.binomtest(inside, len(flights)).proportion_ci(0.95)
        asked: dict[str, Any] = {}
        if predictor.key == "fitted_map" and name != scored.ALL:
            asked = {"asked": ">= 0.98", "holds": r2 >= 0.98}
        told += [
            _entry(scored.R2_RADIAL, predictor.key, r2, 0.02) | asked,
            _entry(scored.R2_COMPONENTS, predictor.key, r2, 0.02),
            _entry(scored.MEDIAN_RATIO, predictor.key, ratio, 0.1 * ratio),
            _entry(scored.OPTIMISM, predictor.key, ratio, 0.1 * ratio),
            _entry(scored.COVERAGE, predictor.key, inside / len(flights), 0.0)
            | {"low": exact.low, "high": exact.high, "seed": None},
            _entry(scored.WIDTH, predictor.key, 1.5, 0.2),
        ]
    holds = {"asked": "> 0", "holds": name != "self-calibrated"} if name in CONDITIONS else {}
    told.append(_entry(scored.VARIANCE_REMOVED, "fitted_map", 0.93, 0.02) | holds)
    told.append(_entry(scored.ADVANTAGE, "circumference_rule", 2.1, 0.2) | holds)
    told.append(_entry(scored.UNPREDICTABLE_SHARE, "fitted_map", 0.16, 0.02))
    note = {"note": "a sample, one triad in ten"} if name == scored.ALL else {}
    told.append(_entry(scored.AGREEMENT, "", 0.004, 0.001) | note)
    for key, bench in (
        ("fixed_rule", c.FIXED_STABILITY),
        ("circumference_rule", c.CIRCUMFERENCE_STABILITY),
    ):
        rank = float(stats.spearmanr(flights[bench], flights[c.RMS_OVER_ANGLES])[0])
        told.append(_entry(scored.SPEARMAN, key, rank, 0.1))
    told.append(_entry(scored.SPEARMAN, "circumference_rule", 0.02, 0.1) | {"shuffled": True})
    return told


def _entry(score: str, predictor: str, value: float, half_width: float) -> dict[str, Any]:
    ends = {"low": value - half_width, "high": value + half_width}
    return {"score": score, "predictor": predictor, "value": value} | ends
