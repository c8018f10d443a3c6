"""Missions as TOML: read, and refused with file, manoeuvre, key, what was found and expected."""

import difflib
from collections.abc import Collection, Mapping
from dataclasses import MISSING, dataclass
from pathlib import Path
from typing import Any, TypeVar

from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.keys import Checked, keys
from ins_eval.trajectories.manoeuvres.vocabulary import MANOEUVRES, OVERLAYS
from ins_eval.trajectories.mission import Mission, Start
from pyhrg.common.files import toml_of

TOP = ("name", "start", "departure", "course", "overlays", "repeat")
MOST_REPEATS = 1_000_000

T = TypeVar("T", bound=Checked)


class MissionError(TrajectoryError):
    """The file is no mission; the message names file, manoeuvre, key, found and expected."""


def read(path: Path) -> Mission:
    """Read a mission from TOML.

    Keys: `name` (the file's by default), `[start]`, `departure` and `course` (arrays of tables,
    each with its `kind`), `overlays` (likewise), `repeat` (true, or how often; 1 by default).

    Raises:
        MissionError: an unreadable file; a key that is unknown or missing; a value of the wrong
            type or out of range.
    """
    document = toml_of(path, MissionError)
    reader = _Reader(str(path))
    reader.known(document, TOP, "")
    course = reader.listed(document, "course", MANOEUVRES)
    if not course:
        raise reader.error("course", "no manoeuvre", "at least one")
    return Mission(
        name=reader.name(document.get("name", path.stem)),
        start=reader.built(Start, reader.table(document.get("start", {}), "start"), "start"),
        departure=reader.listed(document, "departure", MANOEUVRES),
        course=course,
        overlays=reader.listed(document, "overlays", OVERLAYS),
        repeat=reader.repeat(document.get("repeat", 1)),
    )


@dataclass(frozen=True)
class _Reader:
    """Takes a document apart; knows where it is from, for messages."""

    source: str

    def error(self, where: str, found: str, expected: str) -> MissionError:
        return MissionError(f"{self.source}: {where}: found {found}, expected {expected}")

    def known(self, table: Mapping[str, Any], names: Collection[str], where: str) -> None:
        for key in table:
            if key not in names:
                close = difflib.get_close_matches(key, names, n=1) or list(names)
                place = f"{where}: {key}" if where else key
                raise self.error(place, "an unknown key", " or ".join(close))

    def table(self, value: object, where: str) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise self.error(where, repr(value), "a table")
        return value

    def name(self, value: object) -> str:
        if not isinstance(value, str) or not value.isprintable() or not value.strip():
            raise self.error("name", repr(value), "text")
        return value

    def repeat(self, value: object) -> int | None:
        if value is True:
            return None
        if type(value) is not int or not 1 <= value <= MOST_REPEATS:
            raise self.error("repeat", repr(value), f"true or a number from 1 to {MOST_REPEATS}")
        return value

    def listed(
        self, document: Mapping[str, Any], key: str, kinds: Mapping[str, type[T]]
    ) -> tuple[T, ...]:
        """Manoeuvres or overlays, of a kind each."""
        values = document.get(key, [])
        if not isinstance(values, list):
            raise self.error(key, repr(values), "an array of tables")
        built = []
        for i, value in enumerate(values, 1):
            table = dict(self.table(value, f"{key} {i}"))
            kind = table.pop("kind", None)
            if not isinstance(kind, str) or kind not in kinds:
                found = "no kind" if kind is None else repr(kind)
                raise self.error(f"{key} {i}: kind", found, " or ".join(kinds))
            built.append(self.built(kinds[kind], table, f"{key} {i} ({kind})"))
        return tuple(built)

    def built(self, kind: type[T], table: Mapping[str, Any], where: str) -> T:
        """A dataclass from its keys, in SI."""
        known = {key: (field, unit) for key, field, unit in keys(kind)}
        self.known(table, known.keys(), where)
        for key, (field, unit) in known.items():
            if key not in table and field.default is MISSING:
                raise self.error(f"{where}: {key}", "no such key", unit.expected)
        values = {known[key][0].name: known[key][1].from_file(table[key]) for key in table}
        try:
            return kind(**values)
        except TrajectoryError as error:
            raise MissionError(f"{self.source}: {where}: {error}") from None
