"""Steps of the demodulation phase: the bias that a frequency split makes of a phase error.

The quadrature force N = (dw/2) a sin 4(th - th_w) leaks into the rotation by the phase error p plus
the commanded offset: the output has -(p + offset) N/(2 k a). The steps give the slope against the
offset, to be held to the force itself. The phase error alone can't be had at rest: over the
circumference p N is a fourth harmonic like every other.
"""

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.estimation.row_fit import Part
from pyhrg.bench.figures import COLOURS, finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings import output_rows
from pyhrg.bench.readings.output_rows import Rows, Terms
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.campaign import Campaign, Test

KIND = "phase_step"
OFFSETS = (0.0, 2e-3, -2e-3, 0.0)
DWELL = 100.0
REST = 10.0
ANGLES = (0.0, 11.25 * DEG)
"""Pattern angles from power-on, rad: where one shows nothing of the split, the other shows all."""
TABLE_RATE = 10 * DEG
RESPONSE = "response to phase"
REASON = "at least two phase offsets at one position, over a quadrature force that is not zero"


def make_programme(bench: Bench, dwell: float = DWELL) -> Programme:
    """One power-on: the offsets one after the other, at each angle."""
    course = bench.programme().rest(REST)
    for before, angle in zip((0.0, *ANGLES), ANGLES, strict=False):
        if angle != before:
            course.turn((angle - before) / bench.device.bryan_factor, TABLE_RATE)
        for offset in OFFSETS:
            course.command(phase_offset=offset).rest(dwell)
    return course


def record(bench: Bench, dwell: float = DWELL) -> list[Test]:
    return bench.run([PowerOn("phase_step", KIND, make_programme(bench, dwell))])


def fit_response(campaign: Campaign) -> tuple[Terms, list[Rows]]:
    """Response over the expected one, with the bias and its creep at each position."""
    logs = [test.log for test in require_tests(campaign, KIND)]
    stretches = output_rows.require_steady_rows(logs, "quadrature_force", at_rest=True)
    k = output_rows.read_bryan_factor(campaign)
    places: dict[tuple[str, int], list[Rows]] = {}
    for rows in stretches:
        place = (rows.log.source, round(float(rows.values("table_angle")[0]) / (0.1 * DEG)))
        places.setdefault(place, []).append(rows)
    names, parts, ordered = [RESPONSE], [], []
    for number, group in enumerate(places.values()):
        names[:-1] = [*names[:-1], f"bias {number}", f"creep {number}"]
        middle = float(np.mean([np.mean(rows.values("wave_angle")) for rows in group]))
        for rows in group:
            h = rows.log.interval
            turned = rows.values("wave_angle") - middle
            columns = {
                f"bias {number}": np.full(len(rows), h),
                f"creep {number}": h * turned,
                RESPONSE: -h * rows.values("phase_offset") * _force(rows) / (2 * k),
            }
            parts.append(output_rows.make_output_part(rows, campaign.site, columns))
            ordered.append(rows)
    offsets = {float(offset) for rows in stretches for offset in rows.values("phase_offset")[:1]}
    if len(offsets) < 2:
        raise BenchError(f"{logs[0].source}: {len(offsets)} phase offset; the test needs 2")
    terms = output_rows.fit_terms(parts, names, REASON)
    return terms, ordered


def _force(rows: Rows) -> Array:
    """(n,) quadrature force over amplitude, a line in time as the pattern creeps: its noise is not
    a regressor."""
    ratio = rows.values("quadrature_force") / rows.values("amplitude_setpoint")
    time = np.linspace(-1.0, 1.0, len(rows))
    return np.asarray(np.mean(ratio) + time * (time @ ratio) / (time @ time))


def _mean_force(rows: Rows) -> float:
    return float(np.mean(_force(rows)))


def _find_place(part: Part) -> str:
    """Name of the bias at the position of a part."""
    return next(name for name in part.columns if name.startswith("bias"))


def evaluate(campaign: Campaign) -> Outcome:
    """Response, the split that it sees, and the phase at which the bias would vanish."""
    terms, stretches = fit_response(campaign)
    force = 2 * max(map(_mean_force, stretches), key=abs)
    seen = terms.finding(RESPONSE, "mHz", "frequency split in the bias, times sin 4th", force)
    return Outcome(
        findings=(
            terms.finding(RESPONSE, "1", "response to phase over that of the quadrature force"),
            seen,
            Finding("frequency split in the quadrature force, times sin 4th", force, "mHz"),
            _apparent_phase(terms, stretches, output_rows.read_bryan_factor(campaign)),
        ),
        verdict=(
            "A phase error makes bias of the split as the quadrature force says where the response "
            "is 1. How large the phase error is, no test at rest can say by itself."
        ),
        warnings=tuple(terms.refused.values()),
        draw=lambda figure: draw(figure, terms, stretches),
    )


def _apparent_phase(terms: Terms, stretches: list[Rows], k: float) -> Finding:
    """Phase error that would make the whole bias, at the position of the largest mean force."""
    name = "phase error if the split alone made the bias"
    if RESPONSE in terms.refused:
        return Finding(name, np.nan, "mrad", note=terms.refused[RESPONSE])
    forces: dict[str, list[float]] = {}
    for part, rows in zip(terms.parts, stretches, strict=True):
        forces.setdefault(_find_place(part), []).append(_mean_force(rows))
    bias = max(forces, key=lambda place: abs(float(np.mean(forces[place]))))
    factor = -2 * k / float(np.mean(forces[bias]))
    return terms.finding(bias, "mrad", name, factor)


def draw(figure: Figure, terms: Terms, stretches: list[Rows]) -> None:
    """Mean output rate of each step over the offset, less the creep, a line per position."""
    axes = figure.add_subplot(title="Bias against the demodulation phase, with the fit")
    groups: dict[str, list[tuple[float, float, float]]] = {}
    for part, rows in zip(terms.parts, stretches, strict=True):
        span = len(part) * part.interval
        sums = {
            n: terms.fit.value(n) * float(np.sum(part.columns[n]))
            for n in terms.fit.names
            if n in part.columns
        }
        creep = sum(value for name, value in sums.items() if name.startswith("creep"))
        rate = (float(np.sum(part.values)) - creep) / span
        model = sum(sums.values()) - creep
        groups.setdefault(_find_place(part), []).append(
            (rows.values("phase_offset")[0], rate, model / span)
        )
    for (place, points), colour in zip(groups.items(), COLOURS, strict=False):
        offset, rate, model = np.array(sorted(points)).T
        number = int(place.split()[1]) + 1
        axes.plot(offset * 1e3, rate / DEG_PER_H, "o", color=colour, label=f"position {number}")
        axes.plot(offset * 1e3, model / DEG_PER_H, "-", color=colour, lw=0.8)
    finish_axes(axes, "phase offset, mrad", "output rate error, deg/h")


PROCEDURE: Procedure = Procedure(
    name="phase-step",
    group="identification",
    title="Steps of the demodulation phase: split times phase error",
    source="Lynch 1995, averaged equations with a force phase error; campaign format, phase_step",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
