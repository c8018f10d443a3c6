"""How often an effect without a name gets the right equation, and none where there is none.

    python benchmarks/terms.py [seed]

Twenty gyros, each with an error of another place, coordinate and form, at a drawn size; ten without
such an error, half of them with an effect of the catalogue. The forms saturate, have edges or
powers between those of the candidate terms, so that none is a candidate term exactly. Short
campaigns of the gyro with sampled loops, the whole catalogue. A place, a coordinate and a form are
right when those of the largest proposed term are; the excess of the held-out test is that of the
output angle, or of the channel that the error shows in. A term beside it is false when its place
and coordinate are both wrong.
"""

import math
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import binomtest
from tqdm import tqdm

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import (
    apply_play,
    find_ideal_pattern_angle,
    find_resonator_warmth,
)
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, HZ, MINUTE
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.findings.diagnosis import Diagnosis
from pyhrg.gap.findings.term import Term
from pyhrg.gap.replay.simulation import load_simulation
from pyhrg.records import Log
from tests.pyhrg.gap.closing.equation.planted import (
    plant_drive_gain,
    plant_electrode_error,
    record_planted,
    shift_angle,
    triangle,
)
from tests.pyhrg.gap.soundness.conftest import NOMINAL

Disturb = Callable[[float], Disturbance]
SIMULATION = load_simulation()
GROWTH, GRAVITY = 1 / NOMINAL.decay_time, 9.81


@dataclass(frozen=True)
class Error:
    """An error; disturb: of a size of about 1; functions: beginnings of the words of candidate
    terms that have its form."""

    place: str
    coordinate: str
    functions: tuple[str, ...]
    disturb: Disturb


def bias(shape: Callable[[Course, float], Array], deg_h: float) -> Disturb:
    """An input rate of this shape."""
    return lambda size: Disturbance(
        rate=lambda course, start: size * deg_h * DEG_PER_H * shape(course, start)
    )


def of_pattern(shape: Callable[[Array], Array]) -> Callable[[Course, float], Array]:
    """A function of the pattern angle along a course."""
    return lambda course, start: shape(find_ideal_pattern_angle(NOMINAL, course, start))


def read_angle(shape: Callable[[Log], Array], arcsec: float) -> Disturb:
    """An error of the angle alone."""
    return lambda size: Disturbance(
        shown=lambda log: shift_angle(log, size * arcsec * ARCSEC * shape(log))
    )


def damping(power: float, ratio: float) -> Disturb:
    """Damping that grows with a power of the amplitude."""

    def disturb(size: float) -> Disturbance:
        def show(log: Log) -> Log:
            added = size * ratio * GROWTH * (log.amplitude**power - 1)
            is_free = log.is_free
            decay = np.cumsum(np.where(is_free, added, 0.0)) * log.interval
            return replace(
                log,
                amplitude_force=log.amplitude_force + np.where(is_free, 0.0, added),
                amplitude=log.amplitude * np.exp(-decay),
            )

        return Disturbance(shown=show)

    return disturb


def channel(name: str, shape: Callable[[Log], Array], unit: float) -> Disturb:
    """An error of another channel alone."""
    return lambda size: Disturbance(
        shown=lambda log: replace(log, **{name: getattr(log, name) + size * unit * shape(log)})
    )


def heat(course: Course, start: float) -> Array:
    """Temperature of the resonator above the reference, K."""
    return find_resonator_warmth(NOMINAL, course)


def heating(course: Course, start: float) -> Array:
    """Rate of the case's temperature, K/min."""
    rate = np.diff(course.case_temperature) / course.interval * MINUTE
    return np.asarray(np.repeat(rate[:, None], course.steps, axis=1))


def played(course: Course, start: float) -> Array:
    """Temperature of the case with a play of 6 K, in tens of kelvins."""
    values = course.temperature - NOMINAL.reference_temperature
    return apply_play(values.ravel(), 6.0).reshape(values.shape) / 10


def along(axis: str) -> Callable[[Course, float], Array]:
    """Specific force along an axis, g."""
    return lambda course, start: course.each(f"acceleration_{axis}") / GRAVITY


def warm(log: Log) -> Array:
    """Temperature of the case above the reference, in tens of kelvins."""
    return np.asarray((log.temperature - NOMINAL.reference_temperature) / 10)


