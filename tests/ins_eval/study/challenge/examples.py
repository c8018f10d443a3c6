"""The outside predictors of docs/challenge."""

from pathlib import Path
from typing import Any

from tests.modules import load_file

FOLDER = Path(__file__).parents[4] / "docs" / "challenge"


def load_strong() -> Any:
    """The strong one as a module."""
    return load_file(FOLDER / "strong.py")
