"""Versions of all that decides the last bits of a result: this code and its libraries."""

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.documents import read_json

PACKAGES = ("fmu_build", "pyhrg", "ins_eval")
INSTALLED = Path(__file__).parents[2]
"""Folder of the packages."""
SOURCES = frozenset((".py", ".mo", ".c", ".h", ".toml"))
DIGEST = "_sha256"
"""Ending of the key of a thing's digest; the key without it has the thing's name."""
LIBRARIES = ("numpy", "scipy", "numba", "pyarrow")
"""Libraries whose versions may change the last bits of a result."""


@cache
def list_versions() -> dict[str, str]:
    """Version and digest of this code, and versions of its libraries."""
    return {"hrg": version("hrg"), "code": _digest_code()} | {
        name: version(name) for name in LIBRARIES
    }


def digest_value(value: object) -> str:
    """SHA-256 of dataclasses and collections of numbers and texts, the first 32 digits."""
    return hashlib.sha256(repr(_spell_out(value)).encode()).hexdigest()[:32]


def _spell_out(value: Any) -> Any:
    """A value whose `repr` is whole: objects show themselves in one line."""
    if is_dataclass(value):
        parts = [(field.name, _spell_out(getattr(value, field.name))) for field in fields(value)]
        return type(value).__name__, parts
    if isinstance(value, Mapping):
        return [(key, _spell_out(each)) for key, each in value.items()]
    if isinstance(value, list | tuple):
        return [_spell_out(each) for each in value]
    return value


def check_identity(file: Path, identity: Mapping[str, Any]) -> None:
    """Refuse to replace a result (JSON) whose values under the identity's keys differ from it.

    Raises:
        HrgError: a value differs, or the file can't be read.
    """
    if not file.exists():
        return
    document = read_json(file)
    recorded = {key: document.get(key) for key in identity}
    if differs := find_difference(recorded, dict(identity)):
        key, here, asked = differs
        difference = f"{key}: found {here!r}, expected {asked!r}"
        if key.endswith(DIGEST):
            key = key.removesuffix(DIGEST)
            difference = f"{key}: found {recorded.get(key)!r} with other values than now"
        raise HrgError(
            f"{file}: another run: {difference}; choose another folder, or replace what is there "
            "with --force"
        )


def find_difference(found: Any, expected: Any, key: str = "") -> tuple[str, Any, Any] | None:
    """The first key whose values differ, with both values; None if all are equal."""
    if isinstance(found, dict) and isinstance(expected, dict):
        pairs = [(f"{key}.{k}", found.get(k), expected.get(k)) for k in {**expected, **found}]
    elif isinstance(found, list) and isinstance(expected, list) and len(found) == len(expected):
        pairs = [(f"{key}[{i}]", *both) for i, both in enumerate(zip(found, expected, strict=True))]
    else:
        return None if found == expected else (key.removeprefix("."), found, expected)
    differences = (find_difference(f, e, k) for k, f, e in pairs)
    return next((d for d in differences if d is not None), None)


def find_modelica() -> Path:
    """Folder `modelica`: at the top of a checkout; in an installed wheel, data of `fmu_build`."""
    packed = INSTALLED / "fmu_build" / "modelica"
    return packed if packed.is_dir() else INSTALLED / "modelica"


def _digest_code() -> str:
    """Digest of the sources; a wheel and the checkout that it was made of have the same."""
    names: dict[Path, str] = {}
    for root in (find_modelica(), *(INSTALLED / package for package in PACKAGES)):
        for file in root.rglob("*"):
            if file.suffix in SOURCES:
                names.setdefault(file, file.relative_to(root.parent).as_posix())
    digest = hashlib.sha256()
    for file, name in sorted(names.items(), key=lambda item: item[1]):
        digest.update(name.encode())
        digest.update(file.read_bytes())
    return digest.hexdigest()[:32]
