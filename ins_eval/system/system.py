"""A mission, gyros, accelerometers and navigator, written as an archive of the SSP standard."""

import warnings
from collections.abc import Callable, Sequence
from pathlib import Path

from scipy.spatial.transform import Rotation

from fmu_build.archive.packing import pack_archive
from fmu_build.binaries.platforms import choose_platforms, list_platforms
from fmu_build.bundle import build_fmu
from ins_eval.common.state import State
from ins_eval.flights.flight import Truth, sample_truth, spawn_seeds
from ins_eval.flights.plan import HeightMode, Plan, plan_simulation
from ins_eval.flights.sources import load_imu_at_rate
from ins_eval.imu.imu import Imu
from ins_eval.navigation.height import BaroDamped
from ins_eval.system.player.motion import SAMPLES, format_motion
from ins_eval.system.player.trajectory_fmu import build_trajectory_fmu
from ins_eval.system.player.variables import GYROS
from ins_eval.system.structure import (
    ACCELEROMETERS,
    NAVIGATOR,
    TRAJECTORY,
    VERSIONS,
    describe_structure,
)
from ins_eval.system.unit import Unit, Values, draw_unit
from ins_eval.trajectories import catalogue
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_file, write_whole
from pyhrg.device.parameter_set import format_values

FMI = 2
"""Version of the standard of all components: the one that every importer of an SSP runs."""


def write_system(
    out: Path | str,
    trajectory: Path | str = "car",
    imu: Imu | Path | str = "typical-hrg",
    *,
    hours: float = 1.0,
    rate_hz: int | None = None,
    height: HeightMode = "clamped",
    seed: int = 1,
    platforms: Sequence[str] = (),
    ssp: str = "1.0",
    progress: Callable[[str], None] = lambda text: None,
) -> Path:
    """Write an inertial navigation system as an SSP. It is the flight of `ins_eval.fly` with the
    same options, started from the truth, without the noise of the accelerometers.

    Args:
        out: file to write.
        trajectory: ready mission, mission file (TOML) or recorded drive.
        imu: an IMU with gyros of a device, a ready one's name or its file.
        hours, rate_hz, height, seed: as in `ins_eval.fly`. Run the system in communication steps of
            one interval.
        platforms: keys of `PLATFORMS` of FMI 2.0, or "all"; by default this machine's.
        ssp: version of the standard that is declared, 1.0 or 2.0.
        progress: function that is called with the name of each step.

    Raises:
        HrgError: an argument out of range, or a file that can't be used.
        OSError: `out` can't be written.
    """
    if ssp not in VERSIONS:
        raise HrgError(f"ssp: found {ssp!r}, expected {' or '.join(VERSIONS)}")
    check_output_file(Path(out))
    chosen = choose_platforms(list_platforms(FMI) if "all" in platforms else platforms, FMI)
    loaded = load_imu_at_rate(imu if isinstance(imu, Imu) else str(imu), rate_hz)
    plan = plan_simulation(
        loaded.interval, hours=hours, samples=SAMPLES, height=height, align_s=None, seed=seed
    )
    truth = sample_truth(plan, catalogue.load_trajectory(trajectory, plan.duration, 0.0))
    progress("drawing the gyros and measuring their mean bias")
    unit = draw_unit(loaded, plan.count, spawn_seeds(plan.seed, 1)[0])
    values = _list_values(unit, truth, plan.interval, height)
    name = truth.trajectory.name
    description = f"{loaded.name} IMU and strapdown navigator on the mission {name}"
    stop = plan.duration + plan.interval
    structure = describe_structure(name, description, list(values), plan.interval, stop, ssp)
    content = {
        "SystemStructure.ssd": structure.encode(),
        **_build_parts(truth, plan, chosen, progress),
        **{
            f"resources/{component}.ssv": format_values(each).encode()
            for component, each in values.items()
        },
    }
    progress("packing")
    write_whole(Path(out), pack_archive(content))
    return Path(out)


def _build_parts(
    truth: Truth, plan: Plan, platforms: Sequence[str], progress: Callable[[str], None]
) -> dict[str, bytes]:
    """The FMUs, by path."""
    parts = {}
    for model in ("HRG", "Accelerometers", "Navigator"):
        path = build_fmu(model, fmi=FMI, platforms=platforms, progress=progress)
        parts[f"resources/{model}.fmu"] = path.read_bytes()
    motion = format_motion(truth.increments, truth.heights)
    parts["resources/Trajectory.fmu"] = build_trajectory_fmu(
        motion, plan.interval, plan.duration, platforms, progress
    )
    return parts


def _list_values(
    unit: Unit, truth: Truth, interval: float, height: HeightMode
) -> dict[str, Values]:
    """Parameters by component."""
    gains = BaroDamped(truth.heights).gains if height == "baro" else (0.0, 0.0, 0.0)
    navigator = {
        "interval": interval,
        "heightClamped": float(height == "clamped"),
        **{f"heightGains[{i}]": gain for i, gain in enumerate(gains, 1)},
    }
    return {
        TRAJECTORY: unit.case_axes,
        **dict(zip(GYROS, unit.gyros, strict=True)),
        ACCELEROMETERS: unit.accelerometers,
        NAVIGATOR: navigator | list_start(truth.start) | unit.navigator,
    }


def list_start(start: State) -> Values:
    """Parameters of the navigator: where it starts."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # straight up, heading and roll are one rotation
        heading, pitch, roll = Rotation.from_matrix(start.mat_nb).as_euler("ZYX")
    return {
        "startLatitude": start.latitude,
        "startLongitude": start.longitude,
        "startHeight": start.height,
        **{f"startVelocity[{i}]": float(v) for i, v in enumerate(start.velocity, 1)},
        "startHeading": float(heading),
        "startPitch": float(pitch),
        "startRoll": float(roll),
    }
