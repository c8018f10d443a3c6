"""The devices that come with the package; each is a file in `devices`."""

from pathlib import Path

from pyhrg.device import device_file
from pyhrg.device.device import Device

__all__ = ["TABLE2", "TYPICAL", "Device"]

_FOLDER = Path(__file__).with_name("ready")
TYPICAL = device_file.read(_FOLDER / "typical.toml")
"""A 20 mm gyro whose damping anisotropy is trimmed; the file says what it stands for."""
TABLE2 = device_file.read(_FOLDER / "table2.toml")
"""The gyro of the paper's Table 2; the file says what it stands for."""
