"""Proposed terms: formula, place, size, what they remove, and the nearest known mechanisms."""

import html

from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.svg import format_number
from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.findings.term import Term
from pyhrg.gap.report.words import build_table, format_interval

NO_TERM = (
    "No term is proposed. closed.mo and closed.fmu hold the identified gyro with its causes alone."
)
INTRODUCTION = (
    "What has no name gets an equation. closed.mo adds these terms to the identified gyro, and "
    "closed.fmu is that class, built. The shrink is the share of the excess over the noise floor "
    "that causes leave on the held-out tests, in the channel of the term."
)
KNOWN_MECHANISMS = {
    ("bias", "wave_angle"): "damping anisotropy (1), drive gain mismatch (3), feedthrough (11), "
    "demodulation offset (12)",
    ("readout", "wave_angle"): "pick-off gain mismatch (2), non-orthogonality (4), demodulation "
    "offset (12), pick-off cubic (13)",
    ("bias", "rate"): "loop delay and hold (15), Bryan factor (16)",
    ("bias", "temperature"): "decay time, anisotropy, gain and phase over temperature (24)",
    ("bias", "temperature_rate"): "rotation of the drive frame with the temperature rate (24)",
    ("bias", "acceleration"): "specific force (28)",
    ("readout", "acceleration"): "specific force (28)",
    ("damping", "time"): "ageing (31)",
    ("damping", "wave_angle"): "damping anisotropy (1), mounting (26)",
    ("stiffness", "wave_angle"): "frequency split (7)",
    ("stiffness", "amplitude"): "Duffing stiffness (14)",
    ("stiffness", "temperature"): "frequency over temperature (23)",
}
"""Nearest mechanisms of `HRG.UsersGuide.Mechanisms` by place and coordinate, with their numbers."""
SOURCES = (
    "The numbers are those of the catalogue HRG.UsersGuide.Mechanisms; its sources (Lynch 1995, "
    "Senkal and Shkel 2020, Xu et al. 2024, Adler 1946) are listed in HRG.UsersGuide.References."
)


def build_terms(result: CampaignDiagnosis) -> str:
    """A table of the proposed terms, one row a coefficient."""
    terms = result.diagnosis.terms
    if not terms:
        return make_paragraph(NO_TERM)
    rows = [row for term in terms for row in _make_rows(term)]
    head = ("Place", "Formula", "Coefficient", "Value (95 %)", "Probability", "Shrink, %",
            "Rival forms", "Nearest known mechanisms")  # fmt: skip
    return "".join(
        (make_paragraph(INTRODUCTION), build_table("Terms", head, rows), make_paragraph(SOURCES))
    )


def _make_rows(term: Term) -> list[tuple[str, ...]]:
    rivals = ", ".join(f"{words}: {p:.3f}" for words, p in term.rivals.items()) or "none"
    mechanisms = KNOWN_MECHANISMS.get((term.place, term.coordinates[0]), "none")
    shrink = "no excess" if term.shrink_percent is None else f"{term.shrink_percent:.1f}"
    return [
        (
            term.place,
            html.escape(term.formula.text),
            html.escape(name),
            format_interval(value, *term.interval_95[name]),
            format_number(term.probability),
            shrink,
            html.escape(rivals),
            mechanisms,
        )
        for name, value in term.parameters.items()
    ]
