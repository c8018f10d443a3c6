"""The accelerometers' FMU has the errors that `SensorErrorModel` states."""

import fmpy
import numpy as np
import pytest

from fmu_build import build_fmu
from ins_eval.imu.sensor_error_model import AxisConstants, SensorErrorModel

INTERVAL, COUNT = 0.01, 4000
FORCE = np.array([3.0, -1.0, -9.8])


def read(values: dict[str, float]) -> np.ndarray:
    """(n, 3) increments that it reads, m/s, of a force from the second interval on."""
    table = np.zeros(COUNT + 1, dtype=[(n, float) for n in ("time", "row", *INPUTS)])
    table["time"] = INTERVAL * np.arange(COUNT + 1)
    table["row"] = np.arange(COUNT + 1)
    for name, force in zip(INPUTS, FORCE, strict=True):
        table[name] = force
    result = fmpy.simulate_fmu(
        str(build_fmu("Accelerometers")),
        stop_time=INTERVAL * COUNT,
        output_interval=INTERVAL,
        start_values={"samplePeriod": INTERVAL, **values},
        input=table,
        output=["velocity[1]", "velocity[2]", "velocity[3]"],
    )
    sums = np.stack([result[f"velocity[{axis}]"] for axis in (1, 2, 3)], axis=1)
    assert np.all(sums[:2] == 0.0)
    return np.diff(sums[1:], axis=0)


INPUTS = [f"specificForce[{axis}]" for axis in (1, 2, 3)]


def test_errors_are_those_of_the_error_model() -> None:
    bias, factor = (0.1, -0.2, 0.3), (1e-3, 2e-3, -3e-3)
    misalignment = (1e-3, -2e-3, 3e-3, 4e-3, -5e-3, 6e-3)
    model = SensorErrorModel(
        AxisConstants(bias), AxisConstants(factor), AxisConstants(misalignment)
    )
    truth = np.tile(FORCE * INTERVAL, (COUNT - 1, 1))
    expected = model.measure(truth, INTERVAL, np.random.default_rng(1))
    values = {}
    for name, each in (("bias", bias), ("scaleFactor", factor), ("misalignment", misalignment)):
        values |= {f"{name}[{i}]": value for i, value in enumerate(each, 1)}
    assert read(values) == pytest.approx(expected, abs=1e-11)


def test_noise_is_white_and_as_large_as_stated() -> None:
    """Chi-square of 11,997 numbers within 4 sigma; no correlation between neighbours or axes."""
    noise = (read({"randomWalk": 1e-3, "seed": 5}) - FORCE * INTERVAL) / (1e-3 * INTERVAL**0.5)
    count = noise.size
    assert np.sum(noise**2) == pytest.approx(count, abs=4 * np.sqrt(2 * count))
    assert abs(np.sum(noise[1:] * noise[:-1])) < 4 * np.sqrt(count)
    assert abs(np.sum(noise[:, 0] * noise[:, 1])) < 4 * np.sqrt(count / 3)
    assert not np.array_equal(noise, read({"randomWalk": 1e-3, "seed": 6}))
