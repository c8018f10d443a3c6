"""What determines a study's results, to the last bit: the study itself and all that computes it."""

import hashlib
import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import cache
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ins_eval.study.specification import Study

PACKAGES = ("fmu_build", "pyhrg", "ins_eval", "modelica")
SOURCES = frozenset((".py", ".mo", ".c", ".h", ".toml"))
LIBRARIES = ("numpy", "scipy", "numba", "pyarrow")
"""Whose versions may show in the last bits."""


@dataclass(frozen=True)
class Identity:
    """study: every key of it, plain; made_by: versions, and the digest of our own code."""

    study: dict[str, Any]
    made_by: dict[str, str]

    @property
    def digest(self) -> str:
        """Of both."""
        return hashlib.sha256(self.text.encode()).hexdigest()[:32]

    @property
    def text(self) -> str:
        """As JSON."""
        return json.dumps({"study": self.study, "made_by": self.made_by}, indent=1) + "\n"


def identity(study: Study) -> Identity:
    """Of a study, if this machine's code runs it."""
    return Identity(_plain(study), made_by())


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


def _plain(study: Study) -> dict[str, Any]:
    """As JSON gives it back; of a mission's file, the digest."""
    values = asdict(study)
    for mission in values["missions"]:
        mission["content"] = f"sha256 {hashlib.sha256(mission['content']).hexdigest()}"
    return dict(json.loads(json.dumps(values)))


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
