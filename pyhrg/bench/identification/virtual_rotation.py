"""Virtual rotation in both directions: errors of the drives, seen in a commanded rotation.

A commanded rotation V (input-referred) shows in the output as V (-e + (g + gd)/2 cos 4th + (d +
nd)/2 sin 4th): gain error e, and mismatches of pick-offs and drives together. It changes its sign
with V, the bias map does not.
"""

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.identification.identification_figure import draw_terms
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings import output_rows
from pyhrg.bench.readings.output_rows import BIAS_TERMS, Rows
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

KIND = "virtual_rotation"
RATE = 1 * DEG
REST = 10.0
GAIN = "virtual rotation"
WAVES = COSINE, SINE = ("virtual rotation cos4", "virtual rotation sin4")
WAYS = {"pos": 1.0, "neg": -1.0}
"""Sign of the rotation, by the name of its power-on."""
REASON = "the pattern must be turned both ways, each over most of 90 deg"


def make_programme(bench: Bench, rate: float, pattern_turn: float = 180 * DEG) -> Programme:
    """One power-on: table at rest, axis up, the pattern turned by the drives."""
    course = bench.programme().rest(REST).command(virtual_rotation=rate)
    return course.rest(float(np.ceil(pattern_turn / (bench.device.bryan_factor * abs(rate)))))


def record(bench: Bench, rate: float = RATE, pattern_turn: float = 180 * DEG) -> list[Test]:
    """One power-on each way."""
    courses = {w: make_programme(bench, sign * rate, pattern_turn) for w, sign in WAYS.items()}
    return bench.run([PowerOn(f"virtual_rotation_{w}", KIND, c) for w, c in courses.items()])


def make_columns(rows: Rows) -> dict[str, Array]:
    """Terms of the output, rad."""
    turned = rows.values("virtual_rotation") * rows.log.interval
    waves = (turned * rows.mean_trig(trig, 4) for trig in (np.cos, np.sin))
    return {
        **output_rows.make_bias_columns(rows),
        GAIN: turned,
        **dict(zip(WAVES, waves, strict=True)),
    }


def evaluate(campaign: Campaign) -> Outcome:
    """Gain error, sums of mismatches, and the bias map that they are separated from."""
    tests = require_tests(campaign, KIND)
    stretches = output_rows.require_steady_rows([test.log for test in tests])
    parts = [
        output_rows.make_output_part(rows, campaign.site, make_columns(rows)) for rows in stretches
    ]
    terms = output_rows.fit_terms(parts, [*BIAS_TERMS, GAIN, *WAVES], REASON)
    labels = [f"V = {rows.values('virtual_rotation')[0] / DEG:+.3g} deg/s" for rows in stretches]
    title = "Output under virtual rotation, less Earth's rate"
    if GAIN in terms.refused:
        names = ", ".join(test.log.source for test in tests)
        raise BenchError(f"{names}: {terms.refused[GAIN]}; else it is taken for a bias")
    return Outcome(
        findings=(
            terms.finding(GAIN, "ppm", "virtual rotation gain error", -1.0),
            terms.finding(COSINE, "ppm", "gain mismatch of pick-offs and drives", 2.0),
            terms.finding(SINE, "ppm", "non-orthogonality of pick-offs and drives", 2.0),
            *(terms.finding(name, "deg/h") for name in BIAS_TERMS),
        ),
        verdict=(
            "Virtual rotation gives g + gd and d + nd without the damping anisotropy that a static "
            "test mixes them with; the pick-offs' own share is in the rate test."
        ),
        warnings=tuple(terms.refused.values()),
        draw=lambda figure: draw_terms(figure, title, stretches, terms, labels),
        values={"terms": terms.fit.terms},
    )


PROCEDURE: Procedure = Procedure(
    name="virtual-rotation",
    group="identification",
    title="Virtual rotation both ways: gain error, mismatch of the drives",
    source="campaign format, virtual rotation; output to first order: output_rows",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
