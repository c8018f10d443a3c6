"""The binary that importers on this machine load."""

from collections.abc import Iterator

from fmu_build.binaries.platforms import PLATFORMS, BuildError, find_host_platform
from fmu_build.check.archive import Fmu
from fmu_build.check.experiment import Experiment


def find_missing_binary(fmu: Fmu, planned: Experiment) -> Iterator[str]:
    """Says so where there is none; nothing on a machine whose folder we don't know."""
    try:
        platform = PLATFORMS[find_host_platform()]
    except BuildError:
        return
    folder = (platform.fmi2_folder if fmu.major == 2 else None) or platform.name
    library = f"binaries/{folder}/{planned.identifier}{platform.suffix}"
    if library not in fmu.names:
        yield f"no binary for this machine: {library} is missing"
