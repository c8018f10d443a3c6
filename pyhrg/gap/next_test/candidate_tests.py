"""Candidates for the next test: one of every kind of the campaign format, as short as is useful.

Durations, rates and angles are chosen so that each test excites what its kind is made for.
"""

from collections.abc import Mapping

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Programme
from pyhrg.common.units import DEG, MINUTE

FAST_ROWS, ROWS, LONG_ROWS = 0.1, 1.0, 10.0
"""Length of a row, s: in fast rotation, at rest or in slow rotation, and over hours."""
INITIAL_REST = 20.0
"""Rest before the first action, s."""
START_ANGLE_SHIFT = 22.5 * DEG
"""Pattern angle at power-on, relative to the tests made so far. Derived: a quarter period of the
fourth harmonic, so that a bias map which was zero there is at its extreme."""
POSITION_STEP = 22.5 * DEG
"""Pattern angle from one position to the next: eight positions are half a turn of the pattern, two
periods of the fourth harmonic."""
WARM, COLD = 35.0, -35.0
"""Extreme case temperatures, relative to the initial one, K."""
PHASE_STEP = 2e-3
"""Step of the phase offset, rad."""


def list_candidates(bench: Bench, start_angle: float) -> Mapping[str, list[PowerOn]]:
    """Power-ons of the candidate of each kind, for the bench's site and gyro; the start angle, rad,
    is that of the tests made so far."""
    programmes = {
        "static": [bench.programme(LONG_ROWS).rest(60 * MINUTE)],
        "positions": _plan_positions(bench),
        "rate": _plan_rates(bench),
        "ring_down": [
            bench.programme(ROWS).rest(INITIAL_REST).command(drive_on=0.0).rest(400),
        ],
        "virtual_rotation": [
            bench.programme(ROWS).rest(INITIAL_REST).command(virtual_rotation=sign * DEG).rest(480)
            for sign in (1, -1)
        ],
        "thermal": _plan_thermal(bench),
        "amplitude": _plan_amplitudes(bench),
        "phase_step": _plan_phase_steps(bench),
        "tumble": _plan_tumble(bench),
    }
    return {
        kind: [
            PowerOn(f"{kind}_{number}", kind, programme, start_angle + START_ANGLE_SHIFT)
            for number, programme in enumerate(own)
        ]
        for kind, own in programmes.items()
    }


def _plan_positions(bench: Bench) -> list[Programme]:
    course = bench.programme(ROWS).rest(5 * MINUTE)
    for _ in range(7):
        course.turn(POSITION_STEP / bench.device.bryan_factor, 5 * DEG).rest(5 * MINUTE)
    return [course]


def _plan_rates(bench: Bench) -> list[Programme]:
    """At least a full turn of the pattern at each rate."""
    rates = [sign * rate for rate in (5 * DEG, 100 * DEG) for sign in (1, -1)]
    lasting = {5 * DEG: 130.0, 100 * DEG: 40.0}
    return [
        bench.programme(FAST_ROWS).rest(INITIAL_REST / 2).spin(rate, lasting[abs(rate)] - 1).rest(1)
        for rate in rates
    ]


def _plan_thermal(bench: Bench) -> list[Programme]:
    begin = bench.device.reference_temperature
    course = bench.programme(LONG_ROWS).rest(10 * MINUTE)
    course.heat(begin + WARM, 30 * MINUTE).heat(begin + WARM, 30 * MINUTE)
    return [course.heat(begin + COLD, 60 * MINUTE).heat(begin + COLD, 30 * MINUTE)]


def _plan_amplitudes(bench: Bench) -> list[Programme]:
    """A full turn of the pattern at each amplitude."""
    course = bench.programme(FAST_ROWS)
    for share in (0.8, 1.0, 1.2):
        course.command(amplitude_setpoint=share * bench.device.amplitude).spin(5 * DEG, 80)
    return [course]


def _plan_phase_steps(bench: Bench) -> list[Programme]:
    course = bench.programme(ROWS)
    for phase in (0.0, PHASE_STEP, 0.0, -PHASE_STEP):
        course.command(phase_offset=phase).rest(400)
    return [course]


def _plan_tumble(bench: Bench) -> list[Programme]:
    course = bench.programme(ROWS)
    for up, across in ((1.0, 0.0), (-1.0, 0.0), *((0.0, 90 * DEG * n) for n in range(4))):
        course.attitude(up, across).rest(400)
    return [course]
