"""The trajectory's FMU plays its file, and nothing else."""

import shutil
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave

from fmu_build.binaries.platforms import find_host_platform
from ins_eval.imu.gyros import case_axes
from ins_eval.system.player.motion import format_motion
from ins_eval.system.player.trajectory_fmu import build_trajectory_fmu
from ins_eval.system.player.variables import list_variables, name_case_axis
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

INTERVAL, COUNT = 0.02, 50
GENERATOR = np.random.default_rng(3)
INCREMENTS = Increments(INTERVAL, *GENERATOR.normal(size=(2, COUNT, 3)), 0.0)
HEIGHTS = np.cumsum(GENERATOR.normal(size=COUNT + 1))
OUTPUTS = [v.name for v in list_variables() if not v.is_parameter]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Extracted, in a folder whose name needs a URI's escapes."""
    place = tmp_path_factory.mktemp("tra jec %41 tory")
    motion = format_motion(INCREMENTS, HEIGHTS)
    host = [find_host_platform()]
    archive = build_trajectory_fmu(motion, INTERVAL, INTERVAL * COUNT, host, lambda text: None)
    (place / "Trajectory.fmu").write_bytes(archive)
    return Path(fmpy.extract(str(place / "Trajectory.fmu"), str(place / "extracted")))


def play(folder: Path, steps: int, values: dict[str, float], step: float = INTERVAL) -> np.ndarray:
    return fmpy.simulate_fmu(
        str(folder),
        stop_time=steps * step,
        output_interval=step,
        start_values=values,
        output=OUTPUTS,
    )


def gather(rows: np.ndarray, *names: str) -> Array:
    return np.stack([rows[name] for name in names], axis=1)


def test_plays_the_motion_of_each_case_and_the_reference(folder: Path) -> None:
    axes = np.linalg.qr(GENERATOR.normal(size=(3, 3)))[0]
    cases = [case_axes(axis) for axis in axes]
    values = {
        name_case_axis(gyro, axis, body): case[axis, body]
        for gyro, case in enumerate(cases)
        for axis in range(3)
        for body in range(3)
    }
    rows = play(folder, COUNT + 3, values)
    assert rows["row"].tolist() == [*range(1, COUNT + 2), COUNT + 1, COUNT + 1, COUNT + 1]
    rates, forces = INCREMENTS.rotation / INTERVAL, INCREMENTS.velocity / INTERVAL
    force = gather(rows, *(f"specificForce[{axis}]" for axis in (1, 2, 3)))
    assert np.array_equal(force[:COUNT], forces)
    assert np.all(force[COUNT:] == 0.0)
    assert np.array_equal(rows["referenceHeight"][: COUNT + 1], HEIGHTS)
    climb = np.gradient(HEIGHTS[::2], 2 * INTERVAL, edge_order=2)
    assert rows["referenceClimbRate"][: COUNT + 1 : 2] == pytest.approx(climb, abs=1e-12)
    for gyro, case in enumerate(cases, 1):
        felt = gather(rows, *(f"gyro{gyro}.acceleration{axis}" for axis in "XYZ"))
        assert felt[:COUNT] == pytest.approx(forces @ case.T, abs=1e-12)
        rate = rows[f"gyro{gyro}.angularRate"][:COUNT]
        assert rate == pytest.approx(rates @ case[2], abs=1e-12)


def test_rests_first_if_it_is_told_to(folder: Path) -> None:
    first, later = play(folder, 10, {}), play(folder, 10, {"leadIn": 3})
    assert later["row"].tolist() == [0, 0, 0, *range(1, 9)]
    assert np.all(gather(later[:3], "gyro1.angularRate", "specificForce[3]") == 0.0)
    assert later[OUTPUTS][3:].tolist() == first[OUTPUTS][:-3].tolist()


def test_communication_steps_may_divide_the_interval(folder: Path) -> None:
    whole, parts = play(folder, 8, {}), play(folder, 24, {}, INTERVAL / 3)
    assert parts[OUTPUTS][::3].tolist() == whole[OUTPUTS].tolist()


@pytest.mark.parametrize(
    "content",
    [None, b"", b"HRGPATH2" + bytes(200), format_motion(INCREMENTS, HEIGHTS)[:-1]],
    ids=["missing", "empty", "another format", "too short"],
)
def test_a_file_that_is_wrong_is_refused(
    folder: Path, content: bytes | None, tmp_path: Path
) -> None:
    copy = shutil.copytree(folder, tmp_path / "copy")
    file = copy / "resources" / "trajectory.bin"
    if content is None:
        file.unlink()
    else:
        file.write_bytes(content)
    with pytest.raises(Exception, match="instantiate"):
        play(copy, 1, {})


def test_calls_out_of_turn_and_values_out_of_range_are_refused(folder: Path) -> None:
    description = fmpy.read_model_description(str(folder))
    names = {v.name: v.valueReference for v in description.modelVariables}
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=str(folder),
        modelIdentifier="Trajectory",
        instanceName="t",
    )
    slave.instantiate()
    for call in (
        lambda: slave.doStep(0.0, 0.1),
        lambda: slave.setReal([names["row"]], [1.0]),
        lambda: slave.setReal([names["gyro1.caseAxes[1,1]"]], [1.5]),
        lambda: slave.setReal([names["leadIn"]], [float("nan")]),
        lambda: slave.getReal([len(names)]),
        lambda: slave.getFMUState(),
    ):
        with pytest.raises(Exception, match="failed with status"):
            call()
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    with pytest.raises(Exception, match="failed with status"):
        slave.setReal([names["leadIn"]], [1.0])
    slave.doStep(0.0, 0.05)
    assert slave.getReal([names["row"]]) == [3.0]
    slave.terminate()
    slave.reset()
    slave.freeInstance()
