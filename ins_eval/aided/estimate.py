"""States of a drive by filter and smoother, with a bench's maps as far as the drive bears them
out."""

from collections.abc import Mapping
from dataclasses import dataclass

from ins_eval.aided.bench_maps import BenchTest, choose_bench_maps, take_bench_maps
from ins_eval.aided.fixes import Fixes
from ins_eval.aided.kalman.backward import Smoothed, smooth
from ins_eval.aided.kalman.drive import Drive
from ins_eval.aided.kalman.forward import Filtered, Start, run_filter
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.mission_model.bench_map import BenchMap
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class DriveEstimate:
    """sensors: states, with the bench's maps that were used; used: their axes; tests: of the
    maps."""

    sensors: SensorStates
    filtered: Filtered
    smoothed: Smoothed
    used: frozenset[int] = frozenset()
    tests: tuple[BenchTest, ...] = ()


def estimate_drive(
    drive: Drive,
    fixes: Fixes,
    sensors: SensorStates,
    start: Start,
    lever_arm: Array,
    last: int,
    maps: Mapping[int, BenchMap],
) -> DriveEstimate:
    """States from the beginning of a drive to its step `last`.

    The drive is filtered without the bench's maps, and again with those that it does not
    contradict.

    maps: of the bench, by axis.
    """
    filtered = run_filter(drive, fixes, sensors, start, lever_arm, last)
    smoothed, adjoint = smooth(filtered, sensors, drive.step)
    kept, tests = choose_bench_maps(sensors, maps, adjoint)
    if kept:
        sensors = take_bench_maps(sensors, kept)
        filtered = run_filter(drive, fixes, sensors, start, lever_arm, last)
        smoothed, _ = smooth(filtered, sensors, drive.step)
    return DriveEstimate(sensors, filtered, smoothed, frozenset(kept), tests)
