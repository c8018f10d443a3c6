"""IMUs as TOML files."""

from pathlib import Path

from ins_eval.imu.gyros import DeviceError, FmuGyros, device, difference
from ins_eval.imu.imu import Imu
from ins_eval.imu.mounting import ORTHOGONAL, Mounting, MountingError, mounted
from ins_eval.imu.stated_gyros import Gyros, StatedGyros
from ins_eval.imu.triad import Triad
from ins_eval.imu.triad_keys import ACCELEROMETERS, GYROS, read_triad, triad_keys
from pyhrg.common.files import toml_of
from pyhrg.common.toml_table import SpecificationError, TomlTable
from pyhrg.common.units import ARCSEC

__all__ = ["READY", "SpecificationError", "imu", "read"]

_FOLDER = Path(__file__).with_name("ready")
READY = tuple(sorted(path.stem for path in _FOLDER.glob("*.toml")))
"""Names of the IMUs that come with the package; each is a file in `ready`."""

PLACES = ("first", "second", "third")
"""The gyros in the order of the mounting's axes."""
LARGEST_TILT = 3600.0
"""Of an input axis, arcsec, as a standard deviation."""


def imu(name_or_path: str) -> Imu:
    """One that comes with the package, or the one in a file.

    Raises:
        SpecificationError: see `read`; neither a name nor a file.
    """
    if name_or_path in READY:
        return read(_FOLDER / f"{name_or_path}.toml")
    if not Path(name_or_path).is_file():
        raise SpecificationError(
            f"{name_or_path}: found no such file, expected one or {', '.join(READY)}"
        )
    return read(Path(name_or_path))


def read(path: Path) -> Imu:
    """Read an IMU; an empty file is an ideal one at 100 Hz.

    Args:
        path: TOML. At the top `name` and `rate_hz`; tables `[gyros]` with `device` ("typical" or a
            device file, from the folder of this one; then `own_axes`, `calibrated` and
            `[gyros.first]` to `[gyros.third]` with keys of a device file) or `kind` ("ideal",
            "simple" with the keys of `triad_keys.GYROS`); `[gyros.mounting]` with `axes` (rows
            forward, right, down of any length) and `error_sigma_arcsec`; `[accelerometers]` with
            the keys of `triad_keys.ACCELEROMETERS`.

    Raises:
        SpecificationError: an unreadable file, an unknown key, a value that is of no use.
    """
    table = TomlTable(str(path), "", toml_of(path, SpecificationError))
    table.check_known(("name", "rate_hz", "gyros", "accelerometers"))
    mounting = table.table("gyros").table("mounting")
    return Imu(
        gyros=_gyros(table.table("gyros"), path.parent),
        accelerometers=_accelerometers(table.table("accelerometers")),
        interval=1 / table.number("rate_hz", 100.0, 10.0, 2000.0),
        mounting=_mounting(mounting),
        mounting_deviation=ARCSEC * mounting.number("error_sigma_arcsec", 0.0, 0.0, LARGEST_TILT),
        name=table.text("name", path.stem),
    )


def _accelerometers(table: TomlTable) -> Triad:
    table.check_known(triad_keys(ACCELEROMETERS))
    return read_triad(table, ACCELEROMETERS)


def _mounting(table: TomlTable) -> Mounting:
    table.check_known(("axes", "error_sigma_arcsec"))
    if "axes" not in table.values:
        return ORTHOGONAL
    axes = table.values["axes"]
    try:
        return mounted(axes)
    except (MountingError, TypeError, ValueError) as error:
        raise table.error("axes", axes, f"three input axes, each [x, y, z]: {error}") from error


def _gyros(table: TomlTable, folder: Path) -> Gyros:
    if "device" in table.values:
        return _fmu_gyros(table, folder)
    kind = table.text("kind", "ideal", ("ideal", "simple"))
    table.check_known(("kind", "mounting", *(triad_keys(GYROS) if kind == "simple" else ())))
    return StatedGyros(read_triad(table, GYROS))


def _fmu_gyros(table: TomlTable, folder: Path) -> FmuGyros:
    table.check_known(("device", "own_axes", "calibrated", "mounting", *PLACES))
    try:
        return FmuGyros(
            device(table.text("device", "typical"), folder),
            own_axes=table.flag("own_axes", True),
            calibrated=table.flag("calibrated", True),
            differences=tuple(
                difference(table.table(place).values, f"{table.source}: gyros.{place}")
                for place in PLACES
            ),
        )
    except DeviceError as error:
        raise SpecificationError(str(error)) from error
