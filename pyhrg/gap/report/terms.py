"""Proposed terms: formula, place, size, what they remove, and the nearest known mechanisms with
literature and the test that separates them.
"""

import html
from collections.abc import Collection
from typing import NamedTuple

from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.svg import format_interval, format_number
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.closing.equation.proposal import (
    Coefficient,
    as_candidate,
    list_coefficients,
    list_written,
)
from pyhrg.gap.findings.term import Term
from pyhrg.gap.report.words import (
    PARTS,
    PLACES,
    build_table,
    format_percent,
    format_term_unit,
    join_words,
)


class Mechanism(NamedTuple):
    """A mechanism of `HRG.UsersGuide.Mechanisms`, by its number there.

    name, source: in words; test: what shows this mechanism and not the others; kinds: of the
        campaign's tests that together are this test, none where they don't suffice.
    """

    name: str
    number: int
    source: str
    test: str
    kinds: tuple[str, ...] = ()

    def suggest_test(self, kinds: Collection[str]) -> str:
        """A sentence on the test, after a space; empty where tests of these kinds are it."""
        is_done = bool(self.kinds) and set(self.kinds) <= set(kinds)
        return "" if is_done else f" To tell: {self.test}."


XU = "Xu et al. (2024), doi:10.19306/j.cnki.2095-8110.2024.02.001"
LYNCH = "Lynch, 2nd St. Petersburg Int. Conf. on Gyroscopic Technology (1995)"
SENKAL = "Senkal and Shkel, Whole-Angle MEMS Gyroscopes (2020)"
PICKOFF_GAIN = "Actuators 14 (2025) 275"
DRIVE_CHAIN = "Sensors 24 (2024) 4328"
THERMAL = "Micromachines 16 (2025) 357"
PHASE = "Sci. Rep. (2025) s41598-025-86288-1"
_DAMPING = Mechanism(
    "damping anisotropy", 1, LYNCH, "a ring-down: it acts with the drive off too", ("ring_down",)
)
_MOUNTING = Mechanism(
    "anchor loss of the mounting",
    26,
    SENKAL,
    "ring-downs before and after the gyro is mounted again",
)
_DRIVE_GAIN = Mechanism(
    "drive gain mismatch",
    3,
    DRIVE_CHAIN,
    "a commanded rotation: its error is in proportion to the command",
    ("virtual_rotation",),
)
_DRIVE_AXES = Mechanism(
    "drive non-orthogonality", 5, DRIVE_CHAIN, "a ring-down: it ends there", ("ring_down",)
)
_AUTHORITY = Mechanism(
    "authority of the drive",
    30,
    DRIVE_CHAIN,
    "an amplitude sweep: it begins at a threshold",
    ("amplitude",),
)
_PICKOFF_GAIN = Mechanism(
    "pick-off gain mismatch",
    2,
    PICKOFF_GAIN,
    "a rate test both ways: the 4th harmonic of the angle",
    ("rate",),
)
_PICKOFF_AXES = Mechanism(
    "pick-off non-orthogonality",
    4,
    PICKOFF_GAIN,
    "a rate test both ways: the 4th harmonic, a quarter period later",
    ("rate",),
)
_OFFSET = Mechanism(
    "demodulation offset",
    12,
    SENKAL,
    "an amplitude sweep: its angle falls with the amplitude",
    ("amplitude",),
)
_CUBIC = Mechanism(
    "pick-off cubic",
    13,
    SENKAL,
    "an amplitude sweep: it grows with the square of the amplitude",
    ("amplitude",),
)
_OVER_TEMPERATURE = Mechanism(
    "gain, phase or anisotropy over temperature",
    24,
    THERMAL,
    "thermal ramps up and down, at two pattern angles",
)
_GRADIENT = Mechanism(
    "drive frame that turns with the temperature rate",
    24,
    THERMAL,
    "ramps up and down through one temperature: the sign changes",
    ("thermal",),
)
_FORCE = Mechanism(
    "gap or axes under specific force",
    28,
    SENKAL,
    "a tumble, then a centrifuge: linear or quadratic",
    ("tumble", "centrifuge"),
)
_CHARGE = Mechanism(
    "charge of the electrodes", 25, SENKAL, "a step of the bias voltage at constant temperature"
)
_DUFFING = Mechanism("Duffing stiffness", 14, SENKAL, "a step of the quadrature at two amplitudes")
_AGEING = Mechanism("ageing or loss of the vacuum", 31, SENKAL, "ring-downs weeks apart")
_DELAY = Mechanism(
    "loop delay and hold",
    15,
    SENKAL,
    "rates both ways with another delay: in proportion to the rate alone",
)
_RANGE = Mechanism(
    "full scale, slew rate or authority",
    30,
    SENKAL,
    "rates up to the full range: it begins at a threshold",
)
_BRYAN = Mechanism(
    "Bryan factor", 16, LYNCH, "rates both ways: in proportion to the rate alone", ("rate",)
)
_SPLIT = Mechanism(
    "frequency split",
    7,
    PHASE,
    "positions: the 4th harmonic in force and frequency",
    ("positions",),
)
_FREQUENCY = Mechanism(
    "frequency over temperature", 23, THERMAL, "slow ramps up and down", ("thermal",)
)
_MISALIGNMENT = Mechanism("input-axis misalignment", 29, XU, "more than ten turns of the table")
_PHASE = Mechanism(
    "frequency split with phase error",
    7,
    PHASE,
    "steps of the phase at one pattern angle, from power-on on",
)
NEAREST = {
    ("bias", "wave_angle"): (_DAMPING, _DRIVE_GAIN, _OFFSET),
    ("bias", "rate"): (_RANGE, _DELAY, _BRYAN),
    ("bias", "temperature"): (_OVER_TEMPERATURE, _GRADIENT),
    ("bias", "temperature_rate"): (_GRADIENT, _OVER_TEMPERATURE),
    ("bias", "acceleration"): (_FORCE,),
    ("bias", "amplitude"): (_DUFFING,),
    ("bias", "time"): (_CHARGE, _OVER_TEMPERATURE),
    ("bias", "table_angle"): (_MISALIGNMENT,),
    ("readout", "wave_angle"): (_CUBIC, _PICKOFF_GAIN, _PICKOFF_AXES),
    ("pickoff", "wave_angle"): (_PICKOFF_GAIN, _PICKOFF_AXES, _OFFSET, _CUBIC),
    ("pickoff", "temperature"): (_OVER_TEMPERATURE,),
    ("pickoff", "acceleration"): (_FORCE,),
    ("pickoff", "amplitude"): (_CUBIC, _OFFSET),
    ("drive", "wave_angle"): (_DRIVE_GAIN, _DRIVE_AXES, _AUTHORITY),
    ("drive", "temperature"): (_OVER_TEMPERATURE, _GRADIENT),
    ("drive", "time"): (_AGEING, _CHARGE),
    ("damping", "wave_angle"): (_DAMPING, _MOUNTING, _DRIVE_GAIN),
    ("damping", "temperature"): (_OVER_TEMPERATURE,),
    ("damping", "time"): (_AGEING,),
    ("damping", "amplitude"): (_CUBIC, _AUTHORITY),
    ("stiffness", "wave_angle"): (_SPLIT,),
    ("stiffness", "amplitude"): (_DUFFING,),
    ("stiffness", "temperature"): (_FREQUENCY, _CHARGE),
    ("stiffness", "time"): (_CHARGE,),
    ("stiffness", "acceleration"): (_FORCE,),
    ("phase", "temperature"): (_OVER_TEMPERATURE, _PHASE),
    ("phase", "temperature_rate"): (_OVER_TEMPERATURE, _PHASE),
    ("phase", "acceleration"): (_PHASE, _FORCE),
    ("phase", "time"): (_PHASE, _CHARGE),
    ("bench", "table_angle"): (_MISALIGNMENT,),
    ("bench", "acceleration"): (_FORCE,),
}
"""Nearest mechanisms by place, or part of it (`PARTS`), and coordinate, the nearest first."""


