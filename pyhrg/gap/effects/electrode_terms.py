"""Columns of candidate terms of pick-off and drive.

An error of the electrodes shows in more than one way: the forces of the loops follow what the
pick-off shows, and a force is as wrong as the drive (docs/methods/effects.md, Eqs. 5a, 5b, 5d and
5h).
"""

from collections.abc import Callable, Iterator, Sequence
from functools import partial

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm, make_term
from pyhrg.gap.effects.coordinates import (
    PATTERN_HARMONICS,
    SETTLING_FACTORS,
    SPECIFIC_FORCES,
    Coordinates,
    average_rows,
    name_harmonic,
    turn_harmonic,
)
from pyhrg.gap.replay.loop_response import compute_loop_force

Respond = Callable[[Array], Array]
"""What a place makes of the values of basis functions: linear."""
PlacedTerm = tuple[CandidateTerm, Array, Respond]
"""A term, the (n, b) values of its basis functions, and what its place makes of these."""

LINEAR_HARMONICS = (2, 4)
"""Harmonics of pick-offs' linear errors: offset, and gain or axis. Derived."""
ELECTRODE_HARMONICS = [m for m in PATTERN_HARMONICS if m not in LINEAR_HARMONICS]
"""Harmonics of errors of pick-off and drive. A term must not stand in for an offset (2), a gain or
an axis (4) of the catalogue."""
FRAME_COORDINATES = ("temperature", "time")
"""Coordinates that the drive's frame may follow. The catalogue has it by specific force and by the
rate of the temperature."""


def show(block: Array) -> Array:
    """An error of the angle or of an output shows as it is."""
    return block


def _misdirect_forces(where: Coordinates) -> dict[str, Respond]:
    """What forces that point beside the pattern by an angle make of each channel (Eqs. 5a, 5h)."""
    log, gain = where.test.log, where.nominal.bryan_factor
    growth, force = where.growth_rate[:, None], where.quadrature_force[:, None]
    commanded = log.virtual_rotation[:, None]

    def push(block: Array) -> Array:
        return where.integrate(growth * average_rows(block))

    def drive(block: Array) -> Array:
        needed = -4 * gain**2 * commanded * average_rows(block)
        return compute_loop_force(needed, where.nominal.amplitude_loop, log.interval)

    def stiffen(block: Array) -> Array:
        return -2 * gain * force * average_rows(block)

    return {"gyro_angle": push, "amplitude_force": drive, "frequency_offset": stiffen}


def _misread_amplitude(where: Coordinates) -> dict[str, Respond]:
    """What linear errors of the pick-offs make of each channel by the amplitude that they misread:
    in the forces of the loops, and in the amplitude while the drive is off and nothing holds what
    they read (Eq. 5d)."""
    log, gain = where.test.log, where.nominal.bryan_factor
    growth, force = where.growth_rate[:, None], where.quadrature_force[:, None]
    commanded, level = log.virtual_rotation[:, None], where.level[:, None]
    last_driven = np.maximum.accumulate(np.where(log.is_driven, np.arange(len(level)), 0))

    def misread(block: Array) -> Array:
        return 2 * gain * turn_harmonic(block)

    def drive(block: Array) -> Array:
        error = misread(block)
        slope = np.diff(error, axis=0, prepend=error[:1]) / log.interval
        needed = -growth * average_rows(error) - slope
        return compute_loop_force(needed, where.nominal.amplitude_loop, log.interval)

    def decay(block: Array) -> Array:
        error = misread(block)
        return level * (error - error[last_driven])

    return {
        "gyro_angle": lambda block: -where.integrate(commanded * misread(block)),
        "amplitude_force": drive,
        "quadrature_force": lambda block: -force * misread(average_rows(block)),
        "amplitude": decay,
    }


def generate_pickoff_terms(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Errors of the pick-off in a channel: of the angle that it reads, with which the forces are
    misdirected, and if they are linear of the amplitude."""
    misdirect = _misdirect_forces(where).get(channel)
    misread = _misread_amplitude(where).get(channel)
    read = show if channel == "gyro_angle" else None
    for m, coordinate, function, harmonic, block in _generate_reading_errors(where):
        responses = (read, misdirect, misread if m in LINEAR_HARMONICS else None)
        if any(responses):
            term = make_term("gyro_angle", coordinate, function, harmonic, "pick-off")
            yield term, block, partial(_add_responses, responses)


def _add_responses(responses: Sequence[Respond | None], block: Array) -> Array:
    return np.asarray(sum(respond(block) for respond in responses if respond))


def _generate_reading_errors(
    where: Coordinates,
) -> Iterator[tuple[int, str, str, int | None, Array]]:
    """Errors of the angle at the pick-offs: harmonic of the pattern angle, and a function."""
    for m in ELECTRODE_HARMONICS:
        yield m, "wave_angle", name_harmonic(m), m, where.harmonics[m]
    for m in LINEAR_HARMONICS:
        for words in ("the temperature", "the temperature squared"):
            yield m, "temperature", *where.multiply_harmonic(m, words)
        for words in SPECIFIC_FORCES:
            yield m, "acceleration", *where.multiply_harmonic(m, words)
            yield m, "acceleration", *where.multiply_harmonic(m, f"{words} squared")
        for words in SETTLING_FACTORS:
            yield m, "time", *where.multiply_harmonic(m, words)
    for m in (2, 8):
        yield m, "amplitude", *where.multiply_harmonic(m, "the amplitude")


def generate_drive_terms(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Errors of the drive in a channel: of the direction of all its forces (Eq. 5h), which may
    follow the pattern angle or turn with another coordinate, and of its gain (Eq. 5b)."""
    log, directions = where.test.log, _misdirect_forces(where)
    growth, force = where.growth_rate[:, None], where.quadrature_force[:, None]
    gains: dict[str, Respond] = {
        "gyro_angle": lambda block: -where.integrate(block * log.virtual_rotation[:, None]),
        "amplitude_force": lambda block: -block * growth,
        "quadrature_force": lambda block: -block * force,
    }
    if channel in directions:
        for m in ELECTRODE_HARMONICS:
            term = make_term("gyro_angle", "wave_angle", name_harmonic(m), m, "drive")
            yield term, where.harmonics[m], directions[channel]
        for coordinate, function, harmonic, block in where.functions:
            term = make_term("gyro_angle", coordinate, function, harmonic, "drive")
            if term.is_plain and coordinate in FRAME_COORDINATES:
                yield term, block, directions[channel]
    if channel in gains:
        for m in ELECTRODE_HARMONICS:
            term = make_term("amplitude_force", "wave_angle", name_harmonic(m), m, "drive gain")
            yield term, where.means.harmonics[m], gains[channel]
