"""Forms: what a candidate term may miss of a cause that has another form than it has.

The cause is taken to act at the term's place as another function of what the term follows
(docs/methods/evidence.md, Eq. 10a).
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm, Coordinates
from pyhrg.gap.effects.term_columns import generate_terms

MULTIPLES = (2, 3, 4, 5)
"""Multiples of a term's harmonic, or degrees of polynomials of its function, that a form has.
Chosen: a triangular wave has 97 % of what no sine has in its third and fifth."""


@dataclass(frozen=True)
class Form:
    """A multiple of a term's harmonic; of a term without one, a Chebyshev polynomial of its
    function, which is the same over an angle whose cosine that function is.

    multiple: of the harmonic, or degree of the polynomial.
    largest: magnitude of the function in the campaign.
    size: number of columns.
    """

    term: CandidateTerm
    multiple: int
    largest: float
    size: int

    is_of_each_power_on = False
    fault = None

    def bend(self, block: Array) -> Array:
        """(n, d) values of this form in the unit of the term's own (n, d) values."""
        if self.size == 1:
            series = chebyshev.Chebyshev.basis(self.multiple)
            return np.asarray(self.largest * (series(block / self.largest) - series(0.0)))
        length, angle = np.hypot(*block.T), self.multiple * np.arctan2(block[:, 1], block[:, 0])
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


def list_forms_of(term: CandidateTerm, tests: Sequence[Coordinates]) -> list[Form]:
    """Forms of a term in a campaign."""
    blocks = [b for where in tests for t, b, _ in generate_terms(where, term.channel) if t == term]
    largest = max(float(np.abs(block).max()) for block in blocks)
    return [Form(term, k, largest, blocks[0].shape[1]) for k in MULTIPLES if largest]