def find_nearest(term: Term) -> tuple[Mechanism, ...]:
    """Nearest known mechanisms of a term, the nearest first; none where the catalogue has none."""
    prefix = as_candidate(term).prefix
    keys = ((where, c) for where in (prefix, term.place) for c in term.coordinates)
    return next((NEAREST[key] for key in keys if key in NEAREST), ())


NO_TERM = (
    "No term is proposed. closed.mo and closed.fmu hold the identified gyro with its causes alone."
)
MAX_RIVALS = 4
"""Most rival forms that the page names (chosen)."""
INTRODUCTION = (
    "What has no name gets an equation. closed.mo adds these terms to the identified gyro, and "
    "closed.fmu is that class, built. A coordinate in a formula is a pure number: a quantity over "
    "the unit that stands in the coefficient's unit. The numbers of mechanisms are those of "
    "HRG.UsersGuide.Mechanisms."
)


def build_terms(result: CampaignDiagnosis) -> str:
    """A part for each proposed term."""
    terms = result.diagnosis.terms
    if not terms:
        return make_paragraph(NO_TERM)
    kinds = list_kinds(result)
    return make_paragraph(INTRODUCTION) + "".join(_build_term(term, kinds) for term in terms)


def list_kinds(result: CampaignDiagnosis) -> set[str]:
    """Kinds of the campaign's tests."""
    return {test.test.kind for test in result.tests}


