"""Every parameter and input at both ends of its range: nothing diverges."""

import numpy as np
import pytest

from fmu_build.bundle import build_fmu
from fmu_build.roots import ROOTS
from pyhrg.fmu import GyroFmu
from tests.driving import advance

LENGTH = {"HRG": 2.0, "HRGCarrier": 0.2, "HRGSlow": 20.0}


def ends(fmu: GyroFmu, causality: str) -> list[tuple[str, float]]:
    """Name and value of all ends that are given."""
    return [
        (v.name, float(end))
        for v in fmu.description.modelVariables
        if v.causality == causality
        for end in (v.min, v.max)
        if end is not None
    ]


@pytest.mark.parametrize("model", ROOTS)
def test_parameters_at_their_limits(model: str) -> None:
    fmu = GyroFmu(build_fmu(model))
    for name, value in ends(fmu, "parameter"):
        if name in ("seed", "startAngle"):
            continue  # set at power-on
        with fmu.power_on({name: value}, seed=1, start_angle=0.3) as gyro:
            assert np.isfinite(advance(gyro, 0.1, LENGTH[model])), (name, value)
            assert abs(gyro.read("amplitude")) < 100, (name, value)


@pytest.mark.parametrize("model", ROOTS)
def test_inputs_at_their_limits(model: str) -> None:
    fmu = GyroFmu(build_fmu(model))
    for name, value in ends(fmu, "input"):
        start = {name: value} if name == "caseAngle" else {}  # a turn there would be too fast
        with fmu.power_on(start, seed=1, start_angle=0.3) as gyro:
            gyro.command(name, value)
            rate = value if name == "angularRate" else 0.1
            assert np.isfinite(advance(gyro, rate, LENGTH[model])), (name, value)


@pytest.mark.parametrize("model", ROOTS)
def test_every_parameter_and_input_has_a_range(model: str) -> None:
    fmu = GyroFmu(build_fmu(model))
    for v in fmu.description.modelVariables:
        if v.causality in ("parameter", "input"):
            assert v.min is not None, v.name
            assert v.max is not None, v.name
