"""The lead case: three gyros of the paper's Table 2 in a car for an hour.

The paper says that the same gyro shows 0.0009 deg/h at a fixed position and 0.1 deg/h over the
circumference, and that a car's navigation proves the second (4.1). Here that is flown: the gyro is
benched by the paper's procedure, its mean is taken out, and it flies from many start angles.
"""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from ins_eval.mission_model.missions import StudyMission, plan_mission
from ins_eval.study.cosimulated import MissionTruth, cosimulate
from ins_eval.study.gyros.bench_plan import BenchPlan
from ins_eval.study.gyros.drawn_triad import AXES, DrawnTriad, TriadDistribution
from ins_eval.study.gyros.drift import Flight, draw_flight
from ins_eval.study.gyros.makers_calibration import calibrate_gyro
from ins_eval.study.gyros.measured_gyro import measure_gyro
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TABLE2
from pyhrg.fmu import GyroFmu

DEVICE, MISSION, HOURS = "table2", "car", 1.0
BENCH = BenchPlan(runs=7, fixed_runs=7, segments=3, fixed_segments=36)
"""The paper's procedure (4.1): seven power-ons, points of 100 s; an hour at the fixed position. The
circumference has 24 positions, 8N with N = 3."""
_GYRO, _NOISE, _ANGLES = range(3)
"""Children of the study's seed: calibration and bench; flights; start angles."""


def plan_lead() -> StudyMission:
    return plan_mission(MISSION, HOURS)


def bench_lead(fmu: GyroFmu, seed: int) -> Array:
    """(2,) bias stability at the fixed position and over the circumference, rad/s.

    Args:
        fmu: `HRGSlow`.
    """
    measured = measure_gyro(fmu, _calibrate(fmu, seed), BENCH, _draw_seeds(seed)[1])
    return np.array([measured.fixed_stability, measured.circumference_stability])


def fly_lead(
    slow: GyroFmu,
    fmu: GyroFmu,
    truth: MissionTruth,
    seed: int,
    flights: Sequence[int],
    count: int,
) -> tuple[Array, Array]:
    """(r, k, 2) co-simulated errors, m, and (r, 3) start angles, rad, of some flights.

    Args:
        slow, fmu: `HRGSlow`, on which the maker's tests run, and `HRG`, which flies.
        truth: the mission of `plan_lead`.
        flights: numbers of the flights, from 0.
        count: number of all flights, over which the start angles are spread.
    """
    device, angles = _calibrate(slow, seed), spread_angles(seed, count)[list(flights)]
    errors = [
        _fly(fmu, truth, device, start, np.random.SeedSequence([seed, _NOISE, number]))
        for number, start in zip(flights, angles, strict=True)
    ]
    return np.array(errors), angles


def spread_angles(seed: int, count: int) -> Array:
    """(count, 3) start angles, rad: a Latin hypercube over half a turn, a period of every map."""
    generator = np.random.default_rng([seed, _ANGLES])
    places = np.stack([generator.permutation(count) for _ in range(AXES)], axis=1)
    return np.asarray(np.pi * (places + generator.random((count, AXES))) / count)


def _fly(
    fmu: GyroFmu,
    truth: MissionTruth,
    device: Device,
    start: Array,
    sequence: np.random.SeedSequence,
) -> Array:
    """(k, 2) error of a triad, m; it ages, warms and scatters as the study's triads do."""
    drawing, noise = sequence.spawn(2)
    generator, usual = np.random.default_rng(drawing), TriadDistribution()
    drawn = [draw_flight(device, usual.drift, generator) for _ in range(AXES)]
    triad = DrawnTriad(
        measured=(),
        flights=tuple(
            Flight(flight.device, flight.rise, float(angle))
            for flight, angle in zip(drawn, start, strict=True)
        ),
        accelerometers=generator.normal(0.0, usual.accelerometer_bias, AXES),
        mounting=generator.normal(0.0, usual.mounting, (2, AXES)),
        seed=np.zeros(2, dtype=np.uint64),
    )
    return cosimulate(fmu, truth, triad, noise)


@lru_cache(maxsize=1)
def _calibrate(fmu: GyroFmu, seed: int) -> Device:
    """The gyro whose mean the maker has taken out; kept in this process."""
    return calibrate_gyro(fmu, TABLE2, "mean", _draw_seeds(seed)[0])


def _draw_seeds(seed: int) -> list[int]:
    """Seeds of the maker's tests and of the bench's."""
    return np.random.default_rng([seed, _GYRO]).integers(2**31, size=2).tolist()
