"""The experiment: triads are flown under the schedules that the linear model chooses for them,
under those of another triad, and under schedules at random."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ins_eval.common.metrics import PairedRatio, compute_paired_ratio
from ins_eval.error_model.linear_model import AXES
from ins_eval.imu.sensor_error_model import TYPICAL_ACCELEROMETERS
from ins_eval.mission_model.missions import StudyMission
from ins_eval.schedules.choice import Planner
from ins_eval.schedules.families import FAMILIES
from ins_eval.schedules.flight import fly_schedules
from ins_eval.schedules.knowledge import KnownGyro, bench_gyro
from ins_eval.schedules.schedule import TAKES_MEAN, Schedule
from ins_eval.study.cosimulated import MissionTruth
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.common.arguments import count_cores
from pyhrg.common.arrays import Array
from pyhrg.device.ready_devices import TYPICAL, Device
from pyhrg.fmu import GyroFmu


@dataclass(frozen=True)
class Case:
    """What is compared. name: in files; label: in reports."""

    name: str
    label: str


TODAY = Case("mean", "no schedule, the maps' means taken out")
UNSCHEDULED = Case("unscheduled", "no schedule, level gyros' bias there taken out")
CHOICES = {"chosen": "chosen", "other": "another triad's", "random": "at random"}
"""Whose schedule is flown, by the ending of a case's name."""
CASES = (
    TODAY,
    UNSCHEDULED,
    *(
        Case(f"{family.name}_{choice}", f"{family.label}: {words}")
        for family in FAMILIES
        for choice, words in CHOICES.items()
    ),
)


@dataclass(frozen=True)
class Comparison:
    """n triads flown in each of `CASES`.

    Attributes:
        time: (k,) s since the end of alignment.
        error: (cases, n, k, 2) north and east, m.
        predicted: (cases, n) root of the expected mean square of the error over these times, m.
        schedules: (cases, n) what was flown.
    """

    seed: int
    device: str
    mission: str
    time: Array
    error: Array
    predicted: Array
    schedules: tuple[tuple[Schedule, ...], ...]

    @property
    def hours(self) -> float:
        """Length of the mission after alignment."""
        return float(self.time[-1]) / 3600

    @property
    def rms(self) -> Array:
        """(cases, n) rms horizontal error over the times, m, which the schedules make least."""
        return np.asarray(np.sqrt(np.square(self.error).sum(axis=-1).mean(axis=-1)))

    @property
    def radial(self) -> Array:
        """(cases, n, k) horizontal error, m."""
        return np.asarray(np.hypot(*np.moveaxis(self.error, -1, 0)))

    @property
    def final(self) -> Array:
        """(cases, n) horizontal error at the mission's end, m."""
        return self.radial[:, :, -1]

    def compare(self, case: str, reference: str) -> PairedRatio:
        """Ratio of the rms errors of two cases, by their names."""
        names = [each.name for each in CASES]
        return compute_paired_ratio(*(self.rms[names.index(name)] for name in (case, reference)))


@dataclass(frozen=True)
class _Triad:
    """A triad on its bench, the schedules that are chosen for it, and others at random."""

    benches: Sequence[Bench]
    gyros: Sequence[KnownGyro]
    accelerometers: int
    chosen: Sequence[Schedule]
    at_random: Sequence[Schedule]


@dataclass(frozen=True)
class Experiment:
    """A mission and the kind of gyros that are flown through it.

    Attributes:
        planner: of the mission; its families are `FAMILIES`.
        truth: of the mission.
        device: the triads are of its kind (`Device.another`).
        plan: positions at which maps are measured (`bench_gyro`).
    """

    fmu: GyroFmu
    planner: Planner
    truth: MissionTruth
    device: Device = TYPICAL
    plan: Plan | None = None

    def prepare(self, seeds: np.random.SeedSequence) -> _Triad:
        generator = np.random.default_rng(seeds)
        devices = [self.device.another(generator) for _ in range(AXES)]
        *own, accelerometers = generator.integers(2**63, size=AXES + 1).tolist()
        benches = [Bench(self.fmu, each, seed) for each, seed in zip(devices, own, strict=True)]
        gyros = [bench_gyro(bench, self.plan) for bench in benches]
        chosen = [self.planner.choose(family, gyros).schedule for family in FAMILIES]
        at_random = [family.draw(generator) for family in FAMILIES]
        return _Triad(benches, gyros, accelerometers, chosen, at_random)

    def fly(self, triad: _Triad, other: _Triad) -> tuple[Array, Array, tuple[Schedule, ...]]:
        """(cases, k, 2) errors, m, (cases,) expected rms, m, and the schedules, in the order of
        `CASES`."""
        true = self.truth.increments
        generator = np.random.default_rng(triad.accelerometers)
        velocity = TYPICAL_ACCELEROMETERS.measure(0 * true.velocity, true.interval, generator)
        families = zip(triad.chosen, other.chosen, triad.at_random, strict=True)
        errors, predicted, flown = [], [], []
        for schedules in ([Schedule(takes_mean=TAKES_MEAN), Schedule()], *map(list, families)):
            for flight in fly_schedules(triad.benches, self.truth, schedules, velocity):
                errors.append(flight.navigate(self.truth, triad.gyros))
                predicted.append(self.planner.predict(flight.schedule, triad.gyros).rms)
                flown.append(flight.schedule)
        return np.stack(errors), np.array(predicted), tuple(flown)


def compare(
    experiment: Experiment,
    mission: StudyMission,
    triads: int,
    seed: int,
    *,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Comparison:
    """Fly every triad in every case; the same seed gives the same result on any number of workers.

    `progress` is called with the number of triads benched and flown, and twice their number.
    """

    def report(done: int) -> None:
        if progress:
            progress(done, 2 * triads)

    threads = workers or count_cores()
    for family in FAMILIES:
        experiment.planner.weigh(family)
    seeds = np.random.SeedSequence(seed).spawn(triads)
    prepared = experiment.fmu.map(experiment.prepare, seeds, threads, report)
    pairs = list(zip(prepared, [*prepared[1:], prepared[0]], strict=True))
    flown = experiment.fmu.map(
        lambda pair: experiment.fly(*pair), pairs, threads, lambda done: report(triads + done)
    )
    errors, predicted, schedules = zip(*flown, strict=True)
    return Comparison(
        seed=seed,
        device=experiment.device.name,
        mission=mission.name,
        time=mission.interval * np.arange(1.0, errors[0].shape[1] + 1),
        error=np.stack(errors, axis=1),
        predicted=np.stack(predicted, axis=1),
        schedules=tuple(zip(*schedules, strict=True)),
    )
