"""Build backend: hatchling's, but a wheel also holds the gyros as FMUs, so that no compiler is
needed where it is installed. An editable install holds none: a checkout builds its own."""

import re
import shutil
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import Any

from hatchling import build as hatchling
from hatchling.build import (  # noqa: F401 (the frontend calls them)
    build_editable,
    build_sdist,
    get_requires_for_build_editable,
    get_requires_for_build_sdist,
)

USED_BY_FMU_BUILD = ("fmpy", "lazy-loader", "platformdirs")
"""Dependencies of this distribution without which no FMU can be built."""


def get_requires_for_build_wheel(config_settings: Any = None) -> list[str]:
    project = tomllib.loads(Path("pyproject.toml").read_text())["project"]
    needed = [
        requirement
        for requirement in project["dependencies"]
        if re.split("[=<>~!]", requirement)[0] in USED_BY_FMU_BUILD
    ]
    standard = hatchling.get_requires_for_build_wheel(config_settings)
    return [*standard, *needed, *project["optional-dependencies"]["build"]]


def build_wheel(
    wheel_directory: str, config_settings: Any = None, metadata_directory: str | None = None
) -> str:
    with tempfile.TemporaryDirectory() as folder:
        # an FMU states version and licence of the installed distribution: here a wheel without FMUs
        sys.path.append(str(Path(folder) / hatchling.build_wheel(folder)))
        from fmu_build.bundle import PREBUILT, write_prebuilt

        try:
            write_prebuilt(print)
            return hatchling.build_wheel(wheel_directory, config_settings, metadata_directory)
        finally:
            shutil.rmtree(PREBUILT, ignore_errors=True)
