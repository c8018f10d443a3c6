from .binaries.platforms import PLATFORMS, BuildError
from .bundle import build_fmu
from .check.report import FmuReport, check_fmu
from .equations.translate import TranslationError
from .roots import ROOTS

__all__ = [
    "PLATFORMS",
    "ROOTS",
    "BuildError",
    "FmuReport",
    "TranslationError",
    "build_fmu",
    "check_fmu",
]
