"""A format that is spoilt: a right input, and what reads it."""

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from tests.fuzzing.mutations import Mutation


@dataclass(frozen=True, eq=False)
class Sample:
    """A format.

    write: writes a right input into an empty folder.
    spoilt: the file of it that is spoilt.
    mutations: how.
    read: reads the input in that folder.
    """

    write: Callable[[Path], object]
    spoilt: str
    mutations: tuple[Mutation, ...]
    read: Callable[[Path], object]

    @cached_property
    def content(self) -> dict[str, bytes]:
        """Right files by name, made once."""
        with tempfile.TemporaryDirectory() as name:
            self.write(Path(name))
            files = (path for path in Path(name).rglob("*") if path.is_file())
            return {str(path.relative_to(name)): path.read_bytes() for path in files}

    def put(self, folder: Path, spoilt: bytes | None) -> None:
        """Put the input into a folder, its spoilt file with these bytes; None: without it."""
        for name, data in self.content.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            if name != self.spoilt:
                (folder / name).write_bytes(data)
            elif spoilt is not None:
                (folder / name).write_bytes(spoilt)
