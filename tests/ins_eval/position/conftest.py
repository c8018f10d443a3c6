"""Folders of diagnoses: a nominal device and an identified one."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from pyhrg.common.units import DEG, DEG_PER_SQRT_H
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.gap.findings import diagnosis
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis, Gap, GapFigure

NOMINAL = Device(
    damping_anisotropy=2e-8, damping_axis=20 * DEG, angle_random_walk=3e-4 * DEG_PER_SQRT_H
)
ANGLE = GapFigure(40.0, 0.5, 0.5, (0.2, 1.5))
RATE = GapFigure(0.05, 3e-3, 1.8e-3, (1e-3, 2.5e-3))
DIAGNOSIS = Diagnosis(
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
WriteDiagnosis = Callable[..., Path]


@pytest.fixture
def write_diagnosis(tmp_path: Path) -> WriteDiagnosis:
    """Writes a diagnosis whose identified device has these fields."""

    def write(content: Diagnosis = DIAGNOSIS, /, **fields: float) -> Path:
        device_file.write(NOMINAL, tmp_path / "before.toml")
        device_file.write(replace(NOMINAL, **fields), tmp_path / "after.toml")  # type: ignore[arg-type]
        diagnosis.write(content, tmp_path)
        return tmp_path

    return write


@pytest.fixture
def confounded() -> Diagnosis:
    cause = Cause("drive_gain_mismatch", 1.0, {}, {}, ("damping_anisotropy",))
    return replace(DIAGNOSIS, verdict="ambiguous", causes=(cause,))
