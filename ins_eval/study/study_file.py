"""Studies as TOML files; an error names file, key, what was found and what was expected.

Each table of the file sets fields of a dataclass (`experiment.DEFAULT_SETTINGS`). A field that the
file does not set keeps its default.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from ins_eval.study.specification import (
    CALIBRATIONS,
    MEAN,
    PlannedMission,
    Settings,
    Study,
    compute_fewest_judged,
)
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.keys import build_from_table, keys
from ins_eval.trajectories.recorded_drive import find_recording
from pyhrg.common.errors import HrgError
from pyhrg.common.files import is_file, make_missing_error
from pyhrg.common.reading.files import read_bytes
from pyhrg.common.reading.limits import LOG_BYTES
from pyhrg.common.toml_table import Key, TomlTable, read_fields, read_table
from pyhrg.common.units import DEG_PER_H, HOUR

_POPULATION = (
    Key("smallest_deg_h", "smallest", DEG_PER_H, 1e-4, 100),
    Key("largest_deg_h", "largest", DEG_PER_H, 1e-4, 100),
    Key("common_share", "common", 1, 0, 1),
    Key("rarer_mechanisms", "rarer", 1, 0, 10),
)
_PLAN = (
    Key("runs", "runs", 1, 1, 100, whole=True),
    Key("fixed_runs", "fixed_runs", 1, 2, 100, whole=True),
    Key("positions", "positions", 1, 16, 720, whole=True),  # nine terms of a map
    Key("segments", "segments", 1, 1, 36, whole=True),
    Key("fixed_segments", "fixed_segments", 1, 2, 360, whole=True),
    Key("periods", "periods", 1, 1, 100, whole=True),
)
SETTING_TABLES: Mapping[str, tuple[Key, ...]] = {
    "trimmed": _POPULATION,
    "raw": _POPULATION,
    "calibration": _PLAN,
    "bench": _PLAN,
    "drift": (
        Key("age_days", "age", 24 * HOUR, 0, 7300),
        Key("coolest_K", "coolest", 1, -80, 80),
        Key("warmest_K", "warmest", 1, -80, 80),
    ),
}
"""Keys by table: gyros that are calibrated at the mean, gyros whose map is calibrated, the maker's
tests, the bench's tests, and what changes between calibration and flight."""
ORDERED_PAIRS = (
    ("trimmed", "smallest", "largest"),
    ("raw", "smallest", "largest"),
    ("drift", "coolest", "warmest"),
)
"""Table, lower and upper end of each range; a file states both ends or neither."""


def read_settings(top: TomlTable) -> dict[str, Settings]:
    """Settings of the tables that a study file has.

    Raises:
        HrgError: an unknown key, a value out of range, a range of which one end is
            missing or whose lower end is above the upper one.
    """
    read: dict[str, Settings] = {
        name: read_fields(top.table(name), SETTING_TABLES[name])
        for name in SETTING_TABLES
        if name in top.values
    }
    for name, low, high in ORDERED_PAIRS:
        if name in read:
            _check_ends(top.table(name), read[name], low, high)
    return read


def _check_ends(table: TomlTable, values: Settings, low: str, high: str) -> None:
    keys = {key.field: key.name for key in SETTING_TABLES[table.prefix.removesuffix(".")]}
    for present, missing in ((low, high), (high, low)):
        if present in values and missing not in values:
            raise table.missing(keys[missing], f"a number beside {keys[present]}")
    if low in values and values[low] > values[high]:
        raise table.error(keys[high], table.values[keys[high]], f"{keys[low]} or more")


_FOLDER = Path(__file__).with_name("ready")
READY = tuple(sorted(path.stem for path in _FOLDER.glob("*.toml")))
"""Names of the studies that come with the package; each is a file in the folder `ready`."""

MISSION_KEYS = ("name", "file", "recorded", "class", "hours")


def load_study(name_or_path: str | Path, seed: int | None = None) -> Study:
    """Load a study that comes with the package, or one from a file.

    Args:
        name_or_path: one of `READY`, or a file (TOML).

    Raises:
        HrgError: neither a name nor a file; or as `read_study`.
    """
    if str(name_or_path) in READY:
        return read_study(_FOLDER / f"{name_or_path}.toml", seed)
    if not is_file(name_or_path):
        raise make_missing_error(name_or_path, "study", READY)
    return read_study(Path(name_or_path), seed)


