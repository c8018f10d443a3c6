"""A score of the study with its interval, as study.json lists them under "scores"."""

from dataclasses import asdict, dataclass
from typing import Any

from pyhrg.common.arrays import to_json_value

ALL = "all"
"""Mission class or role of a score that covers all of them."""

R2_RADIAL, R2_COMPONENTS, R2_MOUNTED = "r2_radial", "r2_components", "r2_without_mounting"
R2_SHORTFALL, MOUNTING_SHARE = "r2_shortfall", "mounting_share"
MEDIAN_RATIO, COVERAGE = "median_ratio", "coverage"
SKILL_OVER_FIXED, SKILL_OVER_CLASS = "skill_over_fixed_position", "skill_over_class"
R2_OVER_FIXED, R2_OVER_CLASS = "r2_over_fixed_position", "r2_over_class"
R2_OVER_FIXED_MEAN = "r2_over_fixed_mean"
SPEARMAN, FLIGHT_SPEARMAN = "spearman", "spearman_of_flights"
FLIGHT_SPEARMAN_GAIN = "spearman_of_flights_over_fixed_position"
AGREEMENT, STEADY_AGREEMENT = "linear_to_cosimulated", "linear_to_steady_loops"
CLASS_CONSTANT = "class_constant"

SCORES = {
    R2_RADIAL: "R2 of predicted = flown, horizontal error, no refit",
    R2_COMPONENTS: "R2 of predicted = flown, north and east, no refit",
    R2_MOUNTED: "R2, north and east, if the mounting were known: its part is taken out",
    R2_SHORTFALL: "R2 of the true parameters less that of this predictor, horizontal error",
    MOUNTING_SHARE: "share of the flown mean square error that leaning input axes make, linear",
    MEDIAN_RATIO: "median of flown / predicted",
    COVERAGE: "share of flown errors inside the predicted interval",
    SKILL_OVER_FIXED: "1 less interval score / that of the fixed position, class constant, paired",
    SKILL_OVER_CLASS: "1 less interval score / that of the class alone, no bench test, paired",
    R2_OVER_FIXED: "R2 less that of the fixed position with its class constant, paired",
    R2_OVER_CLASS: "R2 less that of the class alone, no bench test, paired",
    R2_OVER_FIXED_MEAN: "R2 less that of the fixed position's mean bias, paired",
    SPEARMAN: "rank correlation of the bench's figure and the gyro's rms error (linear model, "
    "start angle averaged out; not flown)",
    FLIGHT_SPEARMAN: "rank correlation of a triad's bench figure and its flown error, one start "
    "angle each",
    FLIGHT_SPEARMAN_GAIN: "the same of the circumference less that of the fixed position, paired",
    CLASS_CONSTANT: "class constant: median linear error / usual rule (0.01 deg/h = 1 nmi/h)",
    AGREEMENT: "rms of linear less co-simulated / rms co-simulated, no noise, FMUs at 1 kHz",
    STEADY_AGREEMENT: "the same with FMUs whose loops are in their steady state",
}
"""Definitions by key; all are pure numbers (docs/methods/study_predictors.md, Eqs. 11 to 15)."""

RANGE = 0.0
"""Confidence of a score whose ends are the smallest and the largest of its triads."""
HOLDS, FAILS, UNDECIDED = "holds", "fails", "undecided"
"""Verdicts: the whole interval meets the requirement; none of it does; or part of it does."""


@dataclass(frozen=True)
class Score:
    """A score of one group of flights.

    Attributes:
        score: key of `SCORES`.
        predictor: key of `columns.PREDICTORS`, of `columns.FIGURE_TITLES`, or "".
        value, low, high: the score and its interval at `confidence`; NaN where there is none. With
            too few triads for an interval `confidence` is `RANGE`, and the ends are those of single
            triads.
        n: number of triads.
        seed: seed of the bootstrap, None for an exact interval.
        shuffled: whether it is the negative control, with predictions of shuffled devices.
        asked: the requirement, such as ">= 0.95", or "".
        verdict: `HOLDS`, `FAILS`, `UNDECIDED`, or "" without a requirement.
    """

    score: str
    predictor: str
    calibration: str
    mission_class: str
    role: str
    value: float
    low: float
    high: float
    confidence: float
    n: int
    seed: int | None = None
    shuffled: bool = False
    asked: str = ""
    verdict: str = ""

    def describe(self) -> dict[str, Any]:
        """The score as JSON values; null where a number is NaN."""
        values: dict[str, Any] = to_json_value(asdict(self))
        return values
