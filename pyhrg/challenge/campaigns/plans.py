"""Plans of a campaign's tests: those of the recorded campaigns, with numbers that are drawn."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.bench.programme import Programme
from pyhrg.common.units import DEG, HOUR
from pyhrg.device.device import Device

MAX_HOURS = 48.0
"""Longest total duration of further tests, h (chosen)."""
STILL_ROWS = 10.0
"""Length of a row of a further test at rest, s (chosen)."""
SPIN_UP = 19
"""Number of rows in which the table accelerates to its rate."""
AMOUNTS = ("full", "few", "short", "coarse")
"""Amounts of data: all tests; one or two kinds; tests a tenth as long; rows of at least 1 s. The
held-out test is always there."""
SHORTENING, COARSE_ROW = 10.0, 1.0
"""How much shorter short tests are; length of a coarse row, s."""
TURNS = (45, 90, 180, 360)
"""Angles that a vehicle's heading turns by, deg."""


@dataclass(frozen=True)
class Plan:
    """The plan of one test; start_angle: pattern angle at power-on, rad."""

    id: str
    kind: str
    role: str
    programme: Programme
    start_angle: float


@dataclass(frozen=True)
class Variation:
    """Begins programmes for a device, and draws their numbers; `data` is a key of `AMOUNTS`."""

    device: Device
    generator: np.random.Generator
    data: str = "full"

    def programme(self, interval: float) -> Programme:
        """An empty programme in rows of `interval` seconds, or of a coarse row if longer."""
        interval = max(interval, COARSE_ROW) if self.data == "coarse" else interval
        return Programme(interval, self.device.site.gravity, self.device.reference_temperature)

    def about(self, value: float, unit: float = 0.01, spread: float = 0.1) -> float:
        """A number drawn uniformly from value * (1 - spread) to value * (1 + spread), rounded to a
        multiple of the unit."""
        varied = value * (1 + spread * self.generator.uniform(-1, 1))
        return round(round(varied / unit) * unit, 9)

    def duration(self, value: float, unit: float = 1.0, spread: float = 0.1) -> float:
        """A duration drawn about a value, s; a tenth of it if tests are short, at least a unit."""
        if self.data == "short":
            value = value / SHORTENING
        return max(self.about(value, unit, spread), unit)

    def shorten(self, duration: float) -> float:
        """A duration that is not drawn, s; a tenth of it if tests are short, at least 1 s."""
        return max(round(duration / SHORTENING), 1.0) if self.data == "short" else duration

    def sign(self) -> int:
        """Plus or minus one."""
        return int(self.generator.choice((-1, 1)))


Profiled = tuple[str, str, str, Callable[[Variation], Programme]]
"""Name, kind, role and profile of a test."""


def plan_tests(
    device: Device, generator: np.random.Generator, complete: bool = False, data: str = "full"
) -> list[Plan]:
    """Plans of one campaign's tests, in the order of `TESTS`. If it need not be complete, one or
    two kinds of tests may be missing, but neither the held-out test nor the test at rest. Of few
    data, there are one or two kinds of tests beside the held-out one."""
    made = _draw_plans(TESTS, device, generator, data)
    if data == "few":
        kinds = sorted({plan.kind for plan in made if plan.role == "fit"})
        kept = {"manoeuvre", *generator.choice(kinds, generator.integers(1, 3), replace=False)}
        return [plan for plan in made if plan.kind in kept]
    spare = sorted({plan.kind for plan in made} - {"static", "manoeuvre"})
    missing = generator.choice((0, 1, 2), p=(0.7, 0.2, 0.1))
    without = set(generator.choice(spare, size=missing, replace=False))
    return [plan for plan in made if complete or plan.kind not in without]


def plan_further_tests(
    kind: str, hours: float, device: Device, generator: np.random.Generator
) -> list[Plan]:
    """Plans of further tests of one kind, repeated until they last the given hours together, or
    `MAX_HOURS` if that is less. At rest, one test lasts the whole time.

    Raises:
        ValueError: no such kind.
    """
    chosen = [test for test in TESTS if test[1] == kind]
    if not chosen:
        kinds = ", ".join(dict.fromkeys(test[1] for test in TESTS))
        raise ValueError(f"{kind}: expected one of {kinds}")
    duration = min(hours, MAX_HOURS) * HOUR
    if kind == "static":
        rest = Variation(device, generator).programme(STILL_ROWS).rest(duration)
        return [Plan("next_1_static", kind, "fit", rest, generator.uniform(0, math.pi / 2))]
    made: list[Plan] = []
    while sum(plan.programme.time for plan in made) < duration:
        number = len(made) // len(chosen) + 1
        again = _draw_plans(chosen, device, generator)
        made += [replace(plan, id=f"next_{number}_{plan.id}", role="fit") for plan in again]
    return made


def _draw_plans(
    tests: Sequence[Profiled], device: Device, generator: np.random.Generator, data: str = "full"
) -> list[Plan]:
    vary = Variation(device, generator, data)
    return [
        Plan(name, kind, role, profile(vary), generator.uniform(0, math.pi / 2))
        for name, kind, role, profile in tests
    ]


def static(vary: Variation) -> Programme:
    """At rest."""
    return vary.programme(1.0).rest(vary.duration(3600, 60))


