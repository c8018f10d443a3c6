"""Bias under gravity: 8 or 12 positions of the gyro, at four angles of the pattern.

The pattern is turned by virtual rotation, 22.5 deg at a time: the part of the g-dependence that
turns with it averages out, and is told apart. Tilted positions lean towards east: Earth's rate on
the input axis is axis_up W_E sin L.
"""

import math

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.environment import g_sensitivity
from pyhrg.bench.bias.environment.g_sensitivity import SETTLE, Sensitivity
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
"""Each axis up and down: axis_up, and the angle of the x electrodes from the vertical plane."""
EIGHT = (*SIX, (TILT, RIGHT / 2), (-TILT, RIGHT / 2))
TWELVE = (
    *SIX,
    *((TILT, 0.0), (-TILT, 0.0), (TILT, RIGHT), (-TILT, RIGHT)),
    *((0.0, RIGHT / 2), (0.0, 3 * RIGHT / 2)),
)
"""Tilted between each two axes as well: products of specific forces are seen."""
PATTERN_ANGLES = 4
PATTERN_STEP = 22.5 * DEG
TURN = 20.0
"""Time of virtual rotation from one pattern angle to the next, s."""
SEGMENTS = 2


def turn_pattern(course: Programme, bryan_factor: float, angle: float = PATTERN_STEP) -> None:
    """Turn the pattern by virtual rotation, the gyro at rest."""
    course.command(virtual_rotation=angle / bryan_factor / TURN).rest(TURN)
    course.command(virtual_rotation=0.0)


def programme(
    bench: Bench,
    positions: tuple[tuple[float, float], ...] = TWELVE,
    pattern_angles: int = PATTERN_ANGLES,
    segments: int = SEGMENTS,
) -> Programme:
    """One power-on: all positions at each pattern angle."""
    course = bench.programme().rest(WARM_UP)
    for number in range(pattern_angles):
        if number:
            turn_pattern(course, bench.device.bryan_factor)
        for axis_up, across in positions:
            course.attitude(axis_up, across).rest(SETTLE + segments * (SEGMENT + course.interval))
    return course


def record(bench: Bench) -> list[Test]:
    """One power-on, twelve positions."""
    return bench.run([PowerOn("tumble", KIND, programme(bench))])


def evaluate(campaign: Campaign) -> Outcome:
    """Bias, its dependence on specific force, and what the positions can't tell."""
    result = g_sensitivity.measured(campaign, KIND)
    earth = campaign.site.vertical_rate
    return Outcome(
        procedure=PROCEDURE.name,
        findings=result.findings(),
        verdict=_verdict(result),
        warnings=(
            *g_sensitivity.warnings(result),
            "Earth's rate on the input axis goes with specific force along it: a scale-factor "
            f"error of 1 ppm reads as {earth * 1e-6 / DEG_PER_H:.1g} deg/h/g along z",
        ),
        exclusions=g_sensitivity.exclusions(campaign, (KIND,)),
        draw=lambda figure: g_sensitivity.draw(figure, result, "Bias in the tumble"),
        values={"terms": dict(zip(result.fitted.names, result.fitted.values, strict=True))},
    )


def _verdict(result: Sensitivity) -> str:
    linear = [f for f in result.findings() if f.name in ("g bias x", "g bias y", "g bias z")]
    sizes = [abs(f.value) for f in linear if np.isfinite(f.value)]
    if not sizes:
        return "The positions give no sensitivity to specific force."
    clear = [f.name[-1] for f in linear if f.low > 0 or f.high < 0]
    along = f"along {', '.join(clear)}" if clear else "along no axis"
    return (
        f"Bias changes by up to {max(sizes) * STANDARD_GRAVITY / DEG_PER_H:.2g} deg/h/g, "
        f"{result.basis.place}; clear of zero {along}."
    )


PROCEDURE = Procedure(
    name="tumble",
    group="bias",
    title="Bias under gravity (12 positions)",
    rows=("g-dependent bias",),
    source="IEEE Std 1431-2004, multi-position tumble; paper 2.2 and 3.2",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
