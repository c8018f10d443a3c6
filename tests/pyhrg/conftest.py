"""Shared: a campaign that was recorded elsewhere, where it is at hand."""

import os
from pathlib import Path

import pytest

CAMPAIGNS = Path(__file__).parents[3] / "shared" / "campaigns"


@pytest.fixture(scope="session")
def recorded_campaign() -> Path:
    """The folder of the first one; `HRG_CAMPAIGNS` says where they are."""
    folder = Path(os.environ.get("HRG_CAMPAIGNS", CAMPAIGNS)) / "dev-01"
    if not folder.is_dir():
        pytest.skip(f"{folder} is not there; HRG_CAMPAIGNS says where recorded campaigns are")
    return folder
