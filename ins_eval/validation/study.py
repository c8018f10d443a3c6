"""The experiment: bench one gyro, fly triads of its kind, compare promise and outcome."""

import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ins_eval.imu.accelerometers import TYPICAL_ACCELEROMETERS
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.triad import Triad
from ins_eval.parallel import in_parallel
from ins_eval.validation.mission import Mission, since
from ins_eval.validation.prediction import bias_sensitivity, predicted_radial_error
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias import fixed_position, full_circumference
from pyhrg.bench.bias.bias_test import BiasTest
from pyhrg.bench.bias.comparison import bias_table
from pyhrg.campaign import Test
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL, Device

Array = NDArray[np.float64]
Done = Callable[[int], None]


@dataclass(frozen=True)
class Validation:
    """What was benched, promised and flown."""

    seed: int
    mission: str
    hours: float
    fixed_position: BiasTest
    full_circumference: BiasTest
    time: Array
    """(m,) s since the end of alignment."""
    predicted_fixed_position: Array
    """(m,) median radial error that the old test promises, m."""
    predicted_full_circumference: Array
    """(m,) likewise from the paper's test."""
    flown: Array
    """(n, m) radial error of each triad, m."""

    @property
    def table(self) -> str:
        """Bench results in the layout of the paper's Table 2."""
        return bias_table(self.fixed_position, self.full_circumference)


def work(triads: int, mission: Mission) -> int:
    """Gyro time that `validate` simulates, minutes: the sum of what it reports as done.

    Seven hours at the fixed position, seven times 44 min over the circumference.
    """
    return 7 * (60 + 44) + triads * 3 * len(mission.time)


def validate(
    fmu_path: Path,
    mission: Mission,
    triads: int,
    seed: int,
    *,
    device: Device = TYPICAL,
    accelerometers: Triad = TYPICAL_ACCELEROMETERS,
    workers: int | None = None,
    done: Done = lambda minutes: None,
) -> Validation:
    """Run the experiment.

    Args:
        fmu_path: the gyro's model.
        mission: what is flown.
        triads: how many.
        seed: of everything random; the same seed gives the same result on any number of workers.
        device: the gyro that is benched; the triads are of its kind (`Device.another`).
        accelerometers: of every triad.
        workers: threads; as many as this process has cores, if not given.
        done: told the gyro time, minutes, of each piece of work that is done.
    """
    fmu = GyroFmu(fmu_path)
    bench_seed, flight_seed = np.random.SeedSequence(seed).spawn(2)
    bench = Bench(fmu, device, seed=int(bench_seed.generate_state(1, np.uint64)[0]))
    power_ons = fixed_position.power_ons(bench)
    power_ons += full_circumference.power_ons(bench, full_circumference.SHORTEST)
    sensitivity = bias_sensitivity(mission)
    imu = Imu(FmuGyros(device, start_up=True, fmu=fmu), accelerometers, mission.truth.interval)
    stop = threading.Event()
    fmu.stop = stop

    def fly(seeds: np.random.SeedSequence) -> Array:
        measured = imu.measure(mission.truth, seeds)
        error = mission.fly(measured.increments, since(measured.ready))
        return np.asarray(np.hypot(error[:, 0], error[:, 1]))

    def benched(test: Test) -> None:
        done(round(test.log.time[-1] / 60))

    fmu.prepare()
    logs = in_parallel(bench.log, power_ons, stop, workers, benched)
    triad_seeds = flight_seed.spawn(triads)
    flown = in_parallel(fly, triad_seeds, stop, workers, lambda _: done(3 * len(mission.time)))
    campaign = bench.campaign(logs)
    old, new = fixed_position.measured(campaign), full_circumference.measured(campaign)

    def promised(test: BiasTest) -> Array:
        return predicted_radial_error(sensitivity, test.stability, accelerometers.bias.size)

    return Validation(
        seed=seed,
        mission=mission.name,
        hours=mission.hours,
        fixed_position=old,
        full_circumference=new,
        time=mission.time,
        predicted_fixed_position=promised(old),
        predicted_full_circumference=promised(new),
        flown=np.stack(flown),
    )
