"""Columns of all candidate terms of a channel, by the place where a term acts.

A term of pick-off, drive or damping shows in more than one way: the forces of the loops follow what
the pick-off shows, and a force is as wrong as the drive (docs/methods/effects.md, Eqs. 4 to 5c).
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from functools import cache, partial

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import (
    LAST_MOTION,
    PATTERN_HARMONICS,
    SETTLING_FACTORS,
    SPECIFIC_FORCES,
    Coordinates,
    Functions,
    generate_anisotropies,
    make_harmonic,
    name_harmonic,
)
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.replay.loop_response import FORCES, compute_loop_force
from pyhrg.gap.replay.observations import MEAN_CHANNELS

Columns = list[tuple[CandidateTerm, Array]]
"""Terms with their (n, b) columns in one channel."""
PlacedTerm = tuple[CandidateTerm, Array, Callable[[Array], Array]]
"""A term, the (n, b) values of its basis functions, and what its place makes of these: linear."""

LINEAR_HARMONICS = (2, 4)
"""Harmonics of pick-offs' linear errors: offset, and gain or axis. Derived."""
ELECTRODE_HARMONICS = [m for m in PATTERN_HARMONICS if m not in LINEAR_HARMONICS]
"""Harmonics of errors of pick-off and drive. A term must not stand in for an offset (2), a gain or
an axis (4) of the catalogue."""
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
    return [
        (term, respond(block))
        for term, block, respond in generate_terms(where, channel)
        if among is None or term in among
    ]


