"""Columns of all candidate terms of a channel, by the place where a term acts
(docs/methods/effects.md, Eqs. 4 to 5h)."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from operator import itemgetter

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm, make_term
from pyhrg.gap.effects.coordinates import (
    LAST_MOTION,
    SPECIFIC_FORCES,
    Coordinates,
    Functions,
    average_rows,
    generate_anisotropies,
    make_harmonic,
    turn_harmonic,
)
from pyhrg.gap.effects.electrode_terms import (
    PlacedTerm,
    generate_drive_terms,
    generate_pickoff_terms,
    show,
)
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.replay.observations import MEAN_CHANNELS

Columns = list[tuple[CandidateTerm, Array]]
"""Terms with their (n, b) columns in one channel."""

PHASE_COORDINATES = ("temperature", "temperature_rate", "acceleration", "time")
"""Coordinates that an error of the demodulation's phase may follow."""
PHASE_FUNCTION = "temperature^1"
"""The function of them that a phase error of the catalogue follows."""


def build_term_columns(
    where: Coordinates, channel: str, among: Collection[object] | None = None
) -> Columns:
    """All candidate terms that show in a channel in a test, or those among some, (n, b) each, in
    the same order for every test. A term that shows in several channels has the same identity in
    all of them."""
    placed = find_terms(where, channel, among)
    return [(term, respond(block)) for term, block, respond in placed]


def find_terms(
    where: Coordinates, channel: str, among: Collection[object] | None
) -> Iterable[PlacedTerm]:
    """Find all terms that show in a channel in a test, or those among some, in the same order.
    These are kept: a search asks for the same few terms again and again."""
    if among is None:
        return generate_terms(where, channel)
    kept, wanted = where.kept.setdefault(channel, {}), set(among)
    if missing := wanted.difference(kept):
        kept.update(dict.fromkeys(missing))
        for number, placed in enumerate(generate_terms(where, channel)):
            if placed[0] in missing:
                kept[placed[0]] = number, placed
    found = [own for own in map(kept.get, wanted) if own]
    return [placed for _, placed in sorted(found, key=itemgetter(0))]


def generate_terms(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Generate the same terms, with the values of their basis functions apart from what their place
    makes of these. A bias and what is averaged over a row have means over the rows."""
    if channel == "gyro_angle":
        yield from _generate_angle_terms(where)
        yield from _generate_anisotropy_bias(where.means)
    else:
        shown = where.means if channel in MEAN_CHANNELS else where
        for coordinate, function, harmonic, block in shown.functions:
            yield make_term(channel, coordinate, function, harmonic), block, show
    if channel == "amplitude":
        yield from _generate_free_decay(where)
    yield from generate_pickoff_terms(where, channel)
    yield from generate_drive_terms(where, channel)
    if channel in ("gyro_angle", "quadrature_force", "frequency_offset"):
        yield from _generate_phase_errors(where, channel)


def select_term_columns(
    where: Coordinates, channel: str, terms: Collection[object]
) -> dict[CandidateTerm, Array]:
    """(n, b) columns of those of these terms and jumps that show in a channel in a test."""
    columns = dict(build_term_columns(where, channel, terms))
    jumps = [t for t in terms if isinstance(t, Jump) and t.channel == channel]
    return columns | {jump: jump.columns(where) for jump in jumps}


def compute_response(
    where: Coordinates, channel: str, sizes: Mapping[CandidateTerm, Array]
) -> Array:
    """(n,) response of a channel to terms of these sizes, (d,) each, in units of their columns."""
    columns = select_term_columns(where, channel, sizes)
    own = [columns[term] @ size for term, size in sizes.items() if term in columns]
    return np.asarray(sum(own, np.zeros(len(where.pattern_angle))))


def _count_from_start(block: Array) -> Array:
    return np.asarray(block - block[:1])


def _generate_angle_terms(where: Coordinates) -> Iterator[PlacedTerm]:
    """Terms of the output angle alone: a bias, whose integral appears; an error of the angle, from
    power-on on where it is the bench's: of the encoder, which may also have a backlash, or of a
    table that twists under its load."""

    def count_table_from_start(block: Array) -> Array:
        return block - make_harmonic(np.zeros(1))

    means = (mean for *_, mean in where.means.functions)
    for (coordinate, function, harmonic, block), mean in zip(where.functions, means, strict=True):
        key = ("gyro_angle", coordinate, function, harmonic)
        yield make_term(*key, "bias"), mean, where.integrate
        if harmonic:
            is_table = coordinate == "table_angle"
            yield make_term(*key, "angle"), block, count_table_from_start if is_table else show
        if function in SPECIFIC_FORCES:
            yield make_term(*key, "angle"), block, _count_from_start
    backlash = make_term("gyro_angle", "table_angle", LAST_MOTION, prefix="angle")
    yield backlash, where.table_direction, show
    for coordinate, function, harmonic, block in _generate_products(where):
        key = ("gyro_angle", coordinate, function, harmonic)
        yield make_term(*key, "bias"), block, where.integrate


def _generate_anisotropy_bias(where: Coordinates) -> Iterator[PlacedTerm]:
    """The bias that an anisotropy of damping makes (Eq. 5e)."""

    def respond(block: Array) -> Array:
        return where.integrate(turn_harmonic(block) / (2 * where.nominal.bryan_factor))

    for coordinate, function, harmonic, block in generate_anisotropies(where):
        yield make_term("amplitude_force", coordinate, function, harmonic), block, respond


def _generate_products(where: Coordinates) -> Functions:
    """Functions of a bias alone: a scale factor by rate or temperature, specific force by it."""
    rate = where.factors["the rate"]
    yield "rate", "rate times its magnitude", None, rate * np.abs(rate)
    yield "rate", *where.multiply("rate", rate, "the temperature")
    for words in SPECIFIC_FORCES:
        yield "acceleration", *where.multiply(words, where.factors[words], "the temperature")


def _generate_phase_errors(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Errors of the phase, by which a part of each force acts in the place of another (Eq. 5f)."""
    double_gain = 2 * where.nominal.bryan_factor
    quadrature, growth = where.quadrature_force[:, None], where.growth_rate[:, None]
    commanded = where.test.log.virtual_rotation[:, None]

    def leak(block: Array) -> Array:
        phase = average_rows(block)
        if channel == "gyro_angle":
            return -where.integrate(quadrature * phase) / double_gain
        return phase * (growth if channel == "frequency_offset" else double_gain * commanded)

    for coordinate, function, harmonic, block in where.functions:
        term = make_term("gyro_angle", coordinate, function, harmonic, "phase")
        if term.is_plain and coordinate in PHASE_COORDINATES and function != PHASE_FUNCTION:
            yield term, block, leak


def _generate_free_decay(where: Coordinates) -> Iterator[PlacedTerm]:
    """What damping that follows the amplitude makes of the amplitude while the drive is off."""
    log = where.test.log
    free = log.is_free[:, None] * log.interval

    def decay(block: Array) -> Array:
        return np.asarray(-where.level[:, None] * np.cumsum(free * average_rows(block), 0))

    for coordinate, function, _, block in where.functions:
        if coordinate == "amplitude":
            yield make_term("amplitude_force", "amplitude", function), block, decay
