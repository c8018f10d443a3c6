"""Forces and frequency of the loops over the pattern angle: frequency split and its axis.

With the loops closed the quadrature force balances the split, (dw/2) a sin 4(th - th_w), and the
loop frequency follows it, -(dw/2) cos 4(th - th_w). The amplitude force holds 1/tau + (D/2) cos
4(th - th_tau) - ((g + gd)/2 tau) cos 4th - ((d + nd)/2 tau) sin 4th: the same sum as in the bias
map, so that it gives the decay time, and no cause.
"""

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.estimation.row_fit import Part
from pyhrg.bench.estimation.sizes import estimate_anisotropy, make_component_findings
from pyhrg.bench.figures import COLOURS, finish_axes
from pyhrg.bench.identification.virtual_rotation import WAYS, make_programme
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.readings.output_rows import Rows, Terms, fit_terms, require_steady_rows
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

KIND = "force_map"
RATE = 0.5 * DEG
"""Virtual rotation, rad/s: slow enough for the loops to follow."""
KINDS = (KIND, "positions", "virtual_rotation")
MEAN = "mean"
VECTOR = ("cosine", "sine")
SQUARED = "by rotation squared"
DISTURBING = (*("by rotation", "by rotation cos4", "by rotation sin4", "cos8", "sin8"), SQUARED)
"""What errors of the electrodes add, odd in a virtual rotation or of second order; and what forces
held over a control period Ts do to the amplitude by moving on a tangent: (2 k V)^2 Ts/2."""
REASON = "the pattern must come to angles over most of 90 deg"


def record(bench: Bench, rate: float = RATE, pattern_turn: float = 180 * DEG) -> list[Test]:
    """One power-on each way, the pattern turned by virtual rotation."""
    courses = {way: make_programme(bench, s * rate, pattern_turn) for way, s in WAYS.items()}
    return bench.run([PowerOn(f"force_map_{way}", KIND, c) for way, c in courses.items()])


SENSITIVITIES: dict[str, Callable[[Array, Array], tuple[Array, Array]]] = {
    "quadrature_force": lambda cosine, sine: (sine / 2, -cosine / 2),
    "frequency_offset": lambda cosine, sine: (-cosine / 2, -sine / 2),
    "amplitude_force": lambda cosine, sine: (cosine / 2, sine / 2),
}
"""Sensitivity of a loop's column, the quadrature force over amplitude, to the anisotropy's cosine
and sine part (of the split, the split and the damping), from cos 4th and sin 4th."""


def fit_loop_map(campaign: Campaign, column: str) -> Terms:
    """Mean and anisotropy of a loop's column over all angles; each power-on has its own mean
    frequency and drift (temperature moves it by 85 ppm/K)."""
    tests = {test.log.source: test.log for test in require_tests(campaign, *KINDS)}
    stretches = require_steady_rows(list(tests.values()), column, at_rest=True)
    own = column == "frequency_offset"
    names, parts = dict[str, int](), []
    for rows in stretches:
        number = list(tests).index(rows.log.source)
        means = {f"{MEAN} {number}": 0, f"drift {number}": 1} if own else {MEAN: 0}
        names |= means
        parts.append(_part(rows, column, means))
    constant, drifts = ([name for name, power in names.items() if power == p] for p in (0, 1))
    terms = fit_terms(parts, [*constant, *VECTOR, *drifts, *DISTURBING], REASON)
    if not set(VECTOR) <= set(terms.fit.names):
        raise BenchError(f"{', '.join(tests)}: {column}: {REASON}")
    return terms


