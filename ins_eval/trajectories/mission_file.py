"""Missions as TOML files. Every key is checked, and messages name file, manoeuvre and key."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from ins_eval.trajectories.keys import Checked, build_from_table
from ins_eval.trajectories.manoeuvres.vocabulary import MANOEUVRES, OVERLAYS
from ins_eval.trajectories.mission import Deflection, Mission, Start
from pyhrg.common.toml_table import TomlTable, read_table

TOP_LEVEL_KEYS = ("name", "start", "deflection", "departure", "course", "overlays", "repeat")
MAX_REPEATS = 1_000_000
"""Largest number of repetitions of a course. Chosen."""

T = TypeVar("T", bound=Checked)


def read_mission(path: Path) -> Mission:
    """Read a mission from a TOML file.

    Keys: `name` (the file's by default), `[start]`, `[deflection]`, `departure` and `course`
    (arrays of tables, each with its `kind`), `overlays` (likewise), `repeat` (true, or how often; 1
    by default).

    Raises:
        HrgError: an unreadable file; a key that is unknown or missing; a value of the wrong
            type or out of range.
    """
    top = read_table(path)
    top.check_known(TOP_LEVEL_KEYS)
    course = _build_all(top, "course", MANOEUVRES)
    if not course:
        raise top.error("course", [], "at least one manoeuvre")
    return Mission(
        name=_read_name(top, path.stem),
        start=_read_one(top, "start", Start),
        deflection=_read_one(top, "deflection", Deflection),
        departure=_build_all(top, "departure", MANOEUVRES),
        course=course,
        overlays=_build_all(top, "overlays", OVERLAYS),
        repeat=_read_repeat(top),
    )


def _read_name(top: TomlTable, default: str) -> str:
    name = top.text("name", default)
    if not name.isprintable() or not name.strip():
        raise top.error("name", name, "text")
    return name


def _read_one(top: TomlTable, key: str, kind: type[T]) -> T:
    return build_from_table(kind, _set_apart(top, key, top.values.get(key, {})))


def _read_repeat(top: TomlTable) -> int | None:
    value = top.values.get("repeat", 1)
    if value is True:
        return None
    if type(value) is not int or not 1 <= value <= MAX_REPEATS:
        raise top.error("repeat", value, f"true or a number from 1 to {MAX_REPEATS}")
    return value


def _build_all(top: TomlTable, key: str, kinds: Mapping[str, type[T]]) -> tuple[T, ...]:
    """Build manoeuvres or overlays, each of its `kind`, from an array of tables."""
    values = top.values.get(key, [])
    if not isinstance(values, list):
        raise top.error(key, values, "an array of tables")
    tables = (_set_apart(top, f"{key} {i}", value) for i, value in enumerate(values, 1))
    return tuple(_build(table, kinds) for table in tables)


def _build(table: TomlTable, kinds: Mapping[str, type[T]]) -> T:
    """Build a manoeuvre or overlay of the `kind` that its table states."""
    kind = table.require("kind", " or ".join(kinds))
    if not isinstance(kind, str) or kind not in kinds:
        raise table.error("kind", kind, " or ".join(kinds))
    values = {key: value for key, value in table.values.items() if key != "kind"}
    place = f"{table.prefix.removesuffix(': ')} ({kind}): "
    return build_from_table(kinds[kind], replace(table, prefix=place, values=values))


def _set_apart(top: TomlTable, place: str, value: object) -> TomlTable:
    """A table of the mission, named in messages by its place, such as `course 2`."""
    if not isinstance(value, dict):
        raise top.error(place, value, "a table")
    return replace(top, prefix=f"{place}: ", values=value)
