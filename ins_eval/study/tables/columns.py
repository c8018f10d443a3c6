"""study.parquet: one row for each triad of gyros, calibration and mission.

The metadata of each column carry its `unit` and `what`. For scores see `score.py`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq


@dataclass(frozen=True)
class Column:
    """A column.

    Attributes:
        name: name in the file.
        kind: "int", "text", "number" or "numbers" (a list).
        unit: "1" for pure numbers, "" for text.
        what: meaning, a phrase.
    """

    name: str
    kind: str
    unit: str
    what: str


@dataclass(frozen=True)
class Predictor:
    """A predictor of the position error.

    Attributes:
        key: prefix of its columns.
        title: name in reports.
        what: what it uses, a phrase.
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


FIXED_RULE, CIRCUMFERENCE_RULE = "fixed_rule", "circumference_rule"
FIXED_CLASS, CIRCUMFERENCE_CLASS = "fixed_class", "circumference_class"
CLASS_ERROR, FIXED_MEAN = "class_error", "fixed_mean"
FITTED_MAP, ANY_ANGLE, TRUE_PARAMETERS = "fitted_map", "fitted_map_any_angle", "true_parameters"
PREDICTORS = (
    Predictor(FIXED_RULE, "Fixed position", "fixed-position stability, 0.01 deg/h ~ 1 nmi/h"),
    Predictor(
        CIRCUMFERENCE_RULE, "Full circumference", "8N full-circumference stability, same rule"
    ),
    Predictor(
        FIXED_CLASS,
        "Fixed position, class constant",
        "fixed-position stability times the constant of the mission class",
    ),
    Predictor(
        CIRCUMFERENCE_CLASS,
        "Full circumference, class constant",
        "full-circumference stability times the constant of the mission class",
    ),
    Predictor(
        CLASS_ERROR,
        "Class alone, no bench test",
        "error of the training triads in the mission class, the same for every triad",
    ),
    Predictor(
        FIXED_MEAN,
        "Fixed position, mean bias",
        "mean bias of the fixed-position test as a constant rate; the flight starts at that angle",
    ),
    Predictor(FITTED_MAP, "Fitted map", "the bench's maps; temperature and power-on angle known"),
    Predictor(ANY_ANGLE, "Fitted map, start anywhere", "the bench's maps; power-on angle unknown"),
    Predictor(
        TRUE_PARAMETERS, "True parameters", "the true maps in flight, which no bench measures"
    ),
)
"""All predictors, from simple to best. The true parameters are the yardstick of the others."""
PREDICTOR_OF = {predictor.key: predictor for predictor in PREDICTORS}
TURN_ON, TURN_ON_ANYWHERE = "turn_on", "turn_on_anywhere"
FIGURE_TITLES = {
    TURN_ON: "Fixed position, repeatability over turn-ons",
    TURN_ON_ANYWHERE: "Repeatability if patterns start anywhere",
}
"""Bench figures that rank gyros and predict no error."""

PARTS = {
    "map": "bias and scale-factor maps at power-on",
    "warming": "change of the maps while the gyros warm",
    "environment": "sensitivity of the maps to specific force, heating and fast turning",
    "drift": "the patterns' own drift",
    "accelerometers": "accelerometer biases",
    "mounting": "input axes that lean",
    "noise": "gyro noise: white, flicker, random walk",
    "alignment": "second-order error of the alignment",
}
"""Parts of the error by the linear model, which is their sum as vectors."""

