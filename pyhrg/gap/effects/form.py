"""Forms: functions by which a cause without a name may differ from the terms that stand for it.

It is taken to act at the same place and to follow the same coordinate (docs/methods/evidence.md,
Eq. 10a).
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm, Coordinates
from pyhrg.gap.effects.term_columns import generate_terms

MULTIPLES = range(2, 16)
"""Multiples of a term's harmonic that a cause may have beside it. Chosen: a triangular wave has
multiples of one over their square."""
DEGREES = range(2, 8)
"""Degrees of the polynomials of other functions. Chosen."""


@dataclass(frozen=True)
class Form(CandidateTerm):
    """A candidate term's function, or from degree 2 on a multiple of its harmonic; of one without
    a harmonic, a Chebyshev polynomial, which is the same over an angle whose cosine it is.

    largest: magnitude of the function in the campaign.
    size: number of columns.
    """

    degree: int = 1
    largest: float = 1.0
    size: int = 1

    @property
    def term(self) -> CandidateTerm:
        """The candidate term."""
        return CandidateTerm(self.channel, self.coordinate, self.function, self.harmonic)

    def bend(self, block: Array) -> Array:
        """(n, d) values of up to about 1, from the (n, d) values of the term's functions."""
        values = block / self.largest
        if self.degree == 1:
            return np.asarray(values)
        if self.size == 1:
            polynomial = chebyshev.Chebyshev.basis(self.degree)
            return np.asarray(polynomial(values) - polynomial(0.0))
        length, angle = np.hypot(*values.T), self.degree * np.arctan2(values[:, 1], values[:, 0])
        return np.column_stack([length * np.cos(angle), length * np.sin(angle)])


def build_form_columns(
    where: Coordinates, channel: str, forms: Collection[Form]
) -> list[tuple[Form, Array]]:
    """Forms that show in a channel in a test, (n, d) each."""
    by_term: dict[CandidateTerm, list[Form]] = {}
    for form in forms:
        by_term.setdefault(form.term, []).append(form)
    return [
        (form, respond(form.bend(block)))
        for term, block, respond in (generate_terms(where, channel) if forms else ())
        for form in by_term.get(term, ())
    ]


def build_reading_columns(
    where: Coordinates, groups: Collection[CandidateTerm]
) -> list[tuple[CandidateTerm, Array]]:
    """Errors of the output angle, (n, d) each, of those terms and forms that make the pattern be
    read at a wrong angle."""
    wanted: dict[CandidateTerm, list[CandidateTerm]] = {}
    for group in groups:
        if group.is_reading_error:
            wanted.setdefault(group.term if isinstance(group, Form) else group, []).append(group)
    return [
        (group, group.bend(block) if isinstance(group, Form) else block)
        for term, block, _ in (generate_terms(where, "gyro_angle") if wanted else ())
        for group in wanted.get(term, ())
    ]


def find_forms(
    sizes: Mapping[CandidateTerm, Array], tests: Sequence[Coordinates]
) -> dict[Form, float]:
    """Forms of a cause for which terms of one family, of these (d,) sizes, stand; each with the
    magnitude of the cause."""
    first = next(iter(sizes))
    blocks: dict[CandidateTerm, list[Array]] = {}
    for where in tests:
        for term, block, _ in generate_terms(where, first.channel):
            is_function = term in sizes or not term.is_product
            if term.family == first.family and is_function and not term.is_of_each_power_on:
                blocks.setdefault(term, []).append(block)
    shapes = zip(*([b @ size for b in blocks[term]] for term, size in sizes.items()), strict=True)
    magnitude = max(float(np.abs(sum(own)).max()) for own in shapes)
    forms = [
        Form(
            term.channel,
            term.coordinate,
            term.function,
            term.harmonic,
            degree=degree,
            largest=largest,
            size=own[0].shape[1],
        )
        for term, own in blocks.items()
        if (largest := max(float(np.abs(block).max()) for block in own))
        for degree in (1, *_list_degrees(term, term in sizes))
        if degree > 1 or list(sizes) != [term]
    ]
    return dict.fromkeys(forms, magnitude)


def _list_degrees(term: CandidateTerm, stands_for_it: bool) -> Iterable[int]:
    """Degrees beside 1 of the forms from one term of the cause's family."""
    if not stands_for_it:
        return ()
    return DEGREES if term.harmonic is None else MULTIPLES if term.harmonic else ()
