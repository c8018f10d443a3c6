from .binaries.platforms import PLATFORMS, BuildError
from .bundle import build_fmu
from .check.report import CheckReport, check_fmu
from .roots import PARTS, ROOTS

__all__ = [
    "PARTS",
    "PLATFORMS",
    "ROOTS",
    "BuildError",
    "CheckReport",
    "build_fmu",
    "check_fmu",
]
