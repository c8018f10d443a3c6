"""The diagnosis as answers to five questions, in sentences: for the page and for the terminal."""

import textwrap
from collections.abc import Sequence

from pyhrg.common.pages.svg import format_interval, format_number
from pyhrg.device.declarations import format_effect
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.effects.catalogue import NOISE_EFFECTS
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis, GapFigure, Worth
from pyhrg.gap.findings.localisation import sum_shares
from pyhrg.gap.findings.verdict import UNEXPLAINED_PROBABILITY
from pyhrg.gap.replay.observations import CHANNEL_WORDS
from pyhrg.gap.report.closing import describe_closing
from pyhrg.gap.report.next_steps import suggest_next_steps
from pyhrg.gap.report.terms import (
    describe_class,
    describe_term,
    list_kinds,
    name_term,
)
from pyhrg.gap.report.words import (
    COORDINATES,
    NOTHING_BEYOND,
    format_name,
    format_percent,
    join_words,
    parse_parameter,
    read_nominal_value,
)

FAMILIES = {
    "gyro": "the gyro",
    "nominal": "the nominal values",
    "bench": "the bench",
    "record": "the record",
}
"""Where a cause lies, in words."""
MAX_PLACES, MIN_SHARE = 3, 0.05
"""Most places that are named, and the least share of the gap that a named place has (chosen)."""
NOT_SETTLED = "Do not rely on this, the search did not converge. "
UNNAMED_CAUSE = "a cause outside the catalogue"
WIDTH, INDENT = 100, 14
"""Width of a line for the terminal, and of the column of the questions."""


def write_headline(diagnosis: Diagnosis) -> str:
    """The verdict in one sentence, after a warning where the search did not converge."""
    return f"{'' if diagnosis.settled else NOT_SETTLED}{_write_verdict(diagnosis)}"


def _write_verdict(diagnosis: Diagnosis) -> str:
    material = [c for c in diagnosis.causes if not diagnosis.is_immaterial(c)]
    causes = material or list(diagnosis.causes)
    names, is_single = join_words([format_effect(c.effect) for c in causes]), len(causes) == 1
    too = _mention_immaterial(diagnosis, [c for c in diagnosis.causes if c not in causes])
    if diagnosis.verdict == "no_gap":
        if diagnosis.within_tolerance or diagnosis.left.angle_arcsec:
            return (
                f"No gap: the records agree with the simulation within tolerances and noise{too}."
            )
        return (
            "No gap: the records agree with the simulation of the nominal gyro within the noise"
            f"{too}."
        )
    if diagnosis.verdict == "explained":
        place = _list_families(causes)
        are = " is" if is_single else "s are"
        weight = "" if material else ", immaterial by the bound"
        return f"The gap is explained, and lies in {place}: its cause{are} {names}{weight}{too}."
    if diagnosis.verdict == "ambiguous" and diagnosis.gap.is_wider_held_out:
        agree = "agrees" if is_single else "agree"
        return (
            f"The gap is open: {names} {agree} with the fitted tests, but not with the held-out "
            f"ones{too}."
        )
    if diagnosis.verdict == "ambiguous":
        others = "effects that these records can't separate from it"
        return f"The gap is explained by {names}, or by {others}{too}."
    beside = f", beside {names}" if names else ""
    equation = "; it has an equation, but no name" if diagnosis.terms else ""
    return f"The gap is not explained: {UNNAMED_CAUSE} takes part{beside}{equation}{too}."


def _mention_immaterial(diagnosis: Diagnosis, causes: Sequence[Cause]) -> str:
    """Names the causes that take part and don't count, one without a name among them."""
    names = [format_effect(cause.effect) for cause in causes]
    names += [UNNAMED_CAUSE] if has_immaterial_cause(diagnosis) else []
    if not names:
        return ""
    take, make = ("takes", "it makes") if len(names) == 1 else ("take", "they make")
    return f"; {join_words(names)} {take} part too, but what {make} is immaterial"


