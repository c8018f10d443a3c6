"""Every column of study.parquet, once: one row a triad of gyros, its calibration and a mission.

Each column's field metadata carries its `unit` and `what`. For scores see `score.py`.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Column:
    """name: as in the file, with its unit; kind: "int", "text", "number" or "numbers" (a list);
    unit: "1" for pure numbers, "" for text; what: it means, a phrase."""

    name: str
    kind: str
    unit: str
    what: str


@dataclass(frozen=True)
class Predictor:
    """key: prefix of its columns; title: as read; what: it knows."""

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
    Predictor("fitted_map", "Fitted map", "the bench's maps, temperature and power-on angle known"),
    Predictor("fitted_map_any_angle", "Fitted map, any angle", "the bench's maps, angle unknown"),
    Predictor(
        "bench_oracle", "Oracle, drift unknown", "true maps on the bench, spread as the fit's"
    ),
    Predictor("oracle", "Oracle", "the true parameters; what no bench can know"),
    Predictor("oracle_any_angle", "Oracle, any angle", "the true parameters, angle unknown"),
)
"""From simple to best; the oracle is what they are held against."""

PARTS = {
    "map": "bias and scale-factor maps at power-on",
    "warming": "what the maps gain as the gyros warm",
    "environment": "what the maps gain with specific force, heating and fast turning",
    "drift": "the patterns' own drift",
    "accelerometers": "accelerometer biases",
    "noise": "gyro noise: white, flicker, random walk",
    "alignment": "what aligning does beyond first order",
}
"""Of the flown error, which they sum up to as vectors."""

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
"""Between the elements of `GROWTH`; the first stands one step after the alignment."""


def part(name: str, axis: str) -> str:
    """Column of a part of the flown error along an axis, "north" or "east"."""
    return f"{name}_{axis}_m"


COLUMNS = (
    Column(TRIAD, "int", "1", "number of the triad, from 0"),
    Column(CALIBRATION, "text", "", "by the maker: mean (bias and scale factor) or map"),
    Column(MISSION, "text", "", "name of the mission"),
    Column(CLASS, "text", "", "of the mission: car, ship, ..."),
    Column(HALF, "text", "", "train, or test: triads and classes that no predictor was made on"),
    Column(HOURS, "number", "h", "of navigation when the error is judged"),
    Column(FLOWN_NORTH, "number", "m", "position error north, navigated less true"),
    Column(FLOWN_EAST, "number", "m", "position error east"),
    Column(FLOWN_RADIAL, "number", "m", "horizontal position error"),
    *(
        Column(part(name, axis), "number", "m", f"{axis} part of the error: {what}")
        for name, what in PARTS.items()
        for axis in ("north", "east")
    ),
    Column(GROWTH, "numbers", "m", "horizontal position error every 10 min of navigation"),
    Column(RMS_OVER_ANGLES, "number", "m", "rms horizontal error over power-on angles"),
    Column(COSIMULATED, "number", "m", "horizontal error of the co-simulation; NaN where not done"),
    Column(FIXED_STABILITY, "number", "deg/h", "bench: fixed-position stability, rms of the three"),
    Column(CIRCUMFERENCE_STABILITY, "number", "deg/h", "bench: full circumference, rms of three"),
    Column(MAP_RMS, "number", "deg/h", "bench: rms of the fitted bias maps over the circumference"),
    Column(UNPREDICTABLE, "number", "m", "rms error by drift of maps, noise and accelerometers"),
    Column(GYROS_FLOWN, "numbers", "m", "rms error over power-on angles and mountings, each gyro"),
    Column(GYROS_FITTED, "numbers", "m", "the same of the bench's maps"),
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
