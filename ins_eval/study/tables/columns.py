"""Every column of study.parquet: one row for each triad of gyros, calibration and mission.

The metadata of each column carry its `unit` and `what`. For scores see `score.py`.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Column:
    """A column.

    name: its name in the file; kind: "int", "text", "number" or "numbers" (a list); unit: "1" for
    pure numbers, "" for text; what: its meaning, a phrase.
    """

    name: str
    kind: str
    unit: str
    what: str


@dataclass(frozen=True)
class Predictor:
    """A predictor of the position error.

    key: prefix of its columns; title: its name in reports; what: what it uses, a phrase.
    """

    key: str
    title: str
    what: str

    @property
    def median(self) -> str:
        """Column of the predicted radial error's median."""
        return f"{self.key}_median_m"

    @property
    def low(self) -> str:
        """Column of its interval's lower end."""
        return f"{self.key}_low_m"

    @property
    def high(self) -> str:
        """Column of its interval's upper end."""
        return f"{self.key}_high_m"


PREDICTORS = (
    Predictor("fixed_rule", "Fixed position", "fixed-position stability, 0.01 deg/h ~ 1 nmi/h"),
    Predictor(
        "circumference_rule", "Full circumference", "8N full-circumference stability, same rule"
    ),
    Predictor(
        "manoeuvre_theory",
        "Manoeuvre theory",
        "full-circumference stability through a theory that knows the manoeuvre",
    ),
    Predictor("fitted_map", "Fitted map", "the bench's maps; temperature and power-on angle known"),
    Predictor(
        "fitted_map_any_angle", "Fitted map, any angle", "the bench's maps; power-on angle unknown"
    ),
    Predictor(
        "bench_oracle", "Oracle, drift unknown", "the true maps on the bench, spread as the fit's"
    ),
    Predictor("oracle", "Oracle", "the true maps in flight, which no bench measures"),
    Predictor(
        "oracle_any_angle", "Oracle, any angle", "the true maps in flight; power-on angle unknown"
    ),
)
"""All predictors, from simple to best. The oracles are the yardstick of the others."""
PREDICTOR_OF = {predictor.key: predictor for predictor in PREDICTORS}
FIXED_RULE, CIRCUMFERENCE_RULE, FITTED_MAP = "fixed_rule", "circumference_rule", "fitted_map"
"""Keys of the predictors that the verdict compares."""

PARTS = {
    "map": "bias and scale-factor maps at power-on",
    "warming": "change of the maps while the gyros warm",
    "environment": "sensitivity of the maps to specific force, heating and fast turning",
    "drift": "the patterns' own drift",
    "accelerometers": "accelerometer biases",
    "noise": "gyro noise: white, flicker, random walk",
    "alignment": "second-order error of the alignment",
}
"""Parts of the flown error, which is their sum as vectors."""

TRIAD, CALIBRATION, MISSION, CLASS = "triad", "calibration", "mission", "mission_class"
HALF, HOURS = "half", "hours"
FLOWN_NORTH, FLOWN_EAST, FLOWN_RADIAL = "flown_north_m", "flown_east_m", "flown_radial_m"
GROWTH = "growth_radial_m"
RMS_OVER_ANGLES = "rms_over_angles_m"
COSIMULATED = "cosimulated_radial_m"
FIXED_STABILITY, CIRCUMFERENCE_STABILITY = "fixed_stability_deg_h", "circumference_stability_deg_h"
MAP_RMS = "map_rms_deg_h"
UNPREDICTABLE = "unpredictable_rms_m"
GYROS_FLOWN, GYROS_FITTED = "gyros_flown_rms_over_angles_m", "gyros_fitted_rms_over_angles_m"
GYROS_FIXED, GYROS_CIRCUMFERENCE = "gyros_fixed_stability_deg_h", "gyros_circumference_deg_h"

GROWTH_STEP_HOURS = 1 / 6
"""Time between the elements of `GROWTH`; the first is one step after the alignment."""


def name_part(name: str, axis: str) -> str:
    """The column of a part of the flown error along an axis, "north" or "east"."""
    return f"{name}_{axis}_m"


COLUMNS = (
    Column(TRIAD, "int", "1", "number of the triad, from 0"),
    Column(CALIBRATION, "text", "", "what the maker calibrates: mean or map"),
    Column(MISSION, "text", "", "name of the mission"),
    Column(CLASS, "text", "", "mission class: car, ship, ..."),
    Column(HALF, "text", "", "train, or test: triads and classes that no predictor was made on"),
    Column(HOURS, "number", "h", "time of navigation at which the error is judged"),
    Column(FLOWN_NORTH, "number", "m", "position error north, navigated less true"),
    Column(FLOWN_EAST, "number", "m", "position error east"),
    Column(FLOWN_RADIAL, "number", "m", "horizontal position error"),
    *(
        Column(name_part(name, axis), "number", "m", f"{axis} part of the error: {what}")
        for name, what in PARTS.items()
        for axis in ("north", "east")
    ),
    Column(GROWTH, "numbers", "m", "horizontal position error every 10 min of navigation"),
    Column(RMS_OVER_ANGLES, "number", "m", "rms horizontal error over power-on angles"),
    Column(COSIMULATED, "number", "m", "horizontal error of the co-simulation; NaN where not done"),
    Column(FIXED_STABILITY, "number", "deg/h", "bench: fixed-position stability, rms of the gyros"),
    Column(CIRCUMFERENCE_STABILITY, "number", "deg/h", "bench: full-circumference stability, rms"),
    Column(MAP_RMS, "number", "deg/h", "bench: rms of the fitted bias maps over the circumference"),
    Column(UNPREDICTABLE, "number", "m", "rms error by drift of maps, noise and accelerometers"),
    Column(GYROS_FLOWN, "numbers", "m", "each gyro: rms error over power-on angles and mountings"),
    Column(GYROS_FITTED, "numbers", "m", "each gyro: the same rms error by the bench's maps"),
    Column(GYROS_FIXED, "numbers", "deg/h", "bench: fixed-position stability of each gyro"),
    Column(GYROS_CIRCUMFERENCE, "numbers", "deg/h", "bench: full-circumference stability of each"),
    *(
        column
        for p in PREDICTORS
        for column in (
            Column(p.median, "number", "m", f"predicted horizontal error, median: {p.what}"),
            Column(p.low, "number", "m", f"lower end of its interval: {p.what}"),
            Column(p.high, "number", "m", f"upper end of its interval: {p.what}"),
        )
    ),
    *(
        Column(f"{key}_{axis}_m", "number", "m", f"predicted {axis} error, mean: {key}")
        for key in ("fitted_map", "oracle")
        for axis in ("north", "east")
    ),
)