def generate_terms(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Generate the same terms, with the values of their basis functions apart from what their place
    makes of these. A bias and what is averaged over a row have means over the rows."""
    if channel == "gyro_angle":
        yield from _generate_angle_terms(where)
        yield from _generate_anisotropy_bias(where.means)
    else:
        shown = where.means if channel in MEAN_CHANNELS else where
        for coordinate, function, harmonic, block in shown.functions:
            yield _make_term(channel, coordinate, function, harmonic), block, _show
    if channel == "amplitude":
        yield from _generate_free_decay(where)
    if channel in ("amplitude", *FORCES):
        yield from _generate_misread_amplitudes(where, channel)
    if channel in ("gyro_angle", "amplitude_force", "quadrature_force"):
        yield from _generate_drive_gains(where.means, channel)
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


@cache
def _make_term(
    channel: str, coordinate: str, function: str, harmonic: int | None = None, prefix: str = ""
) -> CandidateTerm:
    words = f"{prefix}: {function}" if prefix else function
    return CandidateTerm(channel, coordinate, words, harmonic)


def _show(block: Array) -> Array:
    return block


def _count_from_start(block: Array) -> Array:
    return np.asarray(block - block[:1])


def _turn(block: Array) -> Array:
    """(n, 2) cosine and sine of a harmonic, a quarter of its period ahead."""
    return np.column_stack([-block[:, 1], block[:, 0]])


def _average(block: Array) -> Array:
    """(n, b) mean of each row and the one before."""
    return np.asarray((block + np.vstack([block[:1], block[:-1]])) / 2)


def _integrate(where: Coordinates, rate: Array) -> Array:
    """(n, b) integral of rates over the rows, as a pattern that is free in some of them turns."""
    turned = np.cumsum(rate, axis=0) * where.test.log.interval
    return np.asarray(turned * where.free_turns[:, None])


def _misread(where: Coordinates, block: Array) -> Array:
    """(n, 2) relative error of the amplitude that a linear error of the pick-offs makes beside an
    error of the angle (Eq. 5d)."""
    return 2 * where.nominal.bryan_factor * _turn(block)


def _generate_angle_terms(where: Coordinates) -> Iterator[PlacedTerm]:
    """Terms of the output angle alone: a bias, whose integral appears; an error of the angle, from
    power-on on where it is the bench's: of the encoder, which may also have a backlash, or of a
    table that twists under its load; a force that points beside the pattern by an angle, which is a
    bias in proportion to the drive's growth rate; and an error of the pick-off, which is both of
    these."""

    integrate = partial(_integrate, where)

    def count_table_from_start(block: Array) -> Array:
        return block - make_harmonic(np.zeros(1))

    means = (mean for *_, mean in where.means.functions)
    for (coordinate, function, harmonic, block), mean in zip(where.functions, means, strict=True):
        key = ("gyro_angle", coordinate, function, harmonic)
        yield _make_term(*key, "bias"), mean, integrate
        if harmonic:
            is_table = coordinate == "table_angle"
            yield _make_term(*key, "angle"), block, count_table_from_start if is_table else _show
        if function in SPECIFIC_FORCES:
            yield _make_term(*key, "angle"), block, _count_from_start
    backlash = _make_term("gyro_angle", "table_angle", LAST_MOTION, prefix="angle")
    yield backlash, where.table_direction, _show
    for coordinate, function, harmonic, block in _generate_products(where):
        yield _make_term("gyro_angle", coordinate, function, harmonic, "bias"), block, integrate
    growth = where.growth_rate[:, None]
    commanded = where.test.log.virtual_rotation[:, None]

    def push(block: Array) -> Array:
        return integrate(growth * _average(block))

    def push_and_show(block: Array) -> Array:
        return block + push(block)

    def push_and_show_linearly(block: Array) -> Array:
        return push_and_show(block) - integrate(commanded * _misread(where, block))

    for m, coordinate, function, harmonic, block in _generate_electrode_errors(where):
        key = ("gyro_angle", coordinate, function, harmonic)
        respond = push_and_show_linearly if m in LINEAR_HARMONICS else push_and_show
        yield _make_term(*key, "pick-off"), block, respond
        if coordinate == "wave_angle":
            yield _make_term(*key, "drive"), block, push


def _generate_anisotropy_bias(where: Coordinates) -> Iterator[PlacedTerm]:
    """The bias that an anisotropy of damping makes (Eq. 5e)."""

    def respond(block: Array) -> Array:
        return _integrate(where, _turn(block) / (2 * where.nominal.bryan_factor))

    for coordinate, function, harmonic, block in generate_anisotropies(where):
        yield _make_term("amplitude_force", coordinate, function, harmonic), block, respond


def _generate_misread_amplitudes(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """What linear errors of the pick-offs make of the loops' forces, and of the amplitude while the
    drive is off and nothing holds what they read (Eq. 5d)."""
    log, gain = where.test.log, where.nominal.bryan_factor
    growth, force = where.growth_rate[:, None], where.quadrature_force[:, None]
    commanded, level = log.virtual_rotation[:, None], where.level[:, None]
    last_driven = np.maximum.accumulate(np.where(log.is_driven, np.arange(len(level)), 0))

    def drive(block: Array) -> Array:
        error = _misread(where, block)
        slope = np.diff(error, axis=0, prepend=error[:1]) / log.interval
        needed = -growth * _average(error) - slope - 4 * gain**2 * commanded * block
        return compute_loop_force(needed, where.nominal.amplitude_loop, log.interval)

    def balance(block: Array) -> Array:
        return -force * _misread(where, block)

    def decay(block: Array) -> Array:
        error = _misread(where, block)
        return level * (error - error[last_driven])

    responses = {"amplitude_force": drive, "quadrature_force": balance, "amplitude": decay}
    for m, coordinate, function, harmonic, block in _generate_electrode_errors(where):
        if m in LINEAR_HARMONICS:
            key = ("gyro_angle", coordinate, function, harmonic)
            yield _make_term(*key, "pick-off"), block, responses[channel]


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
        phase = _average(block)
        if channel == "gyro_angle":
            return -_integrate(where, quadrature * phase) / double_gain
        return phase * (growth if channel == "frequency_offset" else double_gain * commanded)

    for coordinate, function, harmonic, block in where.functions:
        term = _make_term("gyro_angle", coordinate, function, harmonic, "phase")
        is_single = harmonic is None and not (term.second or term.is_of_each_power_on)
        if is_single and coordinate in PHASE_COORDINATES and function != PHASE_FUNCTION:
            yield term, block, leak


def _generate_electrode_errors(
    where: Coordinates,
) -> Iterator[tuple[int, str, str, int | None, Array]]:
    """Errors of an angle at the electrodes: harmonic of the pattern angle, and a function."""

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


def _generate_drive_gains(where: Coordinates, channel: str) -> Iterator[PlacedTerm]:
    """Gains of the drive that follow the pattern angle: the commanded forces are smaller by them,
    and the commanded rotation is larger."""
    log = where.test.log
    force = "growth_rate" if channel == "amplitude_force" else "quadrature_force"

    def weaken(gain: Array) -> Array:
        if channel == "gyro_angle":
            return -_integrate(where, gain * log.virtual_rotation[:, None])
        return np.asarray(-gain * getattr(where, force)[:, None])

    for m in ELECTRODE_HARMONICS:
        term = _make_term("amplitude_force", "wave_angle", name_harmonic(m), m, "drive gain")
        yield term, where.harmonics[m], weaken


def _generate_free_decay(where: Coordinates) -> Iterator[PlacedTerm]:
    """What damping that follows the amplitude makes of the amplitude while the drive is off."""
    log = where.test.log
    free = log.is_free[:, None] * log.interval

    def decay(block: Array) -> Array:
        return np.asarray(-where.level[:, None] * np.cumsum(free * _average(block), 0))

    for coordinate, function, _, block in where.functions:
        if coordinate == "amplitude":
            yield _make_term("amplitude_force", "amplitude", function), block, decay
