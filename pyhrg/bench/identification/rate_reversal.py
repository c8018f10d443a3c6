"""Table rate in both directions: errors of the pick-offs reverse with the rate, the bias does not.

A gain mismatch g and a non-orthogonality d turn the detected angle by -(g/4) sin 4th + (d/4)(1 +
cos 4th), so that the output errs by -g W cos 4th - d W sin 4th at a rate W; a cubic b and a
differential phase with a split give the eighth harmonic. Drives and damping do not: they give the
bias map, the same at either rate.
"""

from collections.abc import Sequence

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.identification.identification_figure import draw_terms
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.readings import output_rows
from pyhrg.bench.readings.output_rows import BIAS_TERMS, Rows, Terms
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

KIND = "rate"
RATES = (5 * DEG, -5 * DEG)
FASTEST = 20 * DEG
"""Rate up to which the loops follow the fourth harmonic: 0.4 rad/s, theirs are 6 rad/s."""
INTERVAL = 0.1
DURATION = 140.0
SCALE, GAIN, SKEW = "scale factor error", "pick-off gain mismatch", "pick-off non-orthogonality"
EIGHTH = ("pick-off cos8", "pick-off sin8")
REASON = "the table must turn both ways, each over most of 90 deg of pattern"


def record(bench: Bench, rates: Sequence[float] = RATES, duration: float = DURATION) -> list[Test]:
    """One power-on a rate."""
    names = [f"rate_{abs(rate) / DEG:g}dps_{'pos' if rate > 0 else 'neg'}" for rate in rates]
    courses = [bench.programme(INTERVAL).spin(rate, duration) for rate in rates]
    return bench.run([PowerOn(n, KIND, course) for n, course in zip(names, courses, strict=True)])


def make_pickoff_columns(rows: Rows, k: float) -> dict[str, Array]:
    """Angle errors of the pick-offs in the output, rad."""
    angle = rows.ends("wave_angle")
    return {
        SCALE: rows.increments("table_angle"),
        GAIN: np.diff(np.sin(4 * angle)) / (4 * k),
        SKEW: -np.diff(np.cos(4 * angle)) / (4 * k),
        EIGHTH[0]: np.diff(np.cos(8 * angle)) / k,
        EIGHTH[1]: np.diff(np.sin(8 * angle)) / k,
    }


def fit_pickoff_errors(campaign: Campaign) -> Terms:
    """Bias map, scale factor and pick-off errors from all rates together."""
    k = output_rows.read_bryan_factor(campaign)
    parts = [
        output_rows.make_output_part(
            rows, campaign.site, output_rows.make_bias_columns(rows) | make_pickoff_columns(rows, k)
        )
        for rows in select_slow_rows(campaign)[0]
    ]
    return output_rows.fit_terms(parts, [*BIAS_TERMS, SCALE, GAIN, SKEW, *EIGHTH], REASON)


def select_slow_rows(campaign: Campaign) -> tuple[list[Rows], tuple[str, ...]]:
    """Steady rows that loops follow, and a sentence on each faster stretch."""
    stretches = output_rows.require_steady_rows(
        [test.log for test in require_tests(campaign, KIND)]
    )
    fast = [rows for rows in stretches if abs(_rate(rows)) > FASTEST]
    left_out = tuple(
        f"{rows.log.source}: {_rate(rows) / DEG:.3g} deg/s left out: above {FASTEST / DEG:g} deg/s "
        "loops that lag add to what pick-offs do"
        for rows in fast
    )
    if len(fast) == len(stretches):
        raise BenchError("; ".join(left_out))
    return [rows for rows in stretches if abs(_rate(rows)) <= FASTEST], left_out


def _rate(rows: Rows) -> float:
    return float(np.mean(rows.increments("table_angle"))) / rows.log.interval


def find_eighth_harmonic(terms: Terms) -> tuple[Finding, ...]:
    """Eighth harmonic of the detected angle: a cubic of the pick-offs, and 0.004 arcsec by a split
    of 0.5 mHz that the quadrature loop follows late."""
    return tuple(
        terms.finding(name, "arcsec", f"{name.removeprefix('pick-off ')} of the angle", -1.0)
        for name in EIGHTH
    )


def evaluate(campaign: Campaign) -> Outcome:
    """Pick-off errors, the scale factor, and the bias map that they are separated from."""
    terms = fit_pickoff_errors(campaign)
    stretches, left_out = select_slow_rows(campaign)
    labels = [f"{_rate(rows) / DEG:+.3g} deg/s" for rows in stretches]
    title = "Output less table and Earth's rate"
    if SCALE in terms.refused:
        names = ", ".join(test.log.source for test in require_tests(campaign, KIND))
        raise BenchError(f"{names}: {terms.refused[SCALE]}; else it is taken for a bias")
    return Outcome(
        findings=(
            *(terms.finding(name, "ppm") for name in (GAIN, SKEW, SCALE)),
            *find_eighth_harmonic(terms),
            *(terms.finding(name, "deg/h") for name in BIAS_TERMS),
        ),
        verdict=(
            "What reverses with the rate is the pick-offs'; what does not is the bias map, of "
            "which this test can't say whether damping, drives or pick-offs make it."
        ),
        warnings=tuple(terms.refused.values()),
        exclusions=tuple(left_out),
        draw=lambda figure: draw_terms(figure, title, stretches, terms, labels),
        values={"terms": terms.fit.terms},
    )


PROCEDURE: Procedure = Procedure(
    name="rate-reversal",
    group="identification",
    title="Table rate both ways: errors of the pick-offs",
    source="paper Eq. (2)-(3), with harmonics and signs as derived in output_rows",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
