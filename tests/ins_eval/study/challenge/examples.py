"""The outside predictors of docs/challenge."""

import importlib.util
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parents[4] / "docs" / "challenge"


def load_strong() -> Any:
    """The strong one as a module."""
    spec = importlib.util.spec_from_file_location("strong", FOLDER / "strong.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
