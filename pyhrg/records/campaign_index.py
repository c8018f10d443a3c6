"""The index of a campaign, key by key: what is there is checked as it is taken out."""

import json
import reprlib
import sys
from pathlib import Path
from typing import Any

from pyhrg.common.errors import HrgError

LARGEST = sys.float_info.max


class CampaignError(HrgError):
    """The folder is no campaign; the message names file, key, and what was expected."""


def index_of(path: Path) -> "Entry":
    """The whole index.

    Raises:
        CampaignError: an unreadable file, or one that is no JSON object.
    """
    return Entry(path, "", _parsed(path))


class Entry:
    """An object of the index, and where it stands."""

    def __init__(self, path: Path, place: str, values: Any) -> None:
        if not isinstance(values, dict):
            raise CampaignError(f"{path}: {place or 'content'}: expected an object")
        self.path, self.place, self.values = path, place, values

    def error(self, key: str, expected: str) -> CampaignError:
        found = reprlib.repr(self.values[key]) if key in self.values else "missing"
        return CampaignError(f"{self.path}: {self.place}{key}: {found}; {expected}")

    def text(self, key: str) -> str:
        value = self.values.get(key)
        if not isinstance(value, str) or not value:
            raise self.error(key, "expected a text")
        return value

    def number(self, key: str, low: float = -LARGEST, high: float = LARGEST) -> float:
        value = self.values.get(key)
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.error(key, "expected a number")
        if not low <= value <= high:
            raise self.error(key, f"expected {low:g} to {high:g}")
        return float(value)

    def entry(self, key: str) -> "Entry":
        if not isinstance(self.values.get(key), dict):
            raise self.error(key, "expected an object")
        return Entry(self.path, f"{self.place}{key}.", self.values[key])

    def entries(self, key: str) -> list["Entry"]:
        values = self.values.get(key)
        if not isinstance(values, list):
            raise self.error(key, "expected a list")
        return [Entry(self.path, f"{key}[{i}].", value) for i, value in enumerate(values)]


def _parsed(path: Path) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise CampaignError(f"{path}: can't be read: {error}") from error
