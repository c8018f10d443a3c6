"""Effects of the gyro on a navigator: flights, alignment, error budgets, the study of bench tests.

Names load on first use.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
