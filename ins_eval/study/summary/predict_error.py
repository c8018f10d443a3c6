"""Predicted position error from two bench figures, by the constants of a finished study."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ins_eval.study.predictors.stability_rule import DRIFT_PER_STABILITY
from ins_eval.study.report.lead_case import format_distance
from ins_eval.study.study_data import StudyData, StudyDataError, read_study_data
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import SPEARMAN
from pyhrg.common.arguments import check_number
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H, HOUR

LARGEST_STABILITY = 100.0
"""Largest stability that is accepted, deg/h."""
RULES: Mapping[str, tuple[str, str, str]] = {
    "fixed_deg_h": (c.FIXED_RULE, c.FIXED_CLASS, "fixed position"),
    "circumference_deg_h": (c.CIRCUMFERENCE_RULE, c.CIRCUMFERENCE_CLASS, "full circumference"),
}
"""Predictor by the usual rule, predictor by the constant of the class, and name of each test."""


@dataclass(frozen=True)
class PredictedError:
    """Horizontal error at the end of a mission, from one bench figure; m.

    test: name of the test; stability: rms of the three gyros, deg/h; rule: by 0.01 deg/h = 1 nmi/h;
    median, low, high: by the constant of the class, with its interval at `interval_percent`;
    spearman: rank correlation of this test's figure with the errors of the study's gyros.
    """

    test: str
    mission: str
    hours: float
    stability: float
    rule: float
    median: float
    low: float
    high: float
    interval_percent: float
    spearman: float

    def __str__(self) -> str:
        return (
            f"{self.test}, {self.stability:g} deg/h: {format_distance(self.median)} after "
            f"{self.hours:g} h of {self.mission} ({self.interval_percent:g} %: "
            f"{format_distance(self.low)} to {format_distance(self.high)}); by the usual rule "
            f"{format_distance(self.rule)}; the test ranks gyros with Spearman {self.spearman:.2f}"
        )


def predict_error(
    study: Path | str,
    mission: str,
    *,
    fixed_deg_h: float | None = None,
    circumference_deg_h: float | None = None,
    calibration: str = "mean",
) -> list[PredictedError]:
    """Position errors that bench figures predict, with intervals, one for each figure given.

    The constant of the mission's class is read from a finished study (prediction by the class over
    prediction by the usual rule), for its gyros and duration.

    Args:
        study: folder of a finished study, such as that of `validate`.
        mission: name of one of its missions.
        fixed_deg_h: in-run bias stability at a fixed position, rms of the three gyros.
        circumference_deg_h: bias stability over the full circumference, likewise.
        calibration: what the maker calibrates: "mean" or "map".

    Raises:
        HrgError: no figure is given, or one is out of range; the folder holds no study, or one
            without this mission or calibration.
    """
    found = {"fixed_deg_h": fixed_deg_h, "circumference_deg_h": circumference_deg_h}
    given = {name: value for name, value in found.items() if value is not None}
    if not given:
        raise HrgError(f"found no bench figure, expected {' or '.join(found)}")
    for name, value in given.items():
        check_number(name, value, 1e-6, LARGEST_STABILITY)
    data = read_study_data(Path(study))
    return [_predict(data, mission, calibration, name, value) for name, value in given.items()]


def _predict(
    data: StudyData, mission: str, calibration: str, name: str, stability: float
) -> PredictedError:
    rows = data.table[
        (data.table[c.MISSION] == mission) & (data.table[c.CALIBRATION] == calibration)
    ]
    if not len(rows):
        known = " or ".join(data.list_values(c.MISSION))
        raise StudyDataError(
            f"mission: found no {mission!r}, {calibration} calibrated, in the study, expected "
            f"{known}"
        )
    usual, own, test = RULES[name]
    hours = float(rows[c.HOURS].iloc[0])
    rule = DRIFT_PER_STABILITY * stability * DEG_PER_H * hours * HOUR
    predictor, reference = c.PREDICTOR_OF[own], rows[c.PREDICTOR_OF[usual].median]
    median, low, high = (
        rule * float(np.median(rows[end] / reference))
        for end in (predictor.median, predictor.low, predictor.high)
    )
    ranked = data.select(
        SPEARMAN,
        predictor=usual,
        calibration=calibration,
        mission_class=str(rows[c.CLASS].iloc[0]),
    )
    spearman = ranked[0].value if ranked else float("nan")
    level = data.interval_percent
    return PredictedError(test, mission, hours, stability, rule, median, low, high, level, spearman)
