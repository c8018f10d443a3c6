"""The navigator's FMU is `ins_eval.navigate`: one mechanisation, in Modelica and compiled."""

import re

import fmpy
import numpy as np
import pytest

import ins_eval
from fmu_build import build_fmu
from ins_eval.common import earth
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.state import State, Track, position_error
from ins_eval.navigation.coefficients import derive_coefficients
from ins_eval.navigation.height import BaroDamped, Clamped, Free, Height
from ins_eval.system.system import list_start
from pyhrg.common.arrays import Array
from pyhrg.common.made_by import find_modelica
from pyhrg.records.imu.log import Increments

INTERVAL = 0.01
OUTPUTS = ["latitude", "longitude", "height", "velocityNorth", "velocityEast", "velocityDown"]
STRAPDOWN = find_modelica() / "Strapdown"


@pytest.fixture(scope="module")
def fmu(tmp_path_factory: pytest.TempPathFactory) -> str:
    return fmpy.extract(str(build_fmu("Navigator")), tmp_path_factory.mktemp("navigator"))


def feed(increments: Increments, heights: Array, climb: Array) -> np.ndarray:
    """Inputs of the FMU: readings at the bounds of the increments, as an importer hands them on."""
    readings = {"time": INTERVAL * np.arange(len(heights)), "row": 1.0 + np.arange(len(heights))}
    for axis in range(3):
        for name, values in (
            ("gyroAngle", increments.rotation),
            ("velocity", increments.velocity),
        ):
            sums = np.concatenate([[0.0], np.cumsum(values[:, axis])])
            readings[f"{name}[{axis + 1}]"] = sums
    readings |= {"referenceHeight": heights, "referenceClimbRate": climb}
    table = np.zeros(len(heights), dtype=[(name, float) for name in readings])
    for name, values in readings.items():
        table[name] = values
    return table


def fly(fmu: str, table: np.ndarray, values: dict[str, float]) -> np.ndarray:
    """Rows of outputs at communication points of one interval."""
    return fmpy.simulate_fmu(
        fmu,
        stop_time=table["time"][-1] + INTERVAL,
        output_interval=INTERVAL,
        start_values={"interval": INTERVAL, **values},
        input=table,
        output=[*OUTPUTS, "heading", "pitch", "roll", "navigationTime", "valid"],
    )


def compare(fmu: str, start: State, increments: Increments, height: Height) -> None:
    count = len(increments)
    channel = height.make_channel(count, 2, INTERVAL)
    heights = getattr(height, "heights", np.zeros(count + 1))
    steps = np.arange(0.0, count + 1, 2)
    climb = np.interp(np.arange(count + 1.0), steps, channel.climb)
    values = {**list_start(start), "heightClamped": float(channel.clamped)}
    values |= {f"heightGains[{i}]": gain for i, gain in enumerate(channel.gains, 1)}
    rows = fly(fmu, feed(increments, heights, climb), values)
    track = ins_eval.navigate(start, increments, height, count)
    assert_equal(rows[-1], track)


def assert_equal(row: np.void, track: Track) -> None:
    assert row["valid"] == 1
    assert row["navigationTime"] == pytest.approx(track.time[-1], abs=1e-9)
    found = np.array([row[name] for name in OUTPUTS])
    assert np.max(np.abs(position_error(found[:3], track.position[-1]))) < 1e-6
    assert found[3:] == pytest.approx(track.velocity[-1], abs=1e-9)
    roll, pitch, heading = row["roll"], row["pitch"], row["heading"]
    attitude = mat_from_euler(*np.array([roll, pitch, heading]))
    assert attitude == pytest.approx(track.mat_nb[-1], abs=1e-12)


def test_flies_a_mission_with_each_kind_of_height_aiding(fmu: str) -> None:
    """Within a micrometre, 1e-9 m/s and 1e-12 rad after a minute."""
    weaving = ins_eval.load_trajectory("weaving", duration_s=60.0)
    increments = weaving.increments(0.0, INTERVAL, 6000)
    heights = weaving.position(increments.bounds)[:, 2]
    for height in (Clamped(heights), BaroDamped(heights + 3.0, 20.0), Free()):
        compare(fmu, weaving.state(0.0), increments, height)


def test_turns_of_any_angle_a_step(fmu: str) -> None:
    """Beyond 0.2 rad a step, where power series end, with coning and sculling."""
    phase = np.arange(400)[:, None] * np.array([0.3, 0.5, 0.7])
    increments = Increments(INTERVAL, 0.3 * np.sin(phase), 0.4 * np.cos(phase), 0.0)
    start = State(-0.6, 3.0, 5000.0, np.array([200.0, -300.0, 5.0]), np.eye(3))
    compare(fmu, start, increments, Free())


