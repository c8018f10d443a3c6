"""A short campaign of a gyro whose bias has a sixth harmonic, which the catalogue lacks."""

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.challenge.campaigns.course import Course, make_course
from pyhrg.challenge.campaigns.gyro import Disturbance, TrueGyro
from pyhrg.challenge.truths.form import find_ideal_pattern_angle
from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign, Test
from tests.pyhrg.gap.bench import short, stated
from tests.pyhrg.gap.soundness.conftest import NOMINAL

COS6, SIN6 = 0.6, -0.4
"""Coefficients of the bias, deg/h."""


def record_sixth_harmonic(fmu: GyroFmu, seed: int = 3) -> Campaign:
    """The bias enters as an input rate, computed apart from any candidate term."""

    def rate(course: Course, start: float) -> np.ndarray:
        angle = 6 * find_ideal_pattern_angle(NOMINAL, course, start)
        return np.asarray((COS6 * np.cos(angle) + SIN6 * np.sin(angle)) * DEG_PER_H)

    generator = np.random.default_rng(seed)
    gyro = TrueGyro(fmu, NOMINAL, disturbance=Disturbance(rate=rate))
    tests = []
    for power_on in short(Bench(fmu, NOMINAL)):
        course = make_course(power_on.programme, power_on.programme.interval / 100)
        start = generator.uniform(0, 1.5)
        log, _ = gyro.log(power_on.id, course, start, generator)
        role = "holdout" if power_on.kind == "manoeuvre" else "fit"
        tests.append(Test(power_on.id, power_on.kind, role, log))
    return Campaign("sixth", NOMINAL.site, stated(NOMINAL), tuple(tests))
