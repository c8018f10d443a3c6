"""Mission files: what is right goes through, what is wrong is named."""

from dataclasses import MISSING
from pathlib import Path

import numpy as np
import pytest

from ins_eval.trajectories.keys import keys
from ins_eval.trajectories.manoeuvres.overlays import Sway
from ins_eval.trajectories.manoeuvres.straights import Straight
from ins_eval.trajectories.manoeuvres.turns import CoordinatedTurn, UTurn
from ins_eval.trajectories.manoeuvres.vocabulary import MANOEUVRES, OVERLAYS
from ins_eval.trajectories.mission import Deflection, Start
from ins_eval.trajectories.mission_file import read_mission
from pyhrg.common.errors import HrgError

DOCUMENT = Path(__file__).parents[3] / "docs" / "missions.md"

RIGHT = """
start = { latitude_deg = 45, longitude_deg = -180.0, speed_m_s = 50 }
departure = [{ kind = "straight", duration_s = 10, path = "great-circle" }]
course = [
  { kind = "coordinated-turn", turn_deg = -90 },
  { kind = "u-turn", side = "left", bank_deg = 20 },
]
overlays = [{ kind = "sway", roll_deg = 3, seed = 5 }]
repeat = true
"""


def write_mission(folder: Path, text: str) -> Path:
    path = folder / "there.toml"
    path.write_text(text)
    return path


def test_file_gives_the_same_as_python(tmp_path: Path) -> None:
    mission = read_mission(write_mission(tmp_path, RIGHT))
    assert mission.name == "there"
    assert mission.start == Start(latitude=np.deg2rad(45), longitude=-np.pi, speed=50.0)
    assert mission.departure == (Straight(duration=10, path="great-circle"),)
    turn, u_turn = mission.course
    assert turn == CoordinatedTurn(turn=-np.pi / 2)
    assert u_turn == UTurn(side="left", bank=np.deg2rad(20))
    assert mission.overlays == (Sway(roll=np.deg2rad(3), seed=5),)
    assert mission.repeat is None


def test_course_is_flown_once_by_default(tmp_path: Path) -> None:
    mission = read_mission(write_mission(tmp_path, RIGHT.replace("repeat = true", "")))
    assert mission.repeat == 1


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("repeat", "repeats", r"repeats: found an unknown key, expected repeat"),
        ("true", "0", r"repeat: found 0, expected true or a number from 1"),
        ("true", "false", r"repeat: found False, expected true or"),
        ("true", "2.5", r"repeat: found 2\.5, expected true or"),
        ("true", 'true\nname = ""', r"name: found '', expected text"),
        ("= 45", "= 89.5", r"start: latitude_deg: found 89\.5, expected -89 to 89 deg"),
        ("= 45", '= "45"', r"start: latitude_deg: found '45', expected -89 to 89 deg"),
        (
            "true",
            "true\ndeflection = { up_arcsec = 1 }",
            r"deflection: up_arcsec: found an unknown",
        ),
        (
            "true",
            "true\ndeflection = { east_arcsec = 200 }",
            r"found 200, expected -100 to 100 arc",
        ),
        ("= 45", "= true", r"start: latitude_deg: found True, expected"),
        ("= 45", "= 1" + 400 * "0", r"start: latitude_deg: found 10+ \.\.\. 0+, expected"),
        ("= 45", "= nan", r"start: latitude_deg: found nan, expected"),
        ("latitude_deg = 45,", "", r"start: latitude_deg: found no such key, expected -89 to"),
        ("start = {", "begin = {", r"begin: found an unknown key"),
        ("turn_deg = -90", "turn = -90", r"course 1 \(coordinated-turn\): turn: found an unknown "),
        (
            "turn_deg = -90",
            "bank_deg = 9",
            r"course 1 .*: turn_deg: found no such key, expected -3",
        ),
        ("bank_deg = 20", "bank_deg = 90", r"course 2 \(u-turn\): bank_deg: found 90, expected 0"),
        ("side =", "# ", r"found what is no TOML"),
        ('side = "left"', 'side = "up"', r"side: found 'up', expected \"right\" or \"left\""),
        ('side = "left",', "", r"course 2 \(u-turn\): side: found no such key"),
        ('kind = "u-turn"', 'kind = "loop"', r"course 2: kind: found 'loop', expected rest or"),
        ('kind = "u-turn",', "", r"course 2: kind: found no such key, expected rest or"),
        ("seed = 5", "seed = -5", r"overlays 1 \(sway\): seed: found -5, expected a whole number"),
        ("seed = 5", "seed = 5.0", r"seed: found 5, expected a whole number"),
        ("overlays = [", "overlays = 3 #", r"overlays: found 3, expected an array of tables"),
        ("departure = [{", "departure = [1, {", r"departure 1: found 1, expected a table"),
    ],
)
def test_mistake_is_named(tmp_path: Path, old: str, new: str, message: str) -> None:
    assert old in RIGHT
    path = write_mission(tmp_path, RIGHT.replace(old, new, 1))
    with pytest.raises(HrgError, match=message) as caught:
        read_mission(path)
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)


def test_course_must_hold_something(tmp_path: Path) -> None:
    path = write_mission(tmp_path, "start = { latitude_deg = 1, longitude_deg = 1 }\n")
    with pytest.raises(HrgError, match=r"course: found \[\], expected at least one manoeuvre"):
        read_mission(path)


def test_missing_and_binary_files(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="can't be read: No such file"):
        read_mission(tmp_path / "nowhere.toml")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(HrgError, match="found what is no text in utf-8"):
        read_mission(tmp_path / "binary.toml")


def list_rows(kind: type) -> list[str]:
    """Rows that the document must hold: key, range, default."""
    rows = []
    for key, field, unit in keys(kind):
        default = field.default
        if default is MISSING:
            shown = "required"
        elif default is None:
            shown = "none"
        else:
            value = unit.to_file(default)
            shown = f"{value:g}" if isinstance(value, float) else str(value)
        rows.append(f"| `{key}` | {unit.expected} | {shown} |")
    return rows


@pytest.mark.parametrize(
    ("word", "kind"),
    [("start", Start), ("deflection", Deflection), *MANOEUVRES.items(), *OVERLAYS.items()],
)
def test_document_lists_every_key_with_its_range(word: str, kind: type) -> None:
    text = DOCUMENT.read_text(encoding="utf-8")
    section = text.split(f"### {word}\n", 1)[1].split("\n### ")[0].split("\n## ")[0]
    rows = [line for line in section.splitlines() if line.startswith("| `")]
    assert rows == list_rows(kind)


def test_document_names_no_other_manoeuvre() -> None:
    lines = DOCUMENT.read_text(encoding="utf-8").splitlines()
    sections = [line.removeprefix("### ") for line in lines if line.startswith("### ")]
    assert sections == ["start", "deflection", *MANOEUVRES, *OVERLAYS]


def test_example_of_the_document_is_a_mission(tmp_path: Path) -> None:
    text = DOCUMENT.read_text(encoding="utf-8").split("```toml\n")[1].split("```")[0]
    assert read_mission(write_mission(tmp_path, text)).course[0] == Straight(
        duration=120.0, path="great-circle"
    )
