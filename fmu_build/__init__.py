"""Modelica to FMU: translate, generate C, compile, describe, pack and check.

The front door: `build_fmu` gives the gyro as a file, `check_fmu` judges any FMU. Names load on
first use.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