TRIAD, CALIBRATION, MISSION, CLASS = "triad", "calibration", "mission", "mission_class"
ROLE, HOURS = "role", "hours"
FLOWN_NORTH, FLOWN_EAST, FLOWN_RADIAL = "flown_north_m", "flown_east_m", "flown_radial_m"
GROWTH = "growth_radial_m"
FLOWN_BY, LINEAR_RADIAL = "flown_by", "linear_radial_m"
COSIMULATED, LINEAR = "co-simulated", "linear"
"""How a flight was flown: values of `FLOWN_BY`."""
FIXED_STABILITY, CIRCUMFERENCE_STABILITY = "fixed_stability_deg_h", "circumference_stability_deg_h"
MAP_RMS = "map_rms_deg_h"
GYROS_LINEAR, GYROS_FITTED = "gyros_linear_rms_over_angles_m", "gyros_fitted_rms_over_angles_m"
GYROS_FIXED, GYROS_CIRCUMFERENCE = "gyros_fixed_stability_deg_h", "gyros_circumference_deg_h"
GYROS_TURN_ON = "gyros_turn_on_repeatability_deg_h"
GYROS_TURN_ON_ANYWHERE = "gyros_turn_on_anywhere_deg_h"

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
    Column(ROLE, "text", "", "train; test: triads that no predictor was made on; or condition"),
    Column(HOURS, "number", "h", "time of navigation at which the error is judged"),
    Column(FLOWN_BY, "text", "", "co-simulated (FMUs at 1 kHz, navigator) or linear (error model)"),
    Column(FLOWN_NORTH, "number", "m", "position error north, navigated less true"),
    Column(FLOWN_EAST, "number", "m", "position error east"),
    Column(FLOWN_RADIAL, "number", "m", "horizontal position error"),
    *(
        Column(name_part(name, axis), "number", "m", f"{axis} part, linear model: {what}")
        for name, what in PARTS.items()
        for axis in ("north", "east")
    ),
    Column(GROWTH, "numbers", "m", "horizontal position error every 10 min of navigation"),
    Column(LINEAR_RADIAL, "number", "m", "horizontal error by the linear model, noise of its own"),
    Column(FIXED_STABILITY, "number", "deg/h", "bench: fixed-position stability, rms of the gyros"),
    Column(CIRCUMFERENCE_STABILITY, "number", "deg/h", "bench: full-circumference stability, rms"),
    Column(MAP_RMS, "number", "deg/h", "bench: rms of the fitted bias maps over the circumference"),
    Column(
        GYROS_LINEAR,
        "numbers",
        "m",
        "each gyro: rms error by its true map alone, linear model, over 16 power-on angles and "
        "three mountings; not flown",
    ),
    Column(GYROS_FITTED, "numbers", "m", "each gyro: the same rms error by the bench's maps"),
    Column(GYROS_FIXED, "numbers", "deg/h", "bench: fixed-position stability of each gyro"),
    Column(GYROS_TURN_ON, "numbers", "deg/h", "bench: repeatability over turn-ons of each gyro"),
    Column(
        GYROS_TURN_ON_ANYWHERE,
        "numbers",
        "deg/h",
        "fitted map: repeatability of each gyro if its pattern started anywhere",
    ),
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
        for key in (FITTED_MAP, TRUE_PARAMETERS)
        for axis in ("north", "east")
    ),
)


ARROW_TYPES = {
    "int": pa.int64(),
    "text": pa.string(),
    "number": pa.float64(),
    "numbers": pa.list_(pa.float64()),
}


TABLE = "study.parquet"
ROW_GROUP_SIZE = 4096
"""Rows of a row group."""


def make_table(columns: Mapping[str, Sequence[Any]]) -> pa.Table:
    """The table from the values of all columns, by name; their metadata are `unit` and `what`.

    Raises:
        ValueError: a column is missing, unknown, or of another length.
    """
    wanted = pa.schema([_make_field(column) for column in COLUMNS])
    if differ := set(columns) ^ set(wanted.names):
        raise ValueError(f"columns: found {sorted(columns)}, differing in {sorted(differ)}")
    arrays = [pa.array(columns[field.name], field.type) for field in wanted]
    return pa.Table.from_arrays(arrays, schema=wanted)


def write_table(rows: pa.Table, path: Path) -> None:
    """Write a table; the same rows and library give the same bytes."""
    pq.write_table(rows, path, row_group_size=ROW_GROUP_SIZE)


def _make_field(column: Column) -> pa.Field:
    metadata = {"unit": column.unit, "what": column.what}
    return pa.field(column.name, ARROW_TYPES[column.kind], metadata=metadata)
