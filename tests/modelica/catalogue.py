"""The catalogue of mechanisms, the info page `HRG.UsersGuide.Mechanisms`."""

import re

from fmu_build.bundle import find_modelica_library


def read_catalogue() -> str:
    """Text of the page."""
    page = find_modelica_library() / "UsersGuide" / "Mechanisms.mo"
    return page.read_text(encoding="utf-8")


def read_catalogue_numbers() -> set[int]:
    """Numbers of its rows."""
    return {int(number) for number in re.findall(r"<tr><td>(\d+)</td>", read_catalogue())}
