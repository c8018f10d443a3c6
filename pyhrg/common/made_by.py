"""What computes a result, to the last bit: our own code, and the versions of its libraries."""

import hashlib
from collections.abc import Iterator
from functools import cache
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

PACKAGES = ("fmu_build", "pyhrg", "ins_eval", "modelica")
SOURCES = frozenset((".py", ".mo", ".c", ".h", ".toml"))
LIBRARIES = ("numpy", "scipy", "numba", "pyarrow")
"""Whose versions may show in the last bits."""


@cache
def made_by() -> dict[str, str]:
    """Versions of this code and of its libraries."""
    return {"hrg": version("hrg"), "code": _code()} | {name: version(name) for name in LIBRARIES}


def difference(found: Any, expected: Any, key: str = "") -> tuple[str, Any, Any] | None:
    """The first key whose values differ, with both; None where nothing does."""
    if isinstance(found, dict) and isinstance(expected, dict):
        pairs = [(f"{key}.{k}", found.get(k), expected.get(k)) for k in {**expected, **found}]
    elif isinstance(found, list) and isinstance(expected, list) and len(found) == len(expected):
        pairs = [(f"{key}[{i}]", *both) for i, both in enumerate(zip(found, expected, strict=True))]
    else:
        return None if found == expected else (key.removeprefix("."), found, expected)
    differences = (difference(f, e, k) for k, f, e in pairs)
    return next((d for d in differences if d is not None), None)


def _code() -> str:
    digest = hashlib.sha256()
    for root, file in _sources():
        digest.update(file.relative_to(root).as_posix().encode())
        digest.update(file.read_bytes())
    return digest.hexdigest()[:32]


def _sources() -> Iterator[tuple[Path, Path]]:
    for package in PACKAGES:
        spec = find_spec(package)
        assert spec is not None
        assert spec.submodule_search_locations is not None
        root = Path(next(iter(spec.submodule_search_locations)))
        for file in sorted(root.rglob("*")):
            if file.suffix in SOURCES:
                yield root.parent, file
