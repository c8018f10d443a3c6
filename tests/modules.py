"""Python files that stand outside the packages: hooks of the site, examples of the docs."""

import importlib.util
from pathlib import Path
from typing import Any


def load_file(file: Path) -> Any:
    """A Python file as a module."""
    spec = importlib.util.spec_from_file_location(file.stem, file)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
