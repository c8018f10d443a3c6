"""Columns of all candidate terms of a channel, by the place where a term acts.

A term of pick-off, drive or damping shows in more than one way: the forces of the loops follow what
the pick-off shows, and a force is as wrong as the drive (docs/methods/effects.md, Eqs. 4 to 5c).
"""

from collections.abc import Callable, Iterator, Mapping

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import EACH_POWER_ON, CandidateTerm
from pyhrg.gap.effects.coordinates import (
    LAST_MOTION,
    PATTERN_HARMONICS,
    Coordinates,
    Functions,
    make_harmonic,
)
from pyhrg.gap.effects.jump import Jump

Columns = list[tuple[CandidateTerm, Array]]
"""Terms with their (n, b) columns in one channel."""
PlacedTerm = tuple[CandidateTerm, Array, Callable[[Array], Array]]
"""A term, the (n, b) values of its basis functions, and what its place makes of these: linear."""

ELECTRODE_HARMONICS = [m for m in PATTERN_HARMONICS if m not in (2, 4)]
"""Harmonics of errors of pick-off and drive. A term must not stand in for an offset (2), a gain or
an axis (4) of the catalogue."""
HARMONIC = "harmonic {} of the pattern angle"
FORCES = [f"acceleration {axis}" for axis in "xyz"]


def build_term_columns(where: Coordinates, channel: str) -> Columns:
    """All candidate terms that show in a channel in a test, (n, b) each, in the same order for
    every test. A term that shows in several channels has the same identity in all of them."""
    return [(term, respond(block)) for term, block, respond in generate_terms(where, channel)]


def generate_terms(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Generate the same terms, with the values of their basis functions apart from what their place
    makes of these."""
    if channel == "gyro_angle":
        yield from _generate_angle_terms(where)
    else:
        for coordinate, function, harmonic, block in where.functions:
            yield _make_term(channel, coordinate, function, harmonic), block, _show
    if channel == "amplitude":
        yield from _generate_free_decay(where)
    if channel in ("gyro_angle", "amplitude_force", "quadrature_force"):
        yield from _generate_drive_gains(where, channel)


def compute_response(
    where: Coordinates, channel: str, sizes: Mapping[CandidateTerm, Array]
) -> Array:
    """(n,) response of a channel to terms of these sizes, (d,) each, in units of their columns."""
    columns = dict(build_term_columns(where, channel))
    columns |= {t: t.columns(where) for t in sizes if isinstance(t, Jump) and t.channel == channel}
    own = [columns[term] @ size for term, size in sizes.items() if term in columns]
    return np.asarray(sum(own, np.zeros(len(where.pattern_angle))))


def _make_term(
    channel: str, coordinate: str, function: str, harmonic: int | None = None, place: str = ""
) -> CandidateTerm:
    words = f"{place}: {function}" if place else function
    own = function == EACH_POWER_ON
    return CandidateTerm(channel, coordinate, words, harmonic, is_of_each_power_on=own)


def _show(block: Array) -> Array:
    return block


def _generate_angle_terms(where: Coordinates) -> Iterator[PlacedTerm]:
    """Terms of the output angle alone: a bias, whose integral appears; an error of the angle, from
    the table's start on where it is the encoder's, which may also have a backlash; a force that
    points beside the pattern by an angle, which is a bias in proportion to the drive's growth rate;
    and an error of the pick-off, which is both of these."""

    def integrate(rate: Array) -> Array:
        return np.asarray(np.cumsum(rate, axis=0) * where.test.log.interval)

    def count_from_start(block: Array) -> Array:
        return block - make_harmonic(np.zeros(1))

    for coordinate, function, harmonic, block in where.functions:
        key = ("gyro_angle", coordinate, function, harmonic)
        yield _make_term(*key, "bias"), block, integrate
        if harmonic:
            is_table = coordinate == "table_angle"
            yield _make_term(*key, "angle"), block, count_from_start if is_table else _show
    backlash = _make_term("gyro_angle", "table_angle", LAST_MOTION, place="angle")
    yield backlash, where.table_direction, _show
    for coordinate, function, harmonic, block in _generate_products(where):
        yield _make_term("gyro_angle", coordinate, function, harmonic, "bias"), block, integrate
    growth = where.growth_rate[:, None]

    def push(block: Array) -> Array:
        return integrate(growth * (block + np.vstack([block[:1], block[:-1]])) / 2)

    def push_and_show(block: Array) -> Array:
        return block + push(block)

    for coordinate, function, harmonic, block in _generate_electrode_errors(where):
        key = ("gyro_angle", coordinate, function, harmonic)
        yield _make_term(*key, "pick-off"), block, push_and_show
        if coordinate == "wave_angle":
            yield _make_term(*key, "drive"), block, push


def _generate_products(where: Coordinates) -> Functions:
    """Functions of a bias alone: a scale factor by rate or temperature, specific force by it."""
    rate = where.factors["the rate"]
    yield "rate", "rate times its magnitude", None, rate * np.abs(rate)
    yield "rate", *where.multiply("rate", rate, "the temperature")
    for words in FORCES:
        yield "acceleration", *where.multiply(words, where.factors[words], "the temperature")


def _generate_electrode_errors(where: Coordinates) -> Functions:
    """Errors of an angle at the electrodes."""

    def modulate(m: int, second: str) -> tuple[str, None, Array]:
        return where.multiply(HARMONIC.format(m), where.harmonics[m], second)

    for m in ELECTRODE_HARMONICS:
        yield "wave_angle", HARMONIC.format(m), m, where.harmonics[m]
    for m in (2, 4):
        yield "temperature", *modulate(m, "the temperature")
        for words in FORCES:
            yield "acceleration", *modulate(m, words)
            yield "acceleration", *modulate(m, f"{words} squared")
    for m in (2, 8):
        yield "amplitude", *modulate(m, "the amplitude")


def _generate_drive_gains(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Gains of the drive that follow the pattern angle: the commanded forces are smaller by them,
    and the commanded rotation is larger."""
    log = where.test.log
    force = "growth_rate" if channel == "amplitude_force" else "quadrature_force"

    def weaken(gain: Array) -> Array:
        if channel == "gyro_angle":
            return -np.cumsum(gain * log.virtual_rotation[:, None], axis=0) * log.interval
        return np.asarray(-gain * getattr(where, force)[:, None])

    for m in ELECTRODE_HARMONICS:
        term = _make_term("amplitude_force", "wave_angle", HARMONIC.format(m), m, "drive gain")
        yield term, where.harmonics[m], weaken


def _generate_free_decay(where: Coordinates) -> Iterator[PlacedTerm]:
    """What damping that follows the amplitude makes of the amplitude while the drive is off."""
    log = where.test.log
    free = (log.drive_on <= 0)[:, None] * log.interval

    def decay(block: Array) -> Array:
        return np.asarray(-where.level[:, None] * np.cumsum(free * block, 0))

    for coordinate, function, _, block in where.functions:
        if coordinate == "amplitude":
            yield _make_term("amplitude_force", "amplitude", function), block, decay
