"""A gyro that runs for long takes no more memory than one that runs for minutes."""

import resource
from pathlib import Path

import numpy as np
import pytest

from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu

HOUR = 3600
PART = 600
"""Seconds that are recorded at a time."""
ROOM = 2**20
"""Growth that the allocator may have, bytes."""
STATUS = Path("/proc/self/statm")


def measure_memory() -> int:
    """Resident memory of this process, bytes."""
    return int(STATUS.read_text().split()[1]) * resource.getpagesize()


@pytest.mark.skipif(not STATUS.exists(), reason="the system does not say how much memory is used")
@pytest.mark.parametrize(("model", "hours"), [("slow_fmu", 24), ("fmu", 1)])
def test_memory_is_constant(model: str, hours: int, request: pytest.FixtureRequest) -> None:
    gyro_fmu: GyroFmu = request.getfixturevalue(model)
    step = 0.1 if model == "slow_fmu" else 0.01
    steps = round(1 / step)
    parameters = dict(TYPICAL.fmu_parameters())
    if model == "slow_fmu":
        parameters = {k: v for k, v in parameters.items() if k not in LOOP_FREQUENCIES}
        parameters["samplePeriod"] = step
    moving = {"angularRate": np.full((PART, steps), 1e-3)}
    held = {"driveOn": np.ones(PART)}
    with gyro_fmu.power_on(parameters, seed=1, start_angle=0.1) as gyro:
        gyro.record(moving, held, step, ["gyroAngle"], ["amplitudeForce"])
        before = measure_memory()
        for _ in range(hours * HOUR // PART - 1):
            gyro.record(moving, held, step, ["gyroAngle"], ["amplitudeForce"])
        assert measure_memory() - before < ROOM
        assert gyro.time == pytest.approx(hours * HOUR)
