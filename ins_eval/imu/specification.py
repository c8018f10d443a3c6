"""IMUs by name or as TOML files."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ins_eval.imu.gyros import FmuGyros, read_differences
from ins_eval.imu.imu import Imu
from ins_eval.imu.mounting import ORTHOGONAL, Mounting, MountingError, make_mounting
from ins_eval.imu.sensor_error_model import AxisConstants, SensorErrorModel
from ins_eval.imu.stated_gyros import StatedGyros
from pyhrg.common.files import is_file, make_missing_error
from pyhrg.common.toml_table import TomlTable, read_table
from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR, MICRO_G, PPM
from pyhrg.device.ready_devices import READY, load_device

READY_FOLDER = Path(__file__).with_name("ready")
"""Folder of the IMUs that come with the package, one TOML file each."""
GYRO_KEYS = ("first", "second", "third")
"""Keys of the gyros in the order of the mounting's axes."""
MAX_MOUNTING_ERROR = 3600.0
"""Largest standard deviation of an input axis' error, arcsec. Chosen."""


@dataclass(frozen=True)
class ErrorKey:
    """A number of the file: SI is value * factor; `high` is the largest size in the file's unit.

    Attributes:
        name: key in the file; `{}` stands where `_sigma` may go.
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
    ErrorKey("velocity_random_walk_m_s_sqrt_h", "random_walk", HOUR**-0.5, 100),
    ErrorKey("bias_instability_micro_g", "bias_instability", MICRO_G, 1e5),
    ErrorKey("quantum_m_s", "quantization_step", 1.0, 1.0),
)
GYROS = (
    ErrorKey("bias{}_deg_h", "bias", DEG_PER_H, 1e5, 3),
    *SHARED,
    ErrorKey("angle_random_walk_deg_sqrt_h", "random_walk", DEG_PER_SQRT_H, 100),
    ErrorKey("bias_instability_deg_h", "bias_instability", DEG_PER_H, 1e4),
    ErrorKey("quantum_arcsec", "quantization_step", ARCSEC, 3600),
)
"""A constant has two keys: `bias_deg_h`, the values by axis, and `bias_sigma_deg_h`, the standard
deviation of what is drawn beside them. Misalignments are in the order of `Triad`."""


def list_imus() -> list[str]:
    """Return the names of the IMUs that come with the package."""
    return sorted(path.stem for path in READY_FOLDER.glob("*.toml"))


def load_imu(name_or_path: str | Path) -> Imu:
    """Load an IMU that comes with the package (`list_imus`), or one from a TOML file.

    Raises:
        HrgError: neither a name nor a file, or a file that is wrong (`read_imu`).
    """
    if str(name_or_path) in list_imus():
        return read_imu(READY_FOLDER / f"{name_or_path}.toml")
    if not is_file(name_or_path):
        raise make_missing_error(name_or_path, "IMU", list_imus())
    return read_imu(Path(name_or_path))


def read_imu(path: Path) -> Imu:
    """Read an IMU from a TOML file; an empty file is an ideal IMU at 100 Hz.

    Args:
        path: TOML. At the top `name` and `rate_hz`; tables `[gyros]` with `device` ("typical" or a
            device file, from the folder of this one; then `own_axes`, `calibrated` and
            `[gyros.first]` to `[gyros.third]` with keys of a device file) or `kind` ("ideal",
            "simple" with the keys of `GYROS`); `[gyros.mounting]` with `axes` (rows
            forward, right, down of any length) and `error_sigma_arcsec`; `[accelerometers]` with
            the keys of `ACCELEROMETERS`.

    Raises:
        HrgError: an unreadable file, an unknown key, a value of the wrong type or range.
    """
    table = read_table(path)
    table.check_known(("name", "rate_hz", "gyros", "accelerometers"))
    mounting = table.table("gyros").table("mounting")
    accelerometers = table.table("accelerometers")
    accelerometers.check_known(error_keys(ACCELEROMETERS))
    return Imu(
        gyros=_gyros(table.table("gyros"), path.parent),
        accelerometers=read_error_model(accelerometers, ACCELEROMETERS),
        interval=1 / table.number("rate_hz", 100.0, 10.0, 2000.0),
        mounting=_mounting(mounting),
        mounting_deviation=ARCSEC
        * mounting.number("error_sigma_arcsec", 0.0, 0.0, MAX_MOUNTING_ERROR),
        name=table.text("name", path.stem),
    )


def _mounting(table: TomlTable) -> Mounting:
    table.check_known(("axes", "error_sigma_arcsec"))
    if "axes" not in table.values:
        return ORTHOGONAL
    axes = table.values["axes"]
    try:
        return make_mounting(axes)
    except (MountingError, TypeError, ValueError) as error:
        raise table.error("axes", axes, f"three input axes, each [x, y, z]: {error}") from error


def _gyros(table: TomlTable, folder: Path) -> FmuGyros | StatedGyros:
    if "device" in table.values:
        return _fmu_gyros(table, folder)
    kind = table.text("kind", "ideal", ("ideal", "simple"))
    table.check_known(
        ("device", "kind", "mounting", *(error_keys(GYROS) if kind == "simple" else ()))
    )
    return StatedGyros(read_error_model(table, GYROS))


def _fmu_gyros(table: TomlTable, folder: Path) -> FmuGyros:
    table.check_known(("device", "own_axes", "calibrated", "mounting", *GYRO_KEYS))
    name = table.text("device", "typical")
    if name not in READY and not is_file(folder / name):
        raise table.error("device", name, f"{', '.join(READY)}, or a file in {folder.resolve()}")
    return FmuGyros(
        load_device(name if name in READY else folder / name),
        own_axes=table.flag("own_axes", True),
        calibrated=table.flag("calibrated", True),
        differences=tuple(
            read_differences(table.table(place).values, f"{table.source}: gyros.{place}")
            for place in GYRO_KEYS
        ),
    )


def error_keys(keys: tuple[ErrorKey, ...]) -> list[str]:
    """Names in the file."""
    signs = [(key, "_sigma") for key in keys if key.count]
    return [key.name.format(sign) for key, sign in [*((k, "") for k in keys), *signs]]


def read_error_model(table: TomlTable, keys: tuple[ErrorKey, ...]) -> SensorErrorModel:
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
