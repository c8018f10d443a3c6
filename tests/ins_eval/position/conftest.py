"""Folders of diagnoses: a believed gyro, and one in which something was found."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from pyhrg.common.units import DEG, DEG_PER_SQRT_H
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.gap.findings import diagnosis
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis, Gap, GapFigure

BELIEVED = Device(
    damping_anisotropy=2e-8, damping_axis=20 * DEG, angle_random_walk=3e-4 * DEG_PER_SQRT_H
)
ANGLE = GapFigure(40.0, 0.5, 0.5, (0.2, 1.5))
RATE = GapFigure(0.05, 3e-3, 1.8e-3, (1e-3, 2.5e-3))
FOUND = Diagnosis(
    device="made-up",
    verdict="explained",
    causes=(),
    unknown_probability=0.01,
    where=(),
    sizes=(),
    gap=Gap(ANGLE, RATE, ANGLE, RATE, 99.0, 0.5),
    next_test=None,
    unnamed={},
    excluded=(),
)
Written = Callable[..., Path]


@pytest.fixture
def written(tmp_path: Path) -> Written:
    """Writes a diagnosis whose gyro after it has these fields."""

    def write(found: Diagnosis = FOUND, /, **fields: float) -> Path:
        device_file.write(BELIEVED, tmp_path / "before.toml")
        device_file.write(replace(BELIEVED, **fields), tmp_path / "after.toml")  # type: ignore[arg-type]
        diagnosis.write(found, tmp_path)
        return tmp_path

    return write


@pytest.fixture
def confounded() -> Diagnosis:
    cause = Cause("drive_gain_mismatch", 1.0, {}, {}, ("damping_anisotropy",))
    return replace(FOUND, verdict="ambiguous", causes=(cause,))
