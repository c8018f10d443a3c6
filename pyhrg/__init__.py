"""The gyro: its devices, simulation, bench tests, records and diagnosis.

Names load on first use. `ins_eval` has the navigator; `fmu_build` builds the FMU.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
