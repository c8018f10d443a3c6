"""Keys of a triad's errors in a TOML file, with units and ranges."""

from dataclasses import dataclass
from typing import Any

from ins_eval.imu.sensor_error_model import AxisConstants, SensorErrorModel
from pyhrg.common.toml_table import TomlTable
from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR, MICRO_G, PPM


@dataclass(frozen=True)
class ErrorKey:
    """A number of the file: SI is value * factor; `high` is the largest size in the file's unit.

    name: with `{}` where `_sigma` goes.
    """

    name: str
    field: str
    factor: float
    high: float
    count: int = 0
    """Values by axis, if it is an `AxisConstants`; 0 if it is one number for all."""


SHARED = (
    ErrorKey("scale_factor{}_ppm", "scale_factor", PPM, 1e5, 3),
    ErrorKey("misalignment{}_arcsec", "misalignment", ARCSEC, 2e4, 6),
)
ACCELEROMETERS = (
    ErrorKey("bias{}_micro_g", "bias", MICRO_G, 1e6, 3),
    *SHARED,
    ErrorKey("velocity_random_walk_m_s_sqrt_h", "white", HOUR**-0.5, 100),
    ErrorKey("bias_instability_micro_g", "bias_instability", MICRO_G, 1e5),
    ErrorKey("quantum_m_s", "quantization_step", 1.0, 1.0),
)
GYROS = (
    ErrorKey("bias{}_deg_h", "bias", DEG_PER_H, 1e5, 3),
    *SHARED,
    ErrorKey("angle_random_walk_deg_sqrt_h", "white", DEG_PER_SQRT_H, 100),
    ErrorKey("bias_instability_deg_h", "bias_instability", DEG_PER_H, 1e4),
    ErrorKey("quantum_arcsec", "quantization_step", ARCSEC, 3600),
)
"""A constant has two keys: `bias_deg_h`, the values by axis, and `bias_sigma_deg_h`, the standard
deviation of what is drawn beside them. Misalignments are in the order of `Triad`."""


def error_keys(keys: tuple[ErrorKey, ...]) -> list[str]:
    """Names in the file."""
    signs = [(key, "_sigma") for key in keys if key.count]
    return [key.name.format(sign) for key, sign in [*((k, "") for k in keys), *signs]]


def read_error_model(table: TomlTable, keys: tuple[ErrorKey, ...]) -> SensorErrorModel:
    """The triad of a table."""
    values: dict[str, Any] = {key.field: _value(table, key) for key in keys}
    return SensorErrorModel(**values)


def _value(table: TomlTable, key: ErrorKey) -> AxisConstants | float:
    if not key.count:
        return key.factor * table.number(key.name, 0.0, 0.0, key.high)
    name = key.name.format("")
    drawn = key.factor * table.number(key.name.format("_sigma"), 0.0, 0.0, key.high)
    if name not in table.values:
        return AxisConstants(deviation=drawn)
    given = table.numbers(name, key.count, -key.high, key.high)
    return AxisConstants(tuple(key.factor * value for value in given), drawn)
