"""Tests that may be made next: every kind of the campaign format, as short as it is of use."""

from collections.abc import Callable, Mapping

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Programme
from pyhrg.common.units import DEG, MINUTE

FINE, PLAIN, SLOW = 0.1, 1.0, 10.0
"""Rows, s: where the table turns fast, at rest or slowly, and over hours."""
REST = 20.0
"""Before anything is done, s."""
ANOTHER_ANGLE = 22.5 * DEG
"""Of pattern, a quarter of the fourth harmonic: a bias map that was zero is at its extreme."""
POSITION = 22.5 * DEG
"""Of pattern from one position to the next."""
WARM, COLD = 35.0, -35.0
"""Of the case, against the temperature that the tests begin at, K."""
PHASE = 2e-3
"""Step of the phase offset, rad."""


def candidates(bench: Bench, start_angle: float) -> Mapping[str, list[PowerOn]]:
    """Power-ons by kind.

    Args:
        bench: for the site and the gyro.
        start_angle: of the pattern in the tests that were made, rad.
    """
    elsewhere = start_angle + ANOTHER_ANGLE
    programmes: dict[str, Callable[[Bench], list[Programme]]] = {
        "static": _static,
        "positions": _positions,
        "rate": _rates,
        "ring_down": _ring_down,
        "virtual_rotation": _virtual_rotations,
        "thermal": _thermal,
        "amplitude": _amplitudes,
        "phase_step": _phase_steps,
        "tumble": _tumble,
    }
    return {
        kind: [
            PowerOn(f"{kind}_{number}", kind, programme, elsewhere)
            for number, programme in enumerate(make(bench))
        ]
        for kind, make in programmes.items()
    }


def _static(bench: Bench) -> list[Programme]:
    return [bench.programme(SLOW).rest(60 * MINUTE)]


def _ring_down(bench: Bench) -> list[Programme]:
    return [bench.programme(PLAIN).rest(REST).command(drive_on=0.0).rest(400)]


def _positions(bench: Bench) -> list[Programme]:
    course = bench.programme(PLAIN).rest(5 * MINUTE)
    for _ in range(7):
        course.turn(POSITION / bench.device.bryan_factor, 5 * DEG).rest(5 * MINUTE)
    return [course]


def _rates(bench: Bench) -> list[Programme]:
    """A full turn of the pattern and more, at each rate."""
    rates = [sign * rate for rate in (5 * DEG, 100 * DEG) for sign in (1, -1)]
    lasting = {5 * DEG: 130.0, 100 * DEG: 40.0}
    return [
        bench.programme(FINE).rest(REST / 2).spin(rate, lasting[abs(rate)] - 1).rest(1)
        for rate in rates
    ]


def _virtual_rotations(bench: Bench) -> list[Programme]:
    return [
        bench.programme(PLAIN).rest(REST).command(virtual_rotation=sign * DEG).rest(480)
        for sign in (1, -1)
    ]


def _thermal(bench: Bench) -> list[Programme]:
    begin = bench.device.reference_temperature
    course = bench.programme(SLOW).rest(10 * MINUTE)
    course.heat(begin + WARM, 30 * MINUTE).heat(begin + WARM, 30 * MINUTE)
    return [course.heat(begin + COLD, 60 * MINUTE).heat(begin + COLD, 30 * MINUTE)]


def _amplitudes(bench: Bench) -> list[Programme]:
    """A turn of the pattern at each amplitude."""
    course = bench.programme(FINE)
    for share in (0.8, 1.0, 1.2):
        course.command(amplitude_setpoint=share * bench.device.amplitude).spin(5 * DEG, 80)
    return [course]


def _phase_steps(bench: Bench) -> list[Programme]:
    course = bench.programme(PLAIN)
    for phase in (0.0, PHASE, 0.0, -PHASE):
        course.command(phase_offset=phase).rest(400)
    return [course]


def _tumble(bench: Bench) -> list[Programme]:
    course = bench.programme(PLAIN)
    for up, across in ((1.0, 0.0), (-1.0, 0.0), *((0.0, 90 * DEG * n) for n in range(4))):
        course.attitude(up, across).rest(400)
    return [course]
