"""The experiment: triads are flown with their level gyros' patterns parked, and without."""

from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np

from ins_eval.common.metrics import PairedRatio, compute_paired_ratio
from ins_eval.imu.sensor_error_model import TYPICAL_ACCELEROMETERS
from ins_eval.parking.gyro import measure_maps
from ins_eval.parking.mission import Mission
from ins_eval.parking.triad import DRIVES, TriadFlights, fly_triad
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.common.arguments import count_cores
from pyhrg.common.arrays import Array
from pyhrg.device.ready_devices import TYPICAL, Device
from pyhrg.fmu import GyroFmu


@dataclass(frozen=True)
class Comparison:
    """Triads flown in each of `CASES`."""

    seed: int
    device: str
    mission: str
    time: Array
    """(m,) s since the end of alignment."""
    radial: Array
    """(cases, n, m) position error of each triad, m."""
    heading: Array
    """(cases, n) error of the alignment, rad."""
    ready: Array
    """(cases, n) when the last gyro was ready, s since power-on."""
    start_up: Array
    """(records, n) heading error by what alignment uses (`triad.RECORDS`), rad."""

    @property
    def hours(self) -> float:
        """Length of the mission after alignment."""
        return float(self.time[-1]) / 3600

    @property
    def final(self) -> Array:
        """(cases, n) position error at the mission's end, m."""
        return self.radial[:, :, -1]

    @property
    def greatest(self) -> Array:
        """(cases, n) greatest position error within the mission, m."""
        return np.asarray(self.radial.max(axis=-1))


def compare_with_first_case(radial: Array) -> list[PairedRatio]:
    """Ratio of the errors (cases, n) to the first case's, by case."""
    return [compute_paired_ratio(errors, radial[0]) for errors in radial]


def compare(
    fmu_path: Path,
    mission: Mission,
    triads: int,
    seed: int,
    *,
    device: Device = TYPICAL,
    plan: Plan | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Comparison:
    """Fly every triad in every case; the same seed gives the same result on any number of workers.

    The triads are of the device's kind (`Device.another`); maps are measured at the positions of
    `plan` (`measure_maps`); `progress` is called with the gyro minutes done and those of all.
    """
    fmu = GyroFmu(fmu_path)
    truth = mission.truth.increments

    def fly(seeds: np.random.SeedSequence) -> TriadFlights:
        generator = np.random.default_rng(seeds)
        devices = [device.another(generator) for _ in range(3)]
        velocity = TYPICAL_ACCELEROMETERS.measure(truth.velocity, truth.interval, generator)
        benches = [Bench(fmu, each, seed=int(generator.integers(2**63))) for each in devices]
        gyros = [measure_maps(bench, plan) for bench in benches]
        return fly_triad(gyros, velocity, mission)

    one_triad = DRIVES * len(mission.time)
    flown = fmu.map(
        fly,
        np.random.SeedSequence(seed).spawn(triads),
        workers or count_cores(),
        lambda done: progress(done * one_triad, triads * one_triad) if progress else None,
    )
    by_triad = {
        f.name: np.stack([getattr(each, f.name) for each in flown], axis=1)
        for f in fields(TriadFlights)
    }
    return Comparison(
        seed=seed, device=device.name, mission=mission.name, time=mission.time, **by_triad
    )
