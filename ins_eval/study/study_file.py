"""Studies as TOML: read, and refused with file, key, what was found and what was expected."""

from collections.abc import Iterator
from dataclasses import MISSING, replace
from pathlib import Path
from typing import Any, TypeVar

from ins_eval.study.sections import SECTIONS, settings
from ins_eval.study.specification import (
    CALIBRATIONS,
    MEAN,
    TEST,
    TRAIN,
    PlannedMission,
    Study,
    fewest_triads,
)
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.keys import Checked, keys
from ins_eval.trajectories.recordings import recording
from pyhrg.common.files import toml_of
from pyhrg.common.toml_table import SpecificationError, TomlTable

_FOLDER = Path(__file__).with_name("ready")
READY = tuple(sorted(path.stem for path in _FOLDER.glob("*.toml")))
"""Names of the studies that come with the package; each is a file in `ready`."""

MISSION_KEYS = ("name", "file", "recorded", "class", "half", "hours")

T = TypeVar("T", bound=Checked)


def study(name_or_path: str, seed: int | None = None) -> Study:
    """One that comes with the package, or the one in a file.

    Raises:
        SpecificationError: see `read`; neither a name nor a file.
    """
    if name_or_path in READY:
        return read(_FOLDER / f"{name_or_path}.toml", seed)
    if not Path(name_or_path).is_file():
        raise SpecificationError(
            f"{name_or_path}: found no such file, expected one or {', '.join(READY)}"
        )
    return read(Path(name_or_path), seed)


def read(path: Path, seed: int | None = None) -> Study:
    """Read a study.

    Args:
        path: TOML. At the top the keys of `Study`; `[[missions]]`, each with `name` (of a ready
            mission), `file` (from the folder of this one) or `recorded` (of `recordings`, left out
            where it is not there), `class`, `half` and, if it has its
            own, `hours`; tables as `sections.SECTIONS` says.
        seed: instead of the file's.

    Raises:
        SpecificationError: an unreadable file; a key that is unknown or missing; a value out of
            range; a class in both halves, a half without missions; too few triads for the interval.
    """
    document = toml_of(path, SpecificationError)
    if seed is not None:
        document["seed"] = seed
    top = TomlTable(str(path), "", document)
    top.check_known([*(key for key, _, _ in keys(Study)), "calibrations", "missions", *SECTIONS])
    plain = {key: document[key] for key, _, _ in keys(Study) if key in document}
    calibrations = _calibrations(top)
    bare = _built(Study, TomlTable(str(path), "", plain), missions=(), calibrations=calibrations)
    missions = tuple(_missions(top, path.parent, bare.hours))
    left_out = tuple(values["recorded"] for values in top.values["missions"] if _absent(values))
    _check_halves(top, missions)
    check_triads(bare, top.source)
    return replace(bare, missions=missions, left_out=left_out, settings=settings(top))


def check_triads(study: Study, source: str) -> None:
    """Refuse what can't be judged.

    Args:
        study: without regard to its missions.
        source: put before what is wrong.

    Raises:
        SpecificationError: too few triads for the interval; conditions of too few, of more than
            the judged half has, or without gyros that are calibrated at the mean.
    """
    top = TomlTable(source, "", {})
    few = fewest_triads(study.interval_percent)
    refutes = f"with fewer, nothing refutes intervals of {study.interval_percent:g} % that are"
    if study.triads < few:
        raise top.error("triads", study.triads, f"{few} or more: {refutes} too wide")
    judged, fewest = study.triads - study.triads // 2, few // 2
    if study.conditions and not fewest <= study.conditions <= judged:
        raise top.error(
            "conditions",
            study.conditions,
            f"0, or {fewest} to {judged}, the half that is judged: {refutes} too wide",
        )
    if study.conditions and MEAN not in study.calibrations:
        raise top.error(
            "conditions", study.conditions, f"0 without {MEAN!r} among the calibrations"
        )


def _built(kind: type[T], table: TomlTable, **others: Any) -> T:
    """A dataclass from its keys, in SI."""
    known = {key: (field, unit) for key, field, unit in keys(kind)}
    table.check_known(known)
    for key, (field, unit) in known.items():
        if key not in table.values and field.name not in others and field.default is MISSING:
            raise table.missing(key, unit.expected)
    values = {
        known[key][0].name: known[key][1].from_file(table.values[key]) for key in table.values
    }
    try:
        return kind(**values, **others)
    except TrajectoryError as error:
        raise SpecificationError(f"{table.source}: {table.prefix}{error}") from None


def _calibrations(top: TomlTable) -> tuple[str, ...]:
    found = top.values.get("calibrations", list(CALIBRATIONS))
    if (
        not isinstance(found, list)
        or not found
        or any(name not in CALIBRATIONS for name in found)
        or len(set(found)) < len(found)
    ):
        raise top.error("calibrations", found, f"some of {', '.join(CALIBRATIONS)}, each once")
    return tuple(found)


def _missions(top: TomlTable, folder: Path, hours: float) -> Iterator[PlannedMission]:
    listed = top.values.get("missions", [])
    if not isinstance(listed, list) or not all(isinstance(each, dict) for each in listed):
        raise top.error("missions", listed, "tables [[missions]]")
    if not listed:
        raise top.missing("missions", "tables [[missions]]")
    named: set[str] = set()
    for number, values in enumerate(listed, 1):
        table = TomlTable(top.source, f"missions {number}: ", values)
        if _absent(values):
            continue
        mission = _mission(table, folder, hours)
        if mission.name in named:
            raise table.error("name", mission.name, "a name that no other mission has")
        named.add(mission.name)
        yield mission


def _mission(table: TomlTable, folder: Path, hours: float) -> PlannedMission:
    """Of a table of `MISSION_KEYS`."""
    table.check_known(MISSION_KEYS)
    if "class" not in table.values:
        raise table.missing("class", "the class of manoeuvre, text")
    path = _file(table, folder)
    chosen = {key: table.values[key] for key in ("half", "hours") if key in table.values}
    try:
        content = path.read_bytes()
    except OSError as error:
        raise table.error("file", str(path), f"a file: {error.strerror or error}") from error
    return _built(
        PlannedMission,
        TomlTable(table.source, table.prefix, {"hours": hours} | chosen),
        name=table.text("name", path.name.split(".")[0]),
        mission_class=table.text("class", ""),
        file_name=path.name,
        content=content,
    )


def _absent(values: dict[str, Any]) -> bool:
    """Whether it names a recorded drive that is not there."""
    name = values.get("recorded")
    return isinstance(name, str) and recording(name) is None


def _file(table: TomlTable, folder: Path) -> Path:
    if "recorded" in table.values:
        return recording(table.text("recorded", "")) or Path(table.text("recorded", ""))
    if "file" in table.values:
        return folder / table.text("file", "")
    if "name" not in table.values:
        raise table.missing("name", f"{' or '.join(catalogue.names())}, or a file")
    return catalogue.READY / f"{table.text('name', '', catalogue.names())}.toml"


def _check_halves(top: TomlTable, missions: tuple[PlannedMission, ...]) -> None:
    """Each class on one side, both sides there."""
    halves: dict[str, str] = {}
    for number, mission in enumerate(missions, 1):
        half = halves.setdefault(mission.mission_class, mission.half)
        if half != mission.half:
            raise TomlTable(top.source, f"missions {number}: ", {}).error(
                "half",
                mission.half,
                f"{half!r} as of every mission of class {mission.mission_class!r}",
            )
    for half in (TRAIN, TEST):
        if half not in halves.values():
            raise top.missing(f"missions of half {half!r}", "at least one")
