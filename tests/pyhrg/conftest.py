"""Shared: a campaign that was recorded elsewhere, where it is at hand."""

import os
from pathlib import Path

import pytest

from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.simulation import Simulation

CAMPAIGNS = Path(__file__).parents[3] / "shared" / "campaigns"


@pytest.fixture(scope="session")
def recorded_campaign() -> Path:
    """The folder of the first one; `HRG_CAMPAIGNS` says where they are."""
    folder = Path(os.environ.get("HRG_CAMPAIGNS", CAMPAIGNS)) / "dev-01"
    if not folder.is_dir():
        pytest.skip(f"{folder} is not there; HRG_CAMPAIGNS says where recorded campaigns are")
    return folder


@pytest.fixture(scope="session")
def simulation(fmu: GyroFmu, slow_fmu: GyroFmu) -> Simulation:
    for model in (fmu, slow_fmu):
        model.prepare()
    return Simulation(fmu, slow_fmu)