def describe_term(term: Term) -> str:
    """Place, function and coefficients of a term in a sentence."""
    values = [
        f"{c.basis.text}: {_format_value(term, c)} {format_term_unit(c.unit)}".strip()
        for c in list_coefficients(as_candidate(term))
    ]
    sentence = f"{name_term(term)}, without a name; {join_words(values)}"
    if not term.beside:
        return sentence
    return f"{sentence}; {len(term.beside)} more functions of the coordinate stand in closed.mo"


def name_term(term: Term) -> str:
    """Place and function of a term."""
    candidate = as_candidate(term)
    return f"{PARTS.get(candidate.prefix, PLACES[term.place])}: {candidate.bare_function}"


def _format_value(term: Term, coefficient: Coefficient) -> str:
    name = coefficient.name
    return format_interval(term.parameters[name], *term.interval_95[name])


def describe_class(term: Term) -> str:
    """The probability of a term's form, and of what these tests can't tell from it."""
    stated = f"this form {format_percent(term.probability)}"
    if not term.rivals:
        return f"{stated}, no other form explains as much"
    others = [f"{words} {format_percent(p)}" for words, p in term.rivals.items()]
    count = f"{len(others)} other form{'s' if len(others) > 1 else ''}"
    if len(others) > MAX_RIVALS:
        others[MAX_RIVALS:] = [f"{len(others) - MAX_RIVALS} more (diagnosis.json)"]
    return (
        f"{stated}; together with {count} that these tests can't tell from it "
        f"{format_percent(term.discovery_probability)}: {join_words(others)}"
    )


def _build_term(term: Term, kinds: Collection[str]) -> str:
    rows = [
        (c.variable, _format_value(term, c), format_term_unit(c.unit)) for c in list_written(term)
    ]
    shrink = (
        "on the held-out tests its channel has no excess over the noise floor"
        if term.shrink_percent is None
        else f"it removes {format_number(term.shrink_percent)} % of the excess over the noise "
        "floor that named causes leave on the held-out tests, in its channel"
    )
    nearest = "".join(
        f"<li>{html.escape(f'{m.name} ({m.number}; {m.source}).{m.suggest_test(kinds)}')}</li>"
        for m in find_nearest(term)
    )
    return (
        f"<h3>{html.escape(name_term(term))}</h3>"
        f"<p><code>{html.escape(term.formula.modelica)}</code></p>"
        + build_table("Coefficients", ("Coefficient", "Value (95 % interval)", "Unit"), rows)
        + make_paragraph(f"Probability: {describe_class(term)}. Held-out tests: {shrink}.")
        + (f"<p>Nearest known mechanisms:</p><ul>{nearest}</ul>" if nearest else "")
    )
