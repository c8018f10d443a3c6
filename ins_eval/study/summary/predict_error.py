"""Predicted position error from two bench figures, by the constants of a finished study."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from ins_eval.study.report.distances import format_distance, format_range
from ins_eval.study.report.mission_constants import (
    BEYOND,
    CIRCUMFERENCE,
    FIXED,
    LARGEST_STABILITY,
    METRES_PER_DEG_H,
    SENTENCE,
    SMALLEST_STABILITY,
    MissionConstant,
    read_constants,
)
from ins_eval.study.study_data import StudyData, read_study_data
from pyhrg.common.arguments import check_number
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.pages.svg import format_number


@dataclass(frozen=True)
class PredictedError:
    """Horizontal position error at the end of a mission that one bench figure predicts, m.

    Attributes:
        test: name of the bench test.
        mission: name of the mission.
        hours: its duration, h.
        stability: bias stability, rms of the three gyros, deg/h.
        rule: error by the usual rule, 0.01 deg/h = 1 nmi/h, m.
        median: error by the class constant, m.
        low, high: its interval at `interval_percent`, m.
        interval_percent: probability of the interval, %.
        spearman: rank correlation of this test's figure with the errors of the study's gyros.
        smallest, largest: range of the stabilities of the study's triads, deg/h.
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
    smallest: float
    largest: float

    __repr__ = describe_briefly

    @property
    def document(self) -> dict[str, str | float]:
        """All fields as JSON values, with the unit in the name."""
        units = dict.fromkeys(("stability", "smallest", "largest"), "deg_h")
        units |= dict.fromkeys(("rule", "median", "low", "high"), "m")
        named = {f"{name}_{unit}": getattr(self, name) for name, unit in units.items()}
        return {n: v for n, v in asdict(self).items() if n not in units} | named

    def __str__(self) -> str:
        ends = {name: format_number(getattr(self, name), 2) for name in ("smallest", "largest")}
        within = self.smallest <= self.stability <= self.largest
        return SENTENCE.format(
            test=self.test,
            stability=np.format_float_positional(self.stability, trim="-"),
            median=format_distance(self.median),
            hours=f"{self.hours:g}",
            mission=self.mission,
            level=f"{self.interval_percent:g}",
            range=format_range(self.low, self.high),
            rule=format_distance(self.rule),
            spearman=f"{self.spearman:.2f}",
            beyond="" if within else BEYOND.format(**ends),
        )


def predict_error(
    study: Path | str,
    mission: str,
    *,
    fixed_deg_h: float | None = None,
    circumference_deg_h: float | None = None,
    calibration: str = "mean",
) -> list[PredictedError]:
    """Predict position errors from bench figures, with intervals: one prediction for each figure.

    The constant of the mission's class, its prediction divided by that of the usual rule, is read
    from a finished study. It is valid only for the study's gyros and duration.

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
    figures = {FIXED.key: fixed_deg_h, CIRCUMFERENCE.key: circumference_deg_h}
    given = {name: value for name, value in figures.items() if value is not None}
    if not given:
        raise HrgError(f"found no bench figure, expected {' or '.join(figures)}")
    for name, value in given.items():
        check_number(name, value, SMALLEST_STABILITY, LARGEST_STABILITY)
    return predict_from_study(read_study_data(Path(study)), mission, given, calibration)


def predict_from_study(
    data: StudyData, mission: str, given: Mapping[str, float], calibration: str
) -> list[PredictedError]:
    """`predict_error` from a study that is read, and bench figures by the key of their test.

    Raises:
        HrgError: the study is without this mission or calibration.
    """
    constants = {
        each.test.key: each
        for each in read_constants(data)
        if (each.mission, each.calibration) == (mission, calibration)
    }
    if not constants:
        known = " or ".join(data.missions)
        raise HrgError(
            f"mission: found no {mission!r}, {calibration} calibrated, in the study, expected "
            f"{known}"
        )
    return [
        _predict(constants[name], value, data.interval_percent) for name, value in given.items()
    ]


def _predict(constant: MissionConstant, stability: float, level: float) -> PredictedError:
    rule = METRES_PER_DEG_H * stability * constant.hours
    return PredictedError(
        test=constant.test.name,
        mission=constant.mission,
        hours=constant.hours,
        stability=stability,
        rule=rule,
        median=rule * constant.median,
        low=rule * constant.low,
        high=rule * constant.high,
        interval_percent=level,
        spearman=constant.spearman,
        smallest=constant.smallest,
        largest=constant.largest,
    )
