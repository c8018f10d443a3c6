"""Recorded data, which are not part of the project."""

from pathlib import Path

import pytest

from ins_eval.trajectories import recorded_drive


def find_recording(name: str) -> Path:
    """A recorded file; a test that needs one that is not there is skipped."""
    path = recorded_drive.find_recording(name)
    if path is None:
        pytest.skip(f"{name} is not there; HRG_REAL says where recorded data are")
    return path
