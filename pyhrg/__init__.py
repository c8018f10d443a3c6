"""The gyro as a user meets it: devices, simulation, bench tests, records, diagnosis.

Names load on first use. `ins_eval` is the navigator's side; `fmu_build` makes the FMU.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
