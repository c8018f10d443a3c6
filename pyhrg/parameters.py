"""The devices that come with the package; each is a file in `devices`."""

from pathlib import Path

from pyhrg import device_file
from pyhrg.device import Device

__all__ = ["TYPICAL", "Device"]

TYPICAL = device_file.read(Path(__file__).with_name("devices") / "typical.toml")
"""A 20 mm gyro whose damping anisotropy is trimmed; the file says what it stands for."""
