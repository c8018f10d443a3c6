"""The devices that come with the package, and devices by name or file."""

from pathlib import Path

from pyhrg.common.files import is_file, make_missing_error
from pyhrg.device import device_file
from pyhrg.device.device import Device

__all__ = ["READY", "TABLE2", "TYPICAL", "Device", "load_device"]

_FOLDER = Path(__file__).with_name("ready")
READY = tuple(sorted(path.stem for path in _FOLDER.glob("*.toml")))
"""Names of the ready devices; each is a file in the folder `ready`."""


def load_device(name_or_path: str | Path) -> Device:
    """Load a device that comes with the package, or one from a file.

    Args:
        name_or_path: one of `READY`, or a device file (TOML).

    Raises:
        HrgError: there is neither such a device nor such a file, or the file can't be used.
    """
    if str(name_or_path) in READY:
        return device_file.read(_FOLDER / f"{name_or_path}.toml")
    path = Path(name_or_path)
    if not is_file(path):
        raise make_missing_error(name_or_path, "device", READY)
    return device_file.read(path)


TYPICAL = load_device("typical")
"""A 20 mm gyro whose damping anisotropy is trimmed; the file says what it stands for."""
TABLE2 = load_device("table2")
"""The gyro of the paper's Table 2; the file says what it stands for."""
