"""The compiled driver against FMPy's own calls."""

import numpy as np
import pytest
from fmpy import simulate_fmu

from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from tests.driving import advance


def test_driver_equals_fmpy_to_the_last_bit(fmu: GyroFmu) -> None:
    rates = 0.1 * np.sin(np.arange(200) * 0.05)
    with fmu.power_on(TYPICAL.fmu_parameters(), seed=9, start_angle=0.3) as gyro:
        driven, _ = gyro.record({"angularRate": rates[:, None]}, {}, 0.01, ["gyroAngle"])
    time = np.arange(201) * 0.01
    held = np.array(
        list(zip(time, [*rates, rates[-1]], strict=True)),
        dtype=[("time", float), ("angularRate", float)],
    )
    result = simulate_fmu(
        str(fmu.folder),
        stop_time=2.0,
        output_interval=0.01,
        start_values={**TYPICAL.fmu_parameters(), "seed": 9, "startAngle": 0.3},
        input=held,
        output=["gyroAngle"],
    )
    assert np.array_equal(result["gyroAngle"][1:], driven[:, 0])


def test_same_seed_same_numbers_and_other_seed_others(fmu: GyroFmu) -> None:
    def run(seed: int) -> float:
        with fmu.power_on(TYPICAL.fmu_parameters(), seed=seed, start_angle=0.3) as gyro:
            return advance(gyro, 0.0, 1.0)

    assert run(5) == run(5)
    assert run(5) != run(6)


@pytest.mark.parametrize("step", [1e-3, 1e-2, 1e-1])
def test_commands_of_a_row_hold_from_its_first_tick(fmu: GyroFmu, step: float) -> None:
    """Whatever the steps: with the drive off the amplitude falls for whole rows."""
    rows, off = 6, 2
    drive = np.where(np.arange(rows) < off, 1.0, 0.0)
    still = np.zeros((rows, round(1 / step)))
    with fmu.power_on({"resonator.material.decayTime": 100.0}, seed=0, start_angle=0.3) as gyro:
        ends, means = gyro.record(
            {"angularRate": still}, {"driveOn": drive}, step, ["amplitude"], ["amplitudeForce"]
        )
    falling = np.log(ends[off:, 0] / ends[off - 1, 0]) * 100.0
    np.testing.assert_allclose(falling, -np.arange(1, rows - off + 1), rtol=1e-4)
    assert (means[:off, 0] > 0).all()
    np.testing.assert_array_equal(means[off:, 0], 0.0)


def test_a_force_shows_in_its_own_rows(fmu: GyroFmu) -> None:
    """A pick-off's gain of 1e-4 per m/s2 turns the output while it is there, not a period before:
    by a hundred times what the loops then make of it in three seconds."""
    rows = 6
    force = np.where(np.arange(rows) < 3, 0.0, 10.0)
    still = np.zeros((rows, 100))
    gain = {"pickOff.gainPerAcceleration[1]": 1e-4}
    with fmu.power_on(gain, seed=0, start_angle=0.3) as gyro:
        moving, held = {"angularRate": still}, {"accelerationX": force, "driveOn": still[:, 0] + 1}
        ends, _ = gyro.record(moving, held, 0.01, ["gyroAngle"])
    turned = np.abs(np.diff(ends[:, 0], prepend=ends[0, 0]))
    others = np.delete(turned, 3)
    assert turned[3] > 1e-4
    assert others.max() < 1e-2 * turned[3]


def test_means_of_a_row_with_a_new_command_do_not_depend_on_the_steps(fmu: GyroFmu) -> None:
    """The phase loop makes up for 2 mrad within the row: 2 mrad/s for a second."""
    offset = np.array([0.0, 0.0, 2e-3, 2e-3])
    means = []
    for step in (1e-3, 1e-2, 1e-1):
        still = np.zeros((len(offset), round(1 / step)))
        with fmu.power_on({}, seed=0, start_angle=0.3) as gyro:
            moving, held = (
                {"angularRate": still},
                {"phaseOffset": offset, "driveOn": still[:, 0] + 1},
            )
            _, mean = gyro.record(moving, held, step, means=["frequencyOffset"])
        means.append(mean[:, 0])
    np.testing.assert_allclose(means[1:], [means[0]] * 2, atol=1e-9)
    assert abs(means[0][2] - means[0][1]) == pytest.approx(2e-3, rel=5e-3)
