"""Constants of each mission class of a study, which turn bench figures into position errors.
`predictors/class_constants.py` makes them from the training triads."""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ins_eval.study.predictors.stability_rule import DRIFT_PER_STABILITY
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import SPEARMAN
from pyhrg.common.units import DEG_PER_H, HOUR


@dataclass(frozen=True)
class BenchTest:
    """A test that gives one figure. key: its name in calls; name: its name in words; rule, own: its
    predictors by the usual rule and by the constant of the class; figure: its column."""

    key: str
    name: str
    rule: str
    own: str
    figure: str


FIXED = BenchTest("fixed_deg_h", "fixed position", c.FIXED_RULE, c.FIXED_CLASS, c.FIXED_STABILITY)
CIRCUMFERENCE = BenchTest(
    "circumference_deg_h",
    "full circumference",
    c.CIRCUMFERENCE_RULE,
    c.CIRCUMFERENCE_CLASS,
    c.CIRCUMFERENCE_STABILITY,
)
TESTS = (FIXED, CIRCUMFERENCE)
METRES_PER_DEG_H = DRIFT_PER_STABILITY * DEG_PER_H * HOUR
"""Error in an hour of a stability of 1 deg/h by the usual rule, m."""
LARGEST_STABILITY = 100.0
SMALLEST_STABILITY = 1e-6
"""Range of stabilities that are accepted, deg/h."""
SENTENCE = (
    "{test}, {stability} deg/h: {median} after {hours} h of {mission}; {level} % interval {range}; "
    "by the usual rule {rule}; the test ranks gyros with Spearman {spearman} "
    "(linear model, start angle averaged out){beyond}"
)
"""A prediction in words, in the terminal and on the page."""
BEYOND = "; beyond the study's triads, which have {smallest} to {largest} deg/h"
"""Its end for a stability that no triad of the study has."""


@dataclass(frozen=True)
class MissionConstant:
    """The horizontal error at the end of a mission over that of the usual rule, for one test.

    Attributes:
        median, low, high: median and bounds of the predicted distribution.
        hours: duration of the mission.
        spearman: rank correlation of the test's figure with the errors of the study's gyros.
        smallest, largest: the figures of the study's judged triads, deg/h.
    """

    test: BenchTest
    mission: str
    calibration: str
    hours: float
    median: float
    low: float
    high: float
    spearman: float
    smallest: float
    largest: float


def read_constants(data: StudyData) -> list[MissionConstant]:
    """The constants of a finished study: missions in its order, the mean calibration first, for
    each both tests."""
    judged = data.table[data.table[c.ROLE] == TEST]
    groups = dict(iter(judged.groupby([c.MISSION, c.CALIBRATION])))
    return [
        _read_constant(data, test, groups[mission, calibration])
        for mission in data.missions
        for calibration in data.calibrations
        if (mission, calibration) in groups
        for test in TESTS
    ]


def _read_constant(data: StudyData, test: BenchTest, rows: pd.DataFrame) -> MissionConstant:
    mission, calibration, mission_class = (
        str(rows[name].iloc[0]) for name in (c.MISSION, c.CALIBRATION, c.CLASS)
    )
    own, reference = c.PREDICTOR_OF[test.own], rows[c.PREDICTOR_OF[test.rule].median]
    median, low, high = (
        float(np.median(rows[end] / reference)) for end in (own.median, own.low, own.high)
    )
    ranked = data.select(
        SPEARMAN,
        predictor=test.rule,
        calibration=calibration,
        mission_class=mission_class,
    )
    return MissionConstant(
        test=test,
        mission=mission,
        calibration=calibration,
        hours=float(rows[c.HOURS].iloc[0]),
        median=median,
        low=low,
        high=high,
        spearman=ranked[0].value if ranked else float("nan"),
        smallest=float(rows[test.figure].min()),
        largest=float(rows[test.figure].max()),
    )
