"""`simulate` against the FMU driven directly, to the last bit; what it refuses."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import xarray as xr

from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.playback import HELD_INPUTS, MOVING_INPUTS, OUTPUTS_AT_END, OUTPUTS_AVERAGED, simulate

ROWS, STEPS, STEP = 5, 100, 0.01

AT_END = {name: own for name, own in OUTPUTS_AT_END.items() if name != "map_followed"}
"""Outputs that every gyro has."""


def test_simulation_is_the_fmu_to_the_last_bit(fmu: GyroFmu) -> None:
    gyro = replace(TYPICAL, power_on_angle=0.3)
    rates = np.array([0.0, 1.0, -2.0, 0.5, 0.0])
    drive = np.array([1.0, 1.0, 0.0, 1.0, 1.0])
    found = simulate(gyro, duration_s=ROWS, table_rate_deg_per_s=rates, drive_on=drive)
    earth = gyro.site.compute_earth_rate(1.0)
    moving = {
        "angularRate": np.repeat(DEG * rates, STEPS).reshape(ROWS, STEPS) + earth,
        "caseTemperature": np.full((ROWS, STEPS), gyro.reference_temperature),
    }
    constant = {
        **dict.fromkeys(("accelerationX", "accelerationY", "virtualRotation"), 0.0),
        **dict.fromkeys(("phaseOffset", "vibration"), 0.0),
        **{"accelerationZ": gyro.site.gravity, "amplitudeSetpoint": 1.0, "biasVoltage": 1.0},
    }
    held = {"driveOn": drive} | {name: np.full(ROWS, value) for name, value in constant.items()}
    first = {name: float(values.flat[0]) for name, values in {**moving, **held}.items()}
    parameters = {**gyro.without_noise().fmu_parameters(), **first}
    names = list(AT_END.values()), list(OUTPUTS_AVERAGED.values())
    with fmu.power_on(parameters, seed=0, start_angle=0.3) as on:
        ends, means = on.record(moving, held, STEP, *names)
    for name, column in zip((*AT_END, *OUTPUTS_AVERAGED), [*ends.T, *means.T], strict=True):
        np.testing.assert_array_equal(found[name], column, err_msg=name)
    np.testing.assert_array_equal(found.time, np.arange(1.0, ROWS + 1))


def test_outputs_are_labelled() -> None:
    found = simulate(TYPICAL, duration_s=2)
    assert {name: found[name].attrs["units"] for name in ("gyro_angle", "gyro_rate", "valid")} == {
        "gyro_angle": "rad",
        "gyro_rate": "rad/s",
        "valid": "1",
    }
    assert found.time.attrs["units"] == "s"
    assert found.pattern_angle.attrs["long_name"] == "Detected pattern angle, continuous"
    assert found.amplitude_force.attrs["cell_methods"] == "time: mean"
    assert found.attrs["model"] == "HRG"


def test_every_input_and_output_of_the_fmu_has_a_name(fmu: GyroFmu) -> None:
    variables = fmu.description.modelVariables
    inputs = {place.fmu_name for place in (*MOVING_INPUTS.values(), *HELD_INPUTS.values())}
    motion = {"caseAngle"}  # the rate again, as an angle
    assert inputs | motion == {v.name for v in variables if v.causality == "input"}
    outputs = {*AT_END.values(), *OUTPUTS_AVERAGED.values()}
    assert outputs == {v.name for v in variables if v.causality == "output"}


def test_a_seed_draws_noise_and_scatter_once_and_for_all() -> None:
    gyro = replace(TYPICAL, power_on_scatter=0.1)

    def run(seed: int | None) -> xr.Dataset:
        return simulate(gyro, duration_s=3, seed=seed)

    assert run(5).identical(run(5))
    assert not np.array_equal(run(5).gyro_angle, run(6).gyro_angle)
    assert run(5).attrs != run(6).attrs
    assert run(None).identical(run(None))


def test_inputs_may_be_functions_of_time() -> None:
    turned = simulate(
        Device(),
        duration_s=10,
        axis_up=0.0,
        table_rate_deg_per_s=lambda t: 2 * t,
        temperature_degC=lambda t: 25 + 0 * t,
        virtual_rotation_deg_per_s=np.zeros(10),
        pattern_angle_deg=10,
    )
    assert turned.gyro_angle[-1].item() == pytest.approx(100 * DEG, rel=1e-3)
    assert turned.pattern_angle[0].item() == pytest.approx(10 * DEG, abs=0.5 * DEG)


def test_a_misaligned_axis_feels_earth_s_horizontal_rate() -> None:
    gyro = replace(Device(), misalignment=0.01)
    north, south = (
        simulate(replace(gyro, misalignment_direction=turn), duration_s=100, axis_up=0.0)
        for turn in (0.0, np.pi)
    )
    rate = float(north.gyro_angle[-1] - south.gyro_angle[-1]) / 200
    assert rate == pytest.approx(np.sin(0.01) * gyro.site.horizontal_rate, rel=1e-3)


def test_slow_gyro_agrees_at_rest() -> None:
    ends = [
        simulate(TYPICAL, duration_s=60, model=model).gyro_angle[-1].item()
        for model in ("HRG", "HRGSlow")
    ]
    assert ends[0] == pytest.approx(ends[1], rel=1e-3)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"duration_s": 2.5}, "duration_s: found 2.5, expected a multiple of interval_s, 1"),
        ({"duration_s": 0}, "duration_s: found 0, expected a number from 1"),
        ({"duration_s": np.nan}, "duration_s: found nan"),
        ({"interval_s": 0}, "interval_s: found 0, expected a number from 0.001"),
        ({"step_s": 0.3}, "interval_s: found 1, expected a multiple of step_s, 0.3"),
        ({"step_s": 2}, "step_s: found 2, expected a number from 0.001 to 1"),
        ({"model": "HRGFast"}, "model: found 'HRGFast', expected HRG or"),
        ({"axis_up": 1.5}, "axis_up: found 1.5, expected a number from -1 to 1"),
        ({"seed": -1}, "seed: found -1, expected a whole number"),
        ({"pattern_angle_deg": np.inf}, "pattern_angle_deg: found inf"),
        ({"table_rate_deg_per_s": "fast"}, "table_rate_deg_per_s: found no numbers"),
        ({"table_rate_deg_per_s": [1, 2, 3]}, r"found an array of shape \(3,\), expected one"),
        ({"table_rate_deg_per_s": 1e9}, "table_rate_deg_per_s: found 1e.09, expected -5729.58 to"),
        ({"temperature_degC": np.nan}, "temperature_degC: found nan, expected -173.15 to"),
        ({"drive_on": 2}, "drive_on: found 2, expected 0 to 1"),
        ({"drive": 1}, "drive: found an unknown argument, expected drive_on"),
        ({"table_rate": 1}, "unknown argument, expected table_rate_deg_per_s$"),
        ({"table_rate_deg_per_s": "1"}, "table_rate_deg_per_s: found no numbers"),
        ({"duration_s": "60"}, "duration_s: found '60', expected a number from 1"),
        ({"interval_s": "0.1"}, "interval_s: found '0.1', expected a number"),
        ({"seed": "1"}, "seed: found '1', expected a whole number"),
        ({"seed": True}, "seed: found True, expected a whole number"),
    ],
)
def test_an_argument_of_no_use_is_named(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(HrgError, match=message):
        simulate(TYPICAL, **{"duration_s": 2, **arguments})


@pytest.mark.parametrize("device", ["no-such-gyro"])
def test_an_unknown_device_is_refused(device: str) -> None:
    with pytest.raises(HrgError, match=device):
        simulate(device, duration_s=1)


def test_the_documentation_lists_every_input() -> None:
    assert [name for name in HELD_INPUTS if f"`{name}`" not in (simulate.__doc__ or "")] == []
