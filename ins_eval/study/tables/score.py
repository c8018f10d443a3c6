"""A score of the study with its interval, as study.json lists them under "scores"."""

from dataclasses import dataclass

ALL = "all"
"""Mission class or half of a score that covers all of them."""

R2_RADIAL, R2_COMPONENTS = "r2_radial", "r2_components"
MEDIAN_RATIO, OPTIMISM = "median_ratio", "optimism"
VARIANCE_REMOVED, COVERAGE, WIDTH = "variance_removed", "coverage", "width_to_oracle"
SPEARMAN, AGREEMENT = "spearman", "linear_to_cosimulated"
ADVANTAGE, UNPREDICTABLE_SHARE = "advantage_of_circumference", "unpredictable_share"

SCORES = {
    R2_RADIAL: "R2 of predicted = flown, horizontal error, no refit",
    R2_COMPONENTS: "R2 of predicted = flown, north and east, no refit",
    MEDIAN_RATIO: "median of flown / predicted",
    OPTIMISM: "rms flown / rms predicted",
    VARIANCE_REMOVED: "share removed of the residual variance of the refitted circumference rule",
    COVERAGE: "share of flown errors inside the predicted interval",
    WIDTH: "median width of the predicted interval / the oracle's",
    SPEARMAN: "rank correlation of the bench's figure and the flown rms over power-on angles",
    ADVANTAGE: "mean |ln(flown / predicted)| of the fixed rule less that of the circumference rule",
    UNPREDICTABLE_SHARE: "rms error by drift, noise, accelerometers / rms of the predicted error",
    AGREEMENT: "rms of linear less co-simulated / rms co-simulated",
}
"""Definitions by key; all are pure numbers (docs/methods/study_predictors.md, Eqs. 11 to 17)."""


@dataclass(frozen=True)
class Score:
    """A score of one group of flights.

    score: key of `SCORES`; predictor: key of `columns.PREDICTORS`, or "";
    value, low, high: the score and its interval at `confidence`; NaN where there is none;
    n: number of triads; seed: seed of the bootstrap, None for an exact interval;
    shuffled: whether it is the negative control, with predictions of shuffled devices;
    asked: the requirement, such as ">= 0.95", or ""; holds: whether it is met, None without one;
    note: a sentence on what the score means, or "".
    """

    score: str
    predictor: str
    calibration: str
    mission_class: str
    half: str
    value: float
    low: float
    high: float
    confidence: float
    n: int
    seed: int | None = None
    shuffled: bool = False
    asked: str = ""
    holds: bool | None = None
    note: str = ""
