"""Recorded drives that are not part of the package, because their licence forbids it.

Their folder is named by the environment variable `HRG_REAL`; without it, it is `shared/real` beside
the folder of the project.
"""

import os
from pathlib import Path

DEFAULT_FOLDER = Path(__file__).parents[3] / "shared" / "real"


def find_recording(name: str) -> Path | None:
    """Return the path of a recorded drive by its file's name; None if the file does not exist."""
    path = Path(os.environ.get("HRG_REAL", DEFAULT_FOLDER)) / name
    return path if path.is_file() else None
