"""Forms: functions by which a cause without a name may differ from the terms that stand for it.

It is taken to act at the same place and to follow the same coordinate (docs/methods/evidence.md,
Eq. 10a).
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
from numpy.polynomial import chebyshev
from numpy.polynomial.polynomial import polyval

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import Coordinates
from pyhrg.gap.effects.term_columns import find_terms, generate_terms

MULTIPLES = range(2, 16)
"""Multiples of a term's harmonic that a cause may have beside it. Chosen: a triangular wave has
multiples of one over their square."""
DEGREES = range(2, 8)
"""Degrees of the polynomials of other functions. Chosen."""


@dataclass(frozen=True)
class Form(CandidateTerm):
    """A candidate term's function, or from degree 2 on a multiple of its harmonic; of one without
    a harmonic, a Chebyshev polynomial, which is the same over an angle whose cosine it is. Of a
    product the second function is bent.

    largest: magnitude of the function in the campaign.
    reach: magnitude of what is bent.
    size: number of columns.
    """

    degree: int = 1
    largest: float = 1.0
    reach: float = 1.0
    size: int = 1

    @cached_property
    def term(self) -> CandidateTerm:
        """The candidate term."""
        return CandidateTerm(self.channel, self.coordinate, self.function, self.harmonic)

    @property
    def is_multiple(self) -> bool:
        """Whether it is a multiple of a harmonic."""
        return self.size > 1 and not self.second

    @property
    def polynomial(self) -> Array:
        """(degree,) coefficients, of rising powers, by which the function is multiplied: of the
        polynomial less its constant, over what is bent."""
        return _expand_chebyshev(self.degree)[1:]

    def bend(self, block: Array, bent: Array) -> Array:
        """(n, d) values of up to about 1, from the (n, d) values of the term's functions, and of
        what is bent of them, which counts up to its reach."""
        if not self.is_multiple:
            limited = np.clip(bent / self.reach, -1, 1)
            return np.asarray(block / self.largest * polyval(limited, self.polynomial))
        harmonic = (block[:, 0] + 1j * block[:, 1]) / self.largest
        length = np.abs(harmonic)
        unit = np.divide(harmonic, length, out=np.zeros_like(harmonic), where=length > 0)
        multiple = length * unit**self.degree
        return np.column_stack([multiple.real, multiple.imag])


@cache
def _expand_chebyshev(degree: int) -> Array:
    """(degree + 1,) coefficients of a Chebyshev polynomial, of rising powers."""
    return np.asarray(chebyshev.cheb2poly(np.eye(degree + 1)[degree]))


def get_bent(term: CandidateTerm, block: Array, where: Coordinates) -> Array:
    """(n, d) of a product the second function, else the (n, d) values of the term's functions."""
    return where.factors[term.second] if term.second else block


def build_form_columns(
    where: Coordinates, channel: str, forms: Collection[Form]
) -> list[tuple[Form, Array]]:
    """Forms that show in a channel in a test, (n, d) each."""
    by_term = _group_by_term(forms)
    return [
        (form, respond(form.bend(block, get_bent(form, block, where))))
        for term, block, respond in find_terms(where, channel, by_term)
        for form in by_term[term]
    ]


def build_reading_columns(
    where: Coordinates, among: Collection[object] | None = None
) -> Iterator[tuple[CandidateTerm, Array]]:
    """Errors of the output angle, (n, d) each, of all terms that make the pattern be read at a
    wrong angle, or of such terms and forms among some."""
    by_term = _group_by_term([group for group in among or () if isinstance(group, Form)])
    wanted = None if among is None else {*among, *by_term}
    for term, block, _ in find_terms(where, "gyro_angle", wanted):
        if term.is_reading_error:
            if among is None or term in among:
                yield term, block
            for form in by_term.get(term, ()):
                yield form, form.bend(block, get_bent(form, block, where))


def _group_by_term(forms: Collection[Form]) -> dict[CandidateTerm, list[Form]]:
    by_term: dict[CandidateTerm, list[Form]] = {}
    for form in forms:
        by_term.setdefault(form.term, []).append(form)
    return by_term


def find_forms(
    sizes: Mapping[CandidateTerm, Array], tests: Sequence[Coordinates]
) -> dict[Form, float]:
    """Forms of a cause for which terms of one family, of these (d,) sizes, stand; each with the
    magnitude of the cause."""
    first = next(iter(sizes))
    blocks: dict[CandidateTerm, list[Array]] = {}
    bent: dict[CandidateTerm, list[Array]] = {}
    for where in tests:
        for term, block, _ in generate_terms(where, first.channel):
            is_function = term in sizes or not term.second
            if term.family == first.family and is_function and not term.is_of_each_power_on:
                blocks.setdefault(term, []).append(block)
                bent.setdefault(term, []).append(get_bent(term, block, where))
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
            reach=_find_largest(bent[term]),
            size=own[0].shape[1],
        )
        for term, own in blocks.items()
        if (largest := _find_largest(own))
        for degree in (1, *_list_degrees(term, term in sizes))
        if degree > 1 or list(sizes) != [term]
    ]
    return dict.fromkeys(forms, magnitude)


def _find_largest(blocks: Iterable[Array]) -> float:
    return max(float(np.abs(block).max()) for block in blocks)


def _list_degrees(term: CandidateTerm, stands_for_it: bool) -> Iterable[int]:
    """Degrees beside 1 of the forms from one term of the cause's family."""
    if not stands_for_it:
        return ()
    return DEGREES if term.harmonic is None else MULTIPLES if term.harmonic else ()
