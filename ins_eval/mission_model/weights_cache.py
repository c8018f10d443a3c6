"""Weights of missions kept on disk, by what they come from: the code and the mission's file."""

import hashlib
import os
import tempfile
from dataclasses import asdict, fields
from functools import cache
from pathlib import Path

import numpy as np
import platformdirs

import ins_eval
from ins_eval.mission_model.mission_weights import MissionWeights, mission_weights
from ins_eval.mission_model.missions import StudyMission, file_of
from ins_eval.mission_model.standing import Standing

PACKAGES = ("alignment", "common", "error_model", "mission_model", "trajectories")
"""The code that makes weights."""


def kept_weights(mission: StudyMission, folder: Path | None = None) -> MissionWeights:
    """Weights of a mission, from the folder, or made and put there.

    Args:
        mission: what is flown.
        folder: of the files; the user's cache if None.
    """
    folder = folder or platformdirs.user_cache_path("hrg") / "weights"
    path = folder / f"{mission.name}-{digest(mission)[:16]}.npz"
    if not path.exists():
        _write(mission_weights(mission), path)
    return _read(path)


def digest(mission: StudyMission) -> str:
    """Of a mission and the code that makes weights of it."""
    told = f"{mission.name} {mission.hours!r} {mission.kept!r} {_code()} ".encode()
    return hashlib.sha256(told + file_of(mission.source).read_bytes()).hexdigest()


@cache
def _code() -> str:
    root = Path(ins_eval.__file__).parent
    files = [file for name in PACKAGES for file in (root / name).rglob("*.py")]
    return hashlib.sha256(b"".join(path.read_bytes() for path in sorted(files))).hexdigest()


def _write(weights: MissionWeights, path: Path) -> None:
    """Aside, then renamed: never half there, whoever else writes it."""
    arrays = {f.name: getattr(weights, f.name) for f in fields(weights) if f.name != "standing"}
    standing = {f"standing_{name}": value for name, value in asdict(weights.standing).items()}
    path.parent.mkdir(parents=True, exist_ok=True)
    number, aside = tempfile.mkstemp(prefix=".partial-", dir=path.parent)
    try:
        with os.fdopen(number, "wb") as file:
            np.savez(file, **arrays, **standing)
        Path(aside).replace(path)
    except BaseException:
        Path(aside).unlink(missing_ok=True)
        raise


def _read(path: Path) -> MissionWeights:
    with np.load(path) as stored:
        standing = {f.name: stored[f"standing_{f.name}"] for f in fields(Standing)}
        arrays = {f.name: stored[f.name] for f in fields(MissionWeights) if f.name in stored.files}
    for name in ("latitude", "height"):
        standing[name] = float(standing[name])
    return MissionWeights(**{**arrays, "name": str(arrays["name"])}, standing=Standing(**standing))
