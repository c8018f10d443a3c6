"""The only FMI importer: gyros as instances of the FMU, driven by compiled loops.

`GyroFmu` is the archive, `Gyro` one gyro that is switched on.
"""

from pyhrg.fmu.archive import GyroError
from pyhrg.fmu.gyro import CHUNK, COMMANDS, CONTROL_PERIOD, Gyro
from pyhrg.fmu.gyro_fmu import GyroFmu

__all__ = ["CHUNK", "COMMANDS", "CONTROL_PERIOD", "Gyro", "GyroError", "GyroFmu"]
