"""A cache of mission weights on disk; its key is a digest of the code and the mission's file."""

import hashlib
import io
from dataclasses import asdict, fields
from functools import cache
from pathlib import Path

import numpy as np

import ins_eval
from ins_eval.mission_model.alignment_at_rest import AlignmentAtRest
from ins_eval.mission_model.mission_weights import MissionWeights, compute_mission_weights
from ins_eval.mission_model.missions import StudyMission
from ins_eval.trajectories.catalogue import find_mission_file
from pyhrg.common.caches.files import find_cache_folder, read_cached, write_cached
from pyhrg.common.reading.files import read_bytes
from pyhrg.common.reading.limits import LOG_BYTES

DIGESTED_PACKAGES = ("alignment", "common", "error_model", "mission_model", "trajectories")
"""Packages of `ins_eval` whose code decides the weights."""


def load_mission_weights(mission: StudyMission, folder: Path | None = None) -> MissionWeights:
    """Weights of a mission, from the cache (the user's own by default), or computed and put
    there."""
    folder = folder or find_cache_folder() / "weights"
    path = folder / f"{mission.name}-{compute_weights_digest(mission)[:16]}.npz"
    if (kept := read_cached(path)) is not None:
        return _unpack(kept)
    weights = compute_mission_weights(mission)
    write_cached(path, _pack(weights))
    return weights


def compute_weights_digest(mission: StudyMission) -> str:
    """SHA-256 of a mission and of the code that computes its weights."""
    text = f"{mission.name} {mission.hours!r} {mission.interval!r} {_digest_code()} "
    content = read_bytes(find_mission_file(mission.source), LOG_BYTES)
    return hashlib.sha256(text.encode() + content).hexdigest()


@cache
def _digest_code() -> str:
    root = Path(ins_eval.__file__).parent
    files = [file for name in DIGESTED_PACKAGES for file in (root / name).rglob("*.py")]
    return hashlib.sha256(b"".join(path.read_bytes() for path in sorted(files))).hexdigest()


def _pack(weights: MissionWeights) -> bytes:
    arrays = {f.name: getattr(weights, f.name) for f in fields(weights) if f.name != "alignment"}
    alignment = {f"alignment_{name}": value for name, value in asdict(weights.alignment).items()}
    buffer = io.BytesIO()
    np.savez(buffer, **arrays, **alignment)
    return buffer.getvalue()


def _unpack(data: bytes) -> MissionWeights:
    with np.load(io.BytesIO(data)) as stored:
        alignment = {f.name: stored[f"alignment_{f.name}"] for f in fields(AlignmentAtRest)}
        arrays = {f.name: stored[f.name] for f in fields(MissionWeights) if f.name in stored.files}
    for name in ("latitude", "height"):
        alignment[name] = float(alignment[name])
    return MissionWeights(
        **{**arrays, "name": str(arrays["name"])}, alignment=AlignmentAtRest(**alignment)
    )
