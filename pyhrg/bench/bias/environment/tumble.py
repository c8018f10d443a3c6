"""Bias under gravity: twelve positions of the gyro at four pattern angles.

Virtual rotation turns the pattern by 22.5 deg from one pattern angle to the next, which separates
the constant part of the g-sensitivity from its fourth harmonic. Positions are tilted towards east,
so that Earth's rate on the input axis is axis_up W_E sin L.
"""

import math
from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.environment.g_sensitivity import (
    SETTLE,
    Sensitivity,
    fit_sensitivity,
    make_outcome,
)
from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP
from pyhrg.common.units import DEG, DEG_PER_H, STANDARD_GRAVITY
from pyhrg.records.campaign import Campaign, Test

KIND = "tumble"
TILT = math.sqrt(0.5)
RIGHT = math.pi / 2
SIX = ((1.0, 0.0), (-1.0, 0.0), (0.0, 0.0), (0.0, 2 * RIGHT), (0.0, RIGHT), (0.0, -RIGHT))
"""Each axis up and down: `axis_up` and the angle `across` of `Programme.attitude`."""
TWELVE = (
    *SIX,
    *((TILT, 0.0), (-TILT, 0.0), (TILT, RIGHT), (-TILT, RIGHT)),
    *((0.0, RIGHT / 2), (0.0, 3 * RIGHT / 2)),
)
"""The six and six more, tilted between two axes, which show products of specific forces."""
PATTERN_ANGLES = 4
PATTERN_STEP = 22.5 * DEG
TURN = 20.0
"""Duration of the virtual rotation from one pattern angle to the next, s."""
SEGMENTS = 2


def turn_pattern(course: Programme, bryan_factor: float) -> None:
    """Append a virtual rotation of the pattern by a step, with the gyro at rest."""
    course.command(virtual_rotation=PATTERN_STEP / bryan_factor / TURN).rest(TURN)
    course.command(virtual_rotation=0.0)


def make_programme(
    bench: Bench,
    positions: tuple[tuple[float, float], ...] = TWELVE,
    pattern_angles: int = PATTERN_ANGLES,
    segments: int = SEGMENTS,
) -> Programme:
    """Programme of one power-on: at each pattern angle, all positions."""
    course = bench.programme().rest(WARM_UP)
    for number in range(pattern_angles):
        if number:
            turn_pattern(course, bench.device.bryan_factor)
        for axis_up, across in positions:
            course.attitude(axis_up, across).rest(SETTLE + segments * (SEGMENT + course.interval))
    return course


def record(bench: Bench) -> list[Test]:
    return bench.run([PowerOn("tumble", KIND, make_programme(bench))])


def evaluate(campaign: Campaign) -> Outcome:
    """Bias and its sensitivity to specific force."""
    result = fit_sensitivity(campaign, KIND)
    outcome = make_outcome(result, "Bias in the tumble", _describe_verdict(result))
    warning = (
        "Earth's rate on the input axis is proportional to specific force along it: a scale-factor "
        f"error of 1 ppm reads as {campaign.site.vertical_rate * 1e-6 / DEG_PER_H:.1g} deg/h/g "
        "along z"
    )
    return replace(outcome, warnings=(*outcome.warnings, warning))


def _describe_verdict(result: Sensitivity) -> str:
    linear = [f for f in result.findings() if f.name in ("g bias x", "g bias y", "g bias z")]
    sizes = [abs(f.si_value) for f in linear if np.isfinite(f.si_value)]
    if not sizes:
        return "The positions give no sensitivity to specific force."
    significant = [f.name[-1] for f in linear if f.si_low > 0 or f.si_high < 0]
    along = f"along {', '.join(significant)}" if significant else "along no axis"
    return (
        f"Bias changes by up to {max(sizes) * STANDARD_GRAVITY / DEG_PER_H:.2g} deg/h/g, "
        f"{result.basis.place}; significantly {along}."
    )


PROCEDURE: Procedure = Procedure(
    name="tumble",
    group="bias",
    title="Bias under gravity (12 positions)",
    source="IEEE Std 1431-2004, multi-position tumble; paper 2.2 and 3.2",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
