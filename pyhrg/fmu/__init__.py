"""The only FMI importer: gyros as instances of the FMU, driven by compiled loops.

`GyroFmu` is the archive, `Gyro` one gyro that is switched on.
"""

from pyhrg.fmu.archive import GyroError
from pyhrg.fmu.gyro import Gyro
from pyhrg.fmu.gyro_fmu import GyroFmu, load_own_fmu
from pyhrg.fmu.rows import COMMANDS, CONTROL_PERIOD
from pyhrg.fmu.together import WIDE, can_record_together, record_together

__all__ = [
    "COMMANDS", "CONTROL_PERIOD", "WIDE", "Gyro", "GyroError", "GyroFmu",
    "can_record_together", "load_own_fmu", "record_together",
]  # fmt: skip
