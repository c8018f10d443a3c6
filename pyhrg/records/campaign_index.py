"""Indexes in JSON, as of a campaign: every key is checked as it is taken out."""

import json
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.toml_table import TomlTable


class CampaignError(HrgError):
    """The folder is no campaign; the message names file, key, what was found and what expected."""


def read_index(path: Path, error_class: type[HrgError] = CampaignError) -> TomlTable:
    """The whole content of a JSON file, whose objects are tables.

    Raises:
        CampaignError: the file can't be read or is no JSON object (or `error_class`).
    """
    try:
        values = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise error_class(f"{path}: can't be read: {error.strerror or error}") from error
    except ValueError as error:
        raise error_class(f"{path}: found what is no JSON: {error}") from error
    if not isinstance(values, dict):
        raise error_class(f"{path}: found {type(values).__name__}, expected a JSON object")
    return TomlTable(str(path), "", values, error_class)