def _part(rows: Rows, column: str, means: dict[str, int]) -> Part:
    h, values = rows.log.interval, rows.values(column)
    if column == "quadrature_force":
        values = values / rows.values("amplitude_setpoint")
    c4, s4, c8, s8 = (rows.mean_trig(trig, n) for n in (4, 8) for trig in (np.cos, np.sin))
    turned = rows.values("virtual_rotation")
    odd = dict(zip(DISTURBING, (turned, turned * c4, turned * s4, c8, s8, turned**2), strict=True))
    elapsed = (rows.values("time") - rows.log.time[-1] / 2) / rows.log.time[-1]
    columns = {name: elapsed**power for name, power in means.items()} | odd
    columns |= zip(VECTOR, SENSITIVITIES[column](c4, s4), strict=True)
    return Part({name: h * values for name, values in columns.items()}, h * values, h)


def evaluate(campaign: Campaign) -> Outcome:
    """Split and axis twice over, the decay time, and the amplitude force's own anisotropy."""
    force, frequency, amplitude = (fit_loop_map(campaign, column) for column in SENSITIVITIES)
    names = ("frequency split", "stiffness axis")
    again = ("frequency split from loop frequency", "stiffness axis from loop frequency")
    apparent = ("apparent damping anisotropy", "apparent damping axis")
    return Outcome(
        findings=(
            *estimate_anisotropy(force.fit, VECTOR, *names, "mHz"),
            *make_component_findings(force.fit, VECTOR, names[0], "mHz"),
            *estimate_anisotropy(frequency.fit, VECTOR, *again, "mHz"),
            _decay_time(amplitude),
            *estimate_anisotropy(amplitude.fit, VECTOR, *apparent, "1/s"),
        ),
        verdict=(
            "Quadrature force and loop frequency give the split and its axis (against the "
            "pick-offs' axes), to first order in the errors of pick-offs and drives; the amplitude "
            "force gives the sum of damping and electrodes alone."
        ),
        draw=lambda figure: draw(figure, [force, frequency]),
        values={"terms": force.fit.terms},
    )


def _decay_time(amplitude: Terms) -> Finding:
    rate, (low, high) = amplitude.fit.value(MEAN), amplitude.fit.interval(MEAN)
    turned = any(np.any(part.columns[SQUARED]) for part in amplitude.parts)
    note = "with (2 k V)^2 Ts/2 in 1/tau" if turned and SQUARED in amplitude.refused else ""
    n = len(amplitude.fit.residual)
    return Finding("decay time", 1 / rate, "s", 1 / high, 1 / low, n, note)


def draw(figure: Figure, maps: Sequence[Terms]) -> None:
    """Both channels over the angle, in mHz of split, means and other terms taken out."""
    axes = figure.add_subplot(title="Frequency split in the loops", xlim=(0, 90))
    labels = ("2 quadrature force / amplitude", "2 loop frequency")
    for terms, label, colour in zip(maps, labels, COLOURS, strict=False):
        for number, part in enumerate(terms.parts):
            cosine, sine = (np.asarray(part.columns[name]) / part.interval for name in VECTOR)
            angle = np.arctan2(*((sine, cosine) if label is labels[1] else (cosine, -sine)))
            angle = (angle / 4 + (np.pi / 4 if label is labels[1] else 0.0)) % (np.pi / 2)
            others = [name for name in terms.fit.names if name not in VECTOR]
            rest = sum(terms.fit.value(n) * part.columns[n] for n in others if n in part.columns)
            shown = 2 * (part.values - rest) / part.interval / (2e-3 * np.pi)
            size = max(1, len(shown) // 60)
            count = len(shown) // size * size
            mean = shown[:count].reshape(-1, size).mean(axis=1)
            middle = angle[size // 2 : count : size]
            axes.plot(
                middle / DEG, mean, ".", ms=4, color=colour, label=label if not number else None
            )
    finish_axes(axes, "pattern angle modulo 90 deg, deg", "2 x loop's reaction to the split, mHz")


PROCEDURE: Procedure = Procedure(
    name="force-map",
    group="identification",
    title="Loop forces and frequency over the pattern angle: frequency split",
    source="Lynch 1995, averaged equations at rest; campaign format, columns",
    kinds=KINDS,
    record=record,
    evaluate=evaluate,
)
