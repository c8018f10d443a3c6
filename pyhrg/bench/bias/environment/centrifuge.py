"""Bias under large constant specific force: its linear and quadratic coefficients.

The input axis is perpendicular to the axis of the arm, so that it doesn't sense the arm's rotation;
Earth's rate on it averages out over the turns of the arm. Each axis in turn points along the arm,
in both directions.
"""

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.environment.g_sensitivity import AXES, SETTLE, fit_sensitivity, make_outcome
from pyhrg.bench.bias.environment.tumble import PATTERN_ANGLES, turn_pattern
from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.records.campaign import Campaign, Test

KIND = "centrifuge"
LEVELS = (-50.0, -25.0, -10.0, 10.0, 25.0, 50.0)
"""Specific forces along the arm, g."""
UPRIGHT = {"x": "y", "y": "x", "z": "x"}
"""Axis that gravity acts along, by the axis that points along the arm."""


def make_programme(
    bench: Bench,
    levels: tuple[float, ...] = LEVELS,
    pattern_angles: int = PATTERN_ANGLES,
    segments: int = 1,
) -> Programme:
    """Programme of one power-on: at each pattern angle, every axis along the arm at every level."""
    course = bench.programme().attitude(0.0).rest(WARM_UP)
    for number in range(pattern_angles):
        if number:
            turn_pattern(course, bench.device.bryan_factor)
        for axis in AXES:
            for level in levels:
                forces = dict.fromkeys(AXES, 0.0)
                forces |= {UPRIGHT[axis]: bench.device.site.gravity, axis: level * STANDARD_GRAVITY}
                course.command(**{f"acceleration_{name}": a for name, a in forces.items()})
                course.rest(SETTLE + segments * (SEGMENT + course.interval))
    return course


def record(bench: Bench) -> list[Test]:
    return bench.run([PowerOn("centrifuge", KIND, make_programme(bench))])


def evaluate(campaign: Campaign) -> Outcome:
    """Linear and quadratic coefficients of the bias against specific force."""
    result = fit_sensitivity(campaign, KIND)
    size = np.max(np.abs(result.points.acceleration)) / STANDARD_GRAVITY
    columns = {n: c for n, c in result.columns.items() if n.startswith("g ")}
    share = sum(result.fitted.value(n) * c for n, c in columns.items())
    worst = float(np.max(np.abs(share)) / DEG_PER_H) if columns else np.nan
    verdict = f"Specific force of up to {size:.3g} g moves the bias by up to {worst:.2g} deg/h."
    return make_outcome(result, "Bias on the centrifuge", verdict)


PROCEDURE: Procedure = Procedure(
    name="centrifuge",
    group="bias",
    title="Bias on the centrifuge",
    source="paper 3.2 (centrifuge test and model); IEEE Std 1431-2004",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