RATE = ("bias: rate", "bias: magnitude of the rate")
ERRORS = (
    Error("bias", "wave_angle", ("bias: harmonic 6",),
          bias(of_pattern(lambda a: np.exp(np.cos(6 * a)) - 1.27), 0.3)),
    Error("bias", "wave_angle", ("bias: harmonic 3",),
          bias(of_pattern(lambda a: triangle(3 * a)), 0.3)),
    Error("bias", "wave_angle", ("bias: harmonic 7",),
          bias(of_pattern(lambda a: triangle(7 * a)), 0.3)),
    Error("bias", "temperature", ("bias: temperature",),
          bias(lambda c, s: np.tanh(heat(c, s) / 15), 0.2)),
    Error("bias", "temperature", ("bias: temperature",),
          bias(lambda c, s: np.expm1(heat(c, s) / 25), 0.1)),
    Error("bias", "temperature", ("bias: temperature with a hysteresis",), bias(played, 0.1)),
    Error("bias", "temperature_rate", ("bias: temperature rate", "bias: direction"),
          bias(lambda c, s: np.sign(heating(c, s)) * np.abs(heating(c, s)) ** 0.7, 0.1)),
    Error("bias", "time", ("bias: settling", "bias: time"),
          bias(lambda c, s: np.exp(-c.time / 500), 0.5)),
    Error("bias", "acceleration", ("bias: acceleration x",),
          bias(lambda c, s: along("x")(c, s) * (1 + 0.3 * along("x")(c, s)), 0.1)),
    Error("bias", "acceleration", ("bias: acceleration y times z", "bias: acceleration y"),
          bias(lambda c, s: np.tanh(along("y")(c, s)), 0.1)),
    Error("bias", "rate", (*RATE, "bias: rate cubed"),
          bias(lambda c, s: (c.rate / DEG) ** 3 / (1 + np.abs(c.rate) / DEG / 300), 1e-5)),
    Error("bias", "rate", RATE, bias(lambda c, s: (np.abs(c.rate) / DEG) ** 1.3 / 10, 0.3)),
    Error("pickoff", "wave_angle", ("pick-off: harmonic 3",),
          plant_electrode_error(lambda a, level: triangle(3 * a), 20, True)),
    Error("pickoff", "wave_angle", ("pick-off: harmonic 8",),
          plant_electrode_error(lambda a, level: np.cos(8 * a) * level**1.5, 20, True)),
    Error("drive", "wave_angle", ("drive: harmonic 6",),
          plant_electrode_error(lambda a, level: triangle(6 * a), 100, False)),
    Error("drive", "wave_angle", ("drive gain: harmonic 3",),
          plant_drive_gain(lambda a: triangle(3 * a), 3e-4)),
    Error("readout", "wave_angle", ("angle: harmonic 5",),
          read_angle(lambda log: triangle(5 * log.wave_angle), 5)),
    Error("bench", "table_angle", ("angle: harmonic 3",),
          channel("table_angle", lambda log: triangle(3 * log.table_angle), 5 * ARCSEC)),
    Error("damping", "amplitude", ("amplitude",), damping(1.6, 0.01)),
    Error("stiffness", "temperature", ("temperature",),
          channel("frequency_offset", lambda log: np.expm1(warm(log) / 2), 2e-3 * HZ)),
)  # fmt: skip
NONE = [
    NOMINAL,
    replace(NOMINAL, drive_gain_mismatch=3e-4),
    replace(NOMINAL, pickoff_cubic=2e-4),
    replace(NOMINAL, bias_per_acceleration=2e-8),
    replace(NOMINAL, pickoff_gain_per_kelvin=1e-5),
]


