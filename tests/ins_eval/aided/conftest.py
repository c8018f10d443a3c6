"""Shared: one drive, and what it tells."""

import pytest

import ins_eval
from pyhrg.fmu import GyroFmu
from tests.ins_eval.aided import drives
from tests.ins_eval.aided.drives import DrivenFiles


@pytest.fixture(scope="session")
def driven(slow_fmu: GyroFmu, tmp_path_factory: pytest.TempPathFactory) -> DrivenFiles:
    return drives.drive(tmp_path_factory.mktemp("drive"), slow_fmu)


@pytest.fixture(scope="session")
def aided(driven: DrivenFiles) -> ins_eval.AidedDrive:
    return ins_eval.aid(
        driven.log,
        driven.fixes,
        errors_of=drives.IMU,
        lever_arm_m=drives.LEVER_ARM,
        hold_out_h=0.2,
    )