def test_gyros_are_mounted_and_calibrated(fmu: str) -> None:
    """Readings of skewed gyros with a bias are those of a triad without."""
    generator = np.random.default_rng(1)
    axes = np.linalg.qr(generator.normal(size=(3, 3)))[0] @ np.diag([1.0, 0.9, 1.1])
    bias = np.array([1e-3, -2e-3, 3e-3])
    rotation, velocity = generator.normal(0.0, 1e-3, size=(2, 100, 3))
    start = State(0.5, 0.0, 0.0, np.zeros(3), np.eye(3))
    read = Increments(INTERVAL, rotation @ axes.T + bias * INTERVAL, velocity, 0.0)
    names = ("forwardShares", "rightShares", "downShares")
    values = {
        f"{name}[{i}]": share
        for name, row in zip(names, np.linalg.inv(axes), strict=True)
        for i, share in enumerate(row, 1)
    }
    values |= {f"gyroBias[{i}]": each for i, each in enumerate(bias, 1)}
    still = np.zeros(101)
    rows = fly(fmu, feed(read, still, still), values | list_start(start))
    true = Increments(INTERVAL, rotation, velocity, 0.0)
    assert_equal(rows[-1], ins_eval.navigate(start, true, Clamped(still), 100))


def test_what_comes_before_the_motion_is_left_out_and_what_is_missed_is_seen(fmu: str) -> None:
    car = ins_eval.load_trajectory("car", duration_s=60.0)
    increments = car.increments(0.0, INTERVAL, 200)
    heights = car.position(increments.bounds)[:, 2]
    table = feed(increments, heights, np.zeros(201))
    late = np.concatenate([table[:5], table])
    late["time"] = INTERVAL * np.arange(len(late))
    late["row"][:5] = 0.0
    for name in ("gyroAngle[1]", "velocity[2]"):
        late[name][:5] = 7.0
    values = list_start(car.state(0.0))
    once, later = fly(fmu, table, values), fly(fmu, late, values)
    assert later[OUTPUTS][-1] == once[OUTPUTS][-1]
    assert later["navigationTime"][-1] == once["navigationTime"][-1] == pytest.approx(2.0)
    gap = np.delete(table, 50)
    gap["time"] = table["time"][:-1]
    rows = fly(fmu, gap, values)
    assert rows["valid"][40] == 1
    assert np.all(rows["valid"][52:] == 0)


def test_is_an_fmu_of_fmi_3_too() -> None:
    """A parameter that is 1 or 0 is a Boolean there, and doesn't change."""
    description = fmpy.read_model_description(str(build_fmu("Navigator", fmi=3)), validate=True)
    clamped = {v.name: v for v in description.modelVariables}["heightClamped"]
    assert (clamped.type, clamped.variability, clamped.start) == ("Boolean", "fixed", "true")


def test_its_numbers_are_those_of_the_compiled_navigator() -> None:
    """Earth's, and the coefficients of two increments, as the Modelica text has them."""
    text = (STRAPDOWN / "Earth" / "package.mo").read_text()
    stated = dict(re.findall(r"Real (\w+) = ([\d.e-]+) ", text))
    own = {
        "rate": earth.RATE,
        "semiMajor": earth.SEMI_MAJOR,
        "equatorGravity": earth.GRAVITY_EQUATOR,
        "somigliana": earth.SOMIGLIANA,
        "gravityRatio": earth.GRAVITY_RATIO,
        "plumbLine": earth.PLUMB_LINE,
    }
    assert {name: float(number) for name, number in stated.items()} == own
    assert f"flattening = 1/{1 / earth.FLATTENING:.9f} " in text
    turning, scrolling, mean = derive_coefficients(2)
    assert turning == pytest.approx(np.array([[0, 2 / 3], [-2 / 3, 0]]), abs=1e-15)
    assert scrolling == pytest.approx(np.array([[7 / 30, 0.1], [-7 / 30, -0.1]]), abs=1e-15)
    assert mean == pytest.approx([5 / 6, 1 / 6], abs=1e-15)
    step = (STRAPDOWN / "Mechanization" / "bodyStep.mo").read_text()
    assert all(number in step for number in ("2/3*", "7/30*", "1/10*", "5/6*", "1/6*"))
