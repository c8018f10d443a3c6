import json
from collections.abc import Callable
from pathlib import Path

import pytest

from pyhrg.gap.report.sections import Maker, Say, Section, made


def told(folder: Path, say: Say) -> Section:
    return Section("Position", f"<p>{folder.name}</p>", {"metres": 1.5})


def failing(folder: Path, say: Say) -> Section:
    raise ValueError("no <mission>")


def infinite(folder: Path, say: Say) -> Section:
    return Section("Position", "", {"metres": float("inf")})


def absent() -> Maker:
    raise ModuleNotFoundError("No module named 'above'")


def test_a_section_is_what_its_function_makes(tmp_path: Path) -> None:
    section = made("position", lambda: told, tmp_path, print)
    assert section.html == f"<p>{tmp_path.name}</p>"
    assert json.loads(section.data()) == {"metres": 1.5}


@pytest.mark.parametrize(
    ("load", "why"),
    [
        (lambda: failing, "ValueError: no <mission>"),
        (lambda: infinite, "not JSON compliant"),
        (absent, "ModuleNotFoundError: No module named 'above'"),
    ],
)
def test_one_that_fails_says_so_and_raises_nothing(
    load: Callable[[], Maker], why: str, tmp_path: Path
) -> None:
    section = made("position", load, tmp_path, print)
    assert section.title == "Position"
    assert why in section.document["failed"]
    assert "<mission>" not in section.html


def test_a_user_can_still_interrupt(tmp_path: Path) -> None:
    def interrupted(folder: Path, say: Say) -> Section:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        made("position", lambda: interrupted, tmp_path, print)