def answer_questions(result: CampaignDiagnosis) -> dict[str, list[str]]:
    """Sentences on where the gap is, what it is, how sure that is, how much of the gap it makes,
    and what to do next."""
    diagnosis = result.diagnosis
    return {
        "Where": _say_where(diagnosis),
        "What": [
            *(_describe_cause(cause, result) for cause in diagnosis.causes),
            *(f"{describe_term(term)}." for term in diagnosis.terms),
            *_mention_tolerated(diagnosis),
        ]
        or ["Nothing is off."],
        "How sure": _say_how_sure(diagnosis),
        "How much": [
            *_describe_residuals(diagnosis),
            describe_closing(diagnosis.gap)[0],
            *(_describe_worth(cause, diagnosis) for cause in diagnosis.causes if cause.worth),
            describe_leftover(diagnosis),
        ],
        "What next": suggest_next_steps(diagnosis, list_kinds(result)),
    }


def summarize_diagnosis(result: CampaignDiagnosis) -> str:
    """The verdict and the answers for the terminal, a line a sentence."""
    lines = [f"{result.diagnosis.device}: {write_headline(result.diagnosis)}"]
    for question, sentences in answer_questions(result).items():
        for i, sentence in enumerate(sentences):
            head = f"  {'' if i else question:{INDENT - 2}}"
            lines += textwrap.wrap(
                sentence, WIDTH, initial_indent=head, subsequent_indent=" " * INDENT
            )
    return "\n".join(lines).replace("\u00a0", " ")


def describe_leftover(diagnosis: Diagnosis) -> str:
    """What named causes leave, and whether it matters, in a sentence."""
    left, bound = diagnosis.left, diagnosis.bound
    if not left.angle_arcsec and not left.rate_deg_h and not left.loop_share:
        return "Named causes leave nothing beyond the noise."
    limits = f"{bound.angle_arcsec:g} arcsec, {bound.rate_deg_h:g} deg/h"
    limits += f", {format_percent(bound.loop_share)}"
    role = "material" if left.exceeds(bound) else "immaterial"
    return f"Named causes leave {_format_worth(left)}; {role} by the bound of {limits}."


def _describe_worth(cause: Cause, diagnosis: Diagnosis) -> str:
    """What a cause makes, and whether it matters, in a sentence."""
    assert cause.worth, "noises and faults have none"
    words, sizes = _begin(format_effect(cause.effect)), _format_worth(cause.worth)
    weight = "; immaterial" if diagnosis.is_immaterial(cause) else ""
    return f"{words} makes up to {sizes}{weight}."


def _format_worth(worth: Worth) -> str:
    """Its sizes that are not zero."""
    channel = CHANNEL_WORDS.get(worth.loop_channel, "other channels")
    metres = format_number(worth.document()["position_m"])
    rate = f"{format_number(worth.rate_deg_h)} deg/h ({metres} m after an hour)"
    sizes = {
        f"{format_number(worth.angle_arcsec)} arcsec": worth.angle_arcsec,
        rate: worth.rate_deg_h,
        f"{format_percent(worth.loop_share)} of the scale of the {channel}": worth.loop_share,
    }
    return join_words([words for words, size in sizes.items() if size]) or "nothing"


def has_immaterial_cause(diagnosis: Diagnosis) -> bool:
    """Whether something outside the catalogue takes part and does not count for the verdict."""
    is_there = diagnosis.unknown_probability >= UNEXPLAINED_PROBABILITY
    return is_there and diagnosis.verdict != "unexplained"


def _list_families(causes: Sequence[Cause]) -> str:
    return join_words(list(dict.fromkeys(FAMILIES[cause.family] for cause in causes)))


