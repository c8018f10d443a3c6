"""Sections that a caller adds to the report, each with a JSON document of its own."""

import html
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Section:
    """A section of the report.

    name: stem of the document's file, and the section's anchor on the page.
    title: heading, plain text.
    html: fragment below the heading that reads without network or script.
    document: content of `<name>.json`; JSON types only.
    """

    name: str
    title: str
    html: str
    document: Mapping[str, Any]

    @property
    def file(self) -> str:
        """Name of the document's file."""
        return f"{self.name}.json"

    def to_json(self) -> bytes:
        """Bytes of the document's file; a ValueError where a number is not finite."""
        return (json.dumps(self.document, indent=1, allow_nan=False) + "\n").encode()


def make_section(name: str, make: Callable[[], Section]) -> Section:
    """The section of this name that `make` returns. Where it raises anything but an interruption, a
    section that states the failure, so that the diagnosis is kept."""
    try:
        section = make()
        section.to_json()
    except Exception as error:
        reason = f"could not be made: {type(error).__name__}: {error}"
        title = name.replace("_", " ").capitalize()
        markup = f"<p>This section {html.escape(reason)}</p>"
        return Section(name, title, markup, {"failed": reason})
    return section