def read_study(path: Path, seed: int | None = None) -> Study:
    """The study of a file.

    Args:
        path: TOML. The top has the keys of `Study`. Each of `[[missions]]` has `name` (of a ready
            mission), `file` (relative to this one's folder) or `recorded` (a recorded drive, which
            is left out where it does not exist); further `class` and, if it differs
            from the study's, `hours`. Tables are those of `SETTING_TABLES`.

    Raises:
        HrgError: an unreadable file; a key that is unknown or missing; a value out of
            range; too few triads for the interval.
    """
    document = dict(read_table(path).values)
    if seed is not None:
        document["seed"] = seed
    top = TomlTable(str(path), "", document)
    top.check_known(
        [*(key for key, _, _ in keys(Study)), "calibrations", "missions", *SETTING_TABLES]
    )
    plain = {key: document[key] for key, _, _ in keys(Study) if key in document}
    calibrations = _read_calibrations(top)
    bare = build_from_table(
        Study, TomlTable(str(path), "", plain), missions=(), calibrations=calibrations
    )
    missions = tuple(_read_missions(top, path.parent, bare.hours))
    left_out = tuple(
        values["recorded"] for values in top.values["missions"] if _is_missing_recording(values)
    )
    check_triads(bare, top.source)
    return replace(bare, missions=missions, left_out=left_out, settings=read_settings(top))


def check_triads(study: Study, source: str) -> None:
    """Refuse a study whose coverage cannot be judged.

    Args:
        study: the study; its missions are not looked at.
        source: name of the file in messages.

    Raises:
        HrgError: too few triads for the interval; conditions or a sample for agreement
            with more triads than are judged, or with one; conditions without gyros that are
            calibrated at the mean.
    """
    top = TomlTable(source, "", {})
    fewest = study.training + compute_fewest_judged(study.interval_percent)
    if study.triads < fewest:
        raise top.error(
            "triads",
            study.triads,
            f"{fewest} or more with training {study.training}: with fewer that are judged, nothing "
            f"refutes intervals of {study.interval_percent:g} % that are too wide",
        )
    for key in ("conditions", "agreement", "steady_agreement", "witnessed"):
        count = getattr(study, key)
        if count > study.judged or count == 1:
            raise top.error(key, count, f"0, or 2 to {study.judged}, the triads that are judged")
    if study.lead > study.triads:
        raise top.error("lead", study.lead, f"0 to {study.triads}, the number of triads")
    if study.conditions and MEAN not in study.calibrations:
        raise top.error(
            "conditions", study.conditions, f"0 without {MEAN!r} among the calibrations"
        )


def _read_calibrations(top: TomlTable) -> tuple[str, ...]:
    calibrations = top.values.get("calibrations", list(CALIBRATIONS))
    if (
        not isinstance(calibrations, list)
        or not calibrations
        or any(name not in CALIBRATIONS for name in calibrations)
        or len(set(calibrations)) < len(calibrations)
    ):
        raise top.error(
            "calibrations", calibrations, f"some of {', '.join(CALIBRATIONS)}, each once"
        )
    return tuple(calibrations)


def _read_missions(top: TomlTable, folder: Path, hours: float) -> Iterator[PlannedMission]:
    listed = top.values.get("missions", [])
    if not isinstance(listed, list) or not all(isinstance(each, dict) for each in listed):
        raise top.error("missions", listed, "tables [[missions]]")
    if not listed:
        raise top.missing("missions", "tables [[missions]]")
    named: set[str] = set()
    for number, values in enumerate(listed, 1):
        table = TomlTable(top.source, f"missions {number}: ", values)
        if _is_missing_recording(values):
            continue
        mission = _read_mission(table, folder, hours)
        if mission.name in named:
            raise table.error("name", mission.name, "a name that no other mission has")
        named.add(mission.name)
        yield mission


def _read_mission(table: TomlTable, folder: Path, hours: float) -> PlannedMission:
    if "half" in table.values:
        raise table.error("half", table.values["half"], "no such key: all classes are judged")
    table.check_known(MISSION_KEYS)
    if "class" not in table.values:
        raise table.missing("class", "the class of manoeuvre, text")
    path = _find_file(table, folder)
    try:
        content = read_bytes(path, LOG_BYTES)
    except HrgError as error:
        raise table.error("file", str(path), f"a file: {error}") from error
    chosen = {key: table.values[key] for key in ("hours",) if key in table.values}
    return build_from_table(
        PlannedMission,
        TomlTable(table.source, table.prefix, {"hours": hours} | chosen),
        name=table.text("name", path.name.split(".")[0]),
        mission_class=table.text("class", ""),
        file_name=path.name,
        content=content,
    )


def _is_missing_recording(values: dict[str, Any]) -> bool:
    """Whether a mission's table names a recorded drive that is not on this machine."""
    name = values.get("recorded")
    return isinstance(name, str) and find_recording(name) is None


def _find_file(table: TomlTable, folder: Path) -> Path:
    if "recorded" in table.values:
        return find_recording(table.text("recorded", "")) or Path(table.text("recorded", ""))
    if "file" in table.values:
        return folder / table.text("file", "")
    if "name" not in table.values:
        raise table.missing("name", f"{' or '.join(catalogue.list_trajectories())}, or a file")
    return catalogue.READY_FOLDER / f"{table.text('name', '', catalogue.list_trajectories())}.toml"