def plan(bench: Bench) -> list[PowerOn]:
    """A test of each kind, about an hour and a half in all."""
    begin = bench.programme
    reference = NOMINAL.reference_temperature
    positions = begin().rest(60)
    for _ in range(7):
        positions.turn(81.2 * DEG, 10 * DEG).rest(60)
    heated = begin(5.0).rest(300).heat(reference + 30, 1200).rest(600)
    sweep = begin(0.2)
    for level in (0.8, 1.0, 1.2):
        sweep.command(amplitude_setpoint=level).spin(5 * DEG, 70)
    tumble = begin()
    for up, across in ((1.0, 0.0), (-1.0, 0.0), *((0.0, 90 * DEG * n) for n in range(4))):
        tumble.attitude(up, across).rest(120)
    turning = [begin().rest(20).command(virtual_rotation=s * DEG).rest(300) for s in (1, -1)]
    warming = 8 * -np.expm1(-np.arange(1801) / 600)
    ride = begin()
    for angle in (90, 180, -90, 360, -180):
        ride.rest(80).turn(angle * DEG, 15 * DEG)
    ride.rest(1800 - ride.time).set_temperatures(reference + warming)
    return [
        PowerOn("still", "static", begin().rest(1200)),
        PowerOn("positions", "positions", positions),
        *(PowerOn(f"slow{s}", "rate", begin(0.2).rest(5).spin(s * 5 * DEG, 70)) for s in (1, -1)),
        *(PowerOn(f"fast{s}", "rate", begin(0.2).rest(5).spin(s * 80 * DEG, 40)) for s in (1, -1)),
        PowerOn("ring", "ring_down", begin().rest(20).command(drive_on=0.0).rest(300)),
        *(PowerOn(f"turning{i}", "virtual_rotation", p) for i, p in enumerate(turning)),
        PowerOn("heat", "thermal", heated.heat(reference - 20, 1800).rest(600)),
        PowerOn("sweep", "amplitude", sweep),
        PowerOn("tumble", "tumble", tumble),
        PowerOn("ride", "manoeuvre", ride),
    ]


def find_main_term(found: Diagnosis, place: str) -> Term | None:
    """The proposed term that removes most; the first where none is verified."""
    return max(found.terms, key=lambda t: (t.shrink_percent or 0.0), default=None)


def main(seed: int) -> None:
    """Print a line a gyro, then the figures."""
    generator = np.random.default_rng(seed)
    plans = plan(Bench(SIMULATION.sampled, NOMINAL))
    right: dict[str, list[bool]] = {"place": [], "coordinate": [], "form": []}
    shrinks, beside = [], 0
    for i, error in enumerate(tqdm(ERRORS, "with")):
        size = float(
            np.exp(generator.uniform(math.log(0.3), math.log(3))) * generator.choice((-1, 1))
        )
        campaign = record_planted(SIMULATION.sampled, error.disturb(size), seed + i, plans)
        found = diagnose(campaign, simulation=SIMULATION).diagnosis
        term = find_main_term(found, error.place)
        own = {
            "place": term is not None and term.place == error.place,
            "coordinate": term is not None and error.coordinate in term.coordinates,
            "form": term is not None and term.function.startswith(error.functions),
        }
        for name, is_right in own.items():
            right[name].append(is_right)
        beside += sum(
            t.place != error.place and error.coordinate not in t.coordinates for t in found.terms
        )
        is_angle = term is None or term.channel == "gyro_angle"
        shrink = found.gap.shrink_percent if is_angle else term.shrink_percent
        if shrink is not None:
            shrinks.append(shrink if found.terms else 0.0)
        names = [
            f"{t.place} {t.function} p={t.probability:.2f}/{len(t.rivals)}" for t in found.terms
        ]
        causes = [c.effect for c in found.causes]
        print(error.place, error.functions[0], f"{size:.2f}", found.verdict, names, causes,
              shrink, flush=True)  # fmt: skip
    false = 0
    for i, device in enumerate(tqdm(NONE * 2, "without")):
        campaign = record_planted(SIMULATION.sampled, Disturbance(), seed + 100 + i, plans, device)
        found = diagnose(campaign, simulation=SIMULATION).diagnosis
        false += bool(found.terms)
        print(i, found.verdict, [c.effect for c in found.causes], [t.function for t in found.terms],
              flush=True)  # fmt: skip
    for name, values in right.items():
        print_share(f"{name} right", sum(values), len(values))
    low, middle = np.quantile(shrinks, (0.25, 0.5)) if shrinks else (math.nan, math.nan)
    print(f"held-out excess shrunk, n = {len(shrinks)}: median {middle:.1f} %, quarter {low:.1f} %")
    print(f"false terms beside a right one: {beside}")
    print_share("a term where there is none", false, 2 * len(NONE))


def print_share(name: str, count: int, n: int) -> None:
    """A share with its exact 95 % interval."""
    interval = binomtest(count, n).proportion_ci()
    print(f"{name}: {count}/{n} ({interval.low:.2f} to {interval.high:.2f})")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1)