def positions(vary: Variation) -> Programme:
    """Rests at eight pattern angles, 22.5 deg apart; the table turns between them."""
    course = vary.programme(1.0)
    step = 22.5 * DEG / vary.device.bryan_factor
    dwell = vary.duration(579, 1, 0.05)
    rate = vary.about(4.06137, 1e-3) * DEG
    course.rest(dwell + 20)
    for _ in range(7):
        course.turn(step, rate).rest(dwell)
    return course


def spin_up(course: Programme, rate: float, duration: float) -> Programme:
    """Add a linear acceleration of the table and a constant rate, rad/s."""
    for bound in np.linspace(0, rate, SPIN_UP + 1)[1:].tolist():
        course.spin(bound, course.interval)
    return course.spin(rate, duration - SPIN_UP * course.interval)


def rates(rate_deg_per_s: float, duration: float) -> Callable[[Variation], Programme]:
    """A test at a constant rate of the table."""

    def profile(vary: Variation) -> Programme:
        rate, length = vary.about(rate_deg_per_s) * DEG, vary.duration(duration)
        return spin_up(vary.programme(0.1), rate, length)

    return profile


def ring_down(vary: Variation) -> Programme:
    """A rest, then a ring-down with the drive off."""
    course = vary.programme(1.0).rest(vary.duration(19))
    return course.command(drive_on=0.0).rest(vary.duration(381))


def virtual_rotation(rate_deg_per_s: float) -> Callable[[Variation], Programme]:
    """A rest, then a commanded rotation of the pattern."""

    def profile(vary: Variation) -> Programme:
        course = vary.programme(1.0).rest(vary.shorten(9))
        course.command(virtual_rotation=vary.about(rate_deg_per_s, 1e-3) * DEG)
        return course.rest(vary.duration(491))

    return profile


def thermal(vary: Variation) -> Programme:
    """Soak, heating, soak, cooling, soak; or cooling first."""
    reference = vary.device.reference_temperature
    hot, cold = reference + vary.about(35, 1), reference - vary.about(35, 1)
    first, last = (hot, cold) if vary.sign() > 0 else (cold, hot)
    course = vary.programme(10.0).rest(vary.duration(1800, 10))
    course.heat(first, vary.duration(2400, 10)).rest(vary.duration(2400, 10))
    return course.heat(last, vary.duration(5800, 10)).rest(vary.duration(2000, 10))


def amplitude(vary: Variation) -> Programme:
    """Three amplitude set points one after the other, while the table turns."""
    low, high = vary.about(0.8, 0.01, 0.05), vary.about(1.2, 0.01, 0.05)
    rate, held = vary.sign() * vary.about(5) * DEG, vary.shorten(80.0)
    course = spin_up(vary.programme(0.1).command(amplitude_setpoint=low), rate, held)
    course.command(amplitude_setpoint=1.0).spin(rate, held)
    return course.command(amplitude_setpoint=high).spin(rate, held)


def phase_step(vary: Variation) -> Programme:
    """Phase offset of 0, then positive, then negative, then 0."""
    step, dwell = vary.about(2e-3, 1e-4, 0.25), vary.duration(400, 10)
    course = vary.programme(1.0)
    for offset in (0.0, step, -step, 0.0):
        course.command(phase_offset=offset).rest(dwell)
    return course


def tumble(vary: Variation) -> Programme:
    """Six attitudes: input axis up, down, and level with x up, down, y up, down."""
    course = vary.programme(1.0)
    dwell = vary.duration(400, 10)
    attitudes = [(1.0, 0.0), (-1.0, 0.0)] + [(0.0, across * math.pi / 2) for across in (0, 2, 1, 3)]
    for axis_up, across in attitudes:
        course.attitude(axis_up, across).rest(dwell)
    return course


def manoeuvre(vary: Variation) -> Programme:
    """The held-out test: a vehicle turns and rests for an hour while it warms up."""
    generator = vary.generator
    course = vary.programme(1.0)
    duration = 3600
    while True:
        angle = vary.sign() * float(generator.choice(TURNS)) * DEG
        rate = generator.uniform(5, 25) * DEG
        rest = round(generator.uniform(40, 220))
        turn = max(2, math.ceil(abs(angle) / rate) + 1)
        if course.time + rest + turn > duration:
            break
        course.rest(rest).turn(angle, rate)
    course.rest(duration - course.time)
    warming = vary.about(10) * -np.expm1(-np.arange(duration + 1) / vary.about(1500))
    return course.set_temperatures(vary.device.reference_temperature + warming)


TESTS: tuple[Profiled, ...] = (
    ("static_fixed", "static", "fit", static),
    ("positions_8n", "positions", "fit", positions),
    ("rate_low_pos", "rate", "fit", rates(5, 140)),
    ("rate_high_pos", "rate", "fit", rates(100, 40)),
    ("rate_low_neg", "rate", "fit", rates(-5, 140)),
    ("rate_high_neg", "rate", "fit", rates(-100, 40)),
    ("ring_down", "ring_down", "fit", ring_down),
    ("virtual_rotation_pos", "virtual_rotation", "fit", virtual_rotation(1)),
    ("virtual_rotation_neg", "virtual_rotation", "fit", virtual_rotation(-1)),
    ("thermal_ramp", "thermal", "fit", thermal),
    ("amplitude_sweep", "amplitude", "fit", amplitude),
    ("phase_step", "phase_step", "fit", phase_step),
    ("tumble", "tumble", "fit", tumble),
    ("manoeuvre_holdout", "manoeuvre", "holdout", manoeuvre),
)
"""Name, kind, role and profile of each test of a campaign."""
