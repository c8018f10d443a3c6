"""Where recorded drives lie, which the package has no right to bring along.

In the folder that the environment's `HRG_REAL` names, else in `shared/real` beside the project's.
"""

import os
from pathlib import Path

BESIDE = Path(__file__).parents[3] / "shared" / "real"


def recording(name: str) -> Path | None:
    """A recorded drive by its file's name; None where it is not there."""
    path = Path(os.environ.get("HRG_REAL", BESIDE)) / name
    return path if path.is_file() else None
