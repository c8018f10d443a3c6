"""One figure of the study with its interval, as study.json lists them under "scores"."""

from dataclasses import dataclass

ALL = "all"
"""For a mission class or half: of all of them."""

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
    VARIANCE_REMOVED: "variance removed of what the circumference rule, refitted, leaves",
    COVERAGE: "share of flown errors inside the predicted interval",
    WIDTH: "median width of the predicted interval / the oracle's",
    SPEARMAN: "rank correlation of the bench's figure and the flown rms over power-on angles",
    ADVANTAGE: "mean |ln(flown / predicted)| of the fixed rule less that of the circumference rule",
    UNPREDICTABLE_SHARE: "rms of drift, noise and accelerometers / rms of the predicted error",
    AGREEMENT: "rms of linear less co-simulated / rms co-simulated",
}
"""By key: what it is; all are pure numbers."""


@dataclass(frozen=True)
class Score:
    """score: key of `SCORES`; predictor: key of `columns.PREDICTORS`, "" where there is none;
    value with its interval (NaN: none) of this confidence; n: triads; seed: of the bootstrap
    (None: exact); shuffled: devices shuffled, the negative control; asked: the bound that it is
    held to ("", or such as ">= 0.95"), holds: whether it does (None: nothing asked); note: a
    sentence, such as why the thesis breaks here."""

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