def _say_where(diagnosis: Diagnosis) -> list[str]:
    """Gyro, bench or record, and the tests, channels and coordinates with most of the gap."""
    families = [FAMILIES[c.family] for c in diagnosis.causes]
    families += [FAMILIES["bench" if t.place == "bench" else "gyro"] for t in diagnosis.terms]
    lies_in = join_words(list(dict.fromkeys(families)))
    sentences = [f"In {lies_in}." if lies_in else "No gap of gyro, bench or record has a name."]
    if diagnosis.verdict == "no_gap":
        sentences = ["Nothing in gyro, bench or record is off beyond its tolerance."]
    if not diagnosis.where:
        return [*sentences, NOTHING_BEYOND]
    shares = sum_shares(diagnosis.where, lambda p: (p.test, p.channel, p.coordinate))
    order = sorted(shares.items(), key=lambda pair: -pair[1])[:MAX_PLACES]
    places = [
        f"{CHANNEL_WORDS[channel]} of {test} over {COORDINATES[coordinate]} "
        f"({format_percent(share)})"
        for (test, channel, coordinate), share in order
        if share >= MIN_SHARE or share == order[0][1]
    ]
    beyond = "beyond tolerances and noise"
    return [*sentences, f"Most of the residual's power {beyond}: {join_words(places)}."]


def _say_how_sure(diagnosis: Diagnosis) -> list[str]:
    sentences = []
    for cause in diagnosis.causes:
        others = join_words([format_effect(e) for e in cause.equivalents])
        confounded = f", or {others}: confounded in these records" if others else ""
        words = f"{format_effect(cause.effect)}{confounded}"
        sentences.append(f"{_begin(words)}: probability {format_percent(cause.probability)}.")
    sentences += [f"{name_term(t)}: probability of {describe_class(t)}." for t in diagnosis.terms]
    unknown = format_percent(diagnosis.unknown_probability)
    weight = ", but immaterial by the bound" if has_immaterial_cause(diagnosis) else ""
    sentences.append(f"A cause outside the catalogue takes part: probability {unknown}{weight}.")
    return [*sentences, *diagnosis.caveats]


def _mention_tolerated(diagnosis: Diagnosis) -> list[str]:
    """Names what is off within its tolerance, in a sentence; the page has a table of the values."""
    names = [format_effect(known.name) for known in diagnosis.within_tolerance]
    return [f"Off within tolerance, which is no gap: {join_words(names)}."] if names else []


def _label(words: str, effect: str) -> str:
    """A parameter's words before its value, unless the effect has the same name."""
    return "" if words == format_name(effect).removeprefix("nominal ") else f"{words} "


def _describe_cause(cause: Cause, result: CampaignDiagnosis) -> str:
    """The cause with its values, and those of the nominal device where they are not zero."""
    values = []
    for name, value in cause.parameters.items():
        words, unit, scale = parse_parameter(name)
        low, high = (scale * end for end in cause.interval_95[name])
        label = _label(words, cause.effect)
        nominal = scale * read_nominal_value(result.nominal, name)
        instead = f", not {format_number(nominal)}" if nominal else ""
        if cause.effect in NOISE_EFFECTS and not nominal:
            instead = ", where the nominal gyro states none"
        number = f"{format_interval(scale * value, low, high)} {unit}".rstrip()
        values.append(f"{label}{number}{instead}")
    weight = " (immaterial)" if result.diagnosis.is_immaterial(cause) else ""
    return f"{_begin(format_effect(cause.effect))}{weight}: {'; '.join(values)}."


def _describe_residuals(diagnosis: Diagnosis) -> list[str]:
    gap = diagnosis.gap
    figures = {"held-out": gap.holdout_angle_arcsec, "fitted": gap.fit_angle_arcsec}
    return [_describe_residual(role, f) for role, f in figures.items() if f is not None]


def _describe_residual(role: str, figure: GapFigure) -> str:
    has_after = figure.after != figure.before
    after = f" with the nominal gyro, {format_number(figure.after)} with the identified one"
    return (
        f"Angle residual on {role} tests, rms: {format_number(figure.before)} arcsec"
        f"{after if has_after else ''}; noise floor "
        f"{format_interval(figure.floor, *figure.floor_95)}."
    )


def _begin(sentence: str) -> str:
    return sentence[0].upper() + sentence[1:]
