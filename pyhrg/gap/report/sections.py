"""What a diagnosis means to those who use the gyro: sections that packages above bring.

A package names a function of its own as an entry point of the group `hrg.gap_sections`. It is
called with the folder of a diagnosis, in which `diagnosis.json`, `before.toml` and `after.toml` lie
already, and makes a section of the report and a document of it. The diagnosis stands without.
"""

import html
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any

GROUP = "hrg.gap_sections"

Say = Callable[[str], None]


@dataclass(frozen=True)
class Section:
    """A section of a diagnosis.

    title: its heading, plain text.
    html: a fragment below the heading that reads without network or script.
    document: for a file of its own, `<entry point>.json`; JSON's types alone.
    """

    title: str
    html: str
    document: Mapping[str, Any]

    def data(self) -> bytes:
        """The document as its file has it.

        Raises:
            ValueError: a number is not finite.
        """
        return (json.dumps(self.document, indent=1, allow_nan=False) + "\n").encode()


Maker = Callable[[Path, Say], Section]
"""Called with the folder, and what is to be told how far it is."""


def sections(folder: Path, say: Say = lambda text: None) -> dict[str, Section]:
    """Sections of all packages that are there, by the entry points' names, in their order; one
    that fails says so in its place.

    Args:
        folder: with `diagnosis.json`, `before.toml` and `after.toml`.
        say: told how far it is.
    """
    return {entry.name: made(entry.name, entry.load, folder, say) for entry in _entries()}


def names() -> list[str]:
    """Of the sections that there are going to be."""
    return [entry.name for entry in _entries()]


def _entries() -> list[EntryPoint]:
    return sorted(entry_points(group=GROUP), key=lambda entry: entry.name)


def made(name: str, load: Callable[[], Maker], folder: Path, say: Say) -> Section:
    """A section, or one that says why there is none.

    Args:
        name: of the entry point.
        load: gives the function, which may need what isn't there.
        folder, say: as `sections` has them.
    """
    try:
        section = load()(folder, say)
        section.data()
    except Exception as error:
        return _missing(name, error)
    return section


def _missing(name: str, error: Exception) -> Section:
    why = f"could not be made: {type(error).__name__}: {error}"
    title = name.replace("_", " ").capitalize()
    return Section(title, f"<p>This section {html.escape(why)}</p>", {"failed": why})
