"""The library that runs several gyros of one FMU side by side, in the lanes of a processor's
vectors; made of the sources in the FMU's archive, for this machine alone."""

import shutil
import tempfile
from pathlib import Path

import llvmlite.binding

from fmu_build.binaries.libraries import fetch_library
from fmu_build.binaries.platforms import FLAGS, PLATFORMS, find_host_platform

OWN_SOURCES = Path(__file__).parent / "side_by_side"
MODEL_SOURCES = ("model.c", "core.c", "limits.c")


def build_lanes(sources: Path, width: int) -> bytes:
    """Library for up to `width` gyros of the FMU whose C sources are in a folder: from the user's
    cache, built if it isn't there.

    Raises:
        BuildError: it can't be built; the message is the compiler's.
        OSError: a source is missing, or the cache can't be written.
    """
    processor = llvmlite.binding.get_host_cpu_features().flatten()
    flags = [*FLAGS, "-mcpu=native", f"-DWIDTH={width}"]
    with tempfile.TemporaryDirectory(prefix="hrg-build-") as name:
        folder = Path(name)
        own = [*OWN_SOURCES.iterdir()]
        for file in (*own, *sources.glob("*.h"), *(sources / each for each in MODEL_SOURCES)):
            shutil.copy(file, folder)
        files = sorted(file.name for file in own if file.suffix == ".c")
        host = PLATFORMS[find_host_platform()]
        names = [*files, "limits.c"]
        return fetch_library(folder, names, "lanes", host, flags=flags, processor=processor)
