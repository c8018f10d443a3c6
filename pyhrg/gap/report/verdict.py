"""A diagnosis in plain words."""

from pyhrg.common.pages.svg import number
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis
from pyhrg.gap.report.closing import sentences as closed_by
from pyhrg.gap.report.words import effect_words, listed, percent, plain, unit_of, value_words


def headline(said: Diagnosis) -> str:
    """In one sentence."""
    names = listed([effect_words(c.effect) for c in said.causes])
    one = len(said.causes) == 1
    if said.verdict == "no_gap":
        return "No gap: the gyro answers as its simulation does, but for noise."
    if said.verdict == "explained":
        return f"The gap is explained: {names} {'makes' if one else 'make'} it."
    if said.verdict == "ambiguous":
        return f"The gap is explained by {names}, or by what these data can't tell from it."
    beside = f", beside {names}" if names else ""
    return f"The gap is not explained: something outside the catalogue takes part{beside}."


def sentences(found: Diagnosed) -> list[str]:
    """What follows, from figures of the diagnosis alone."""
    said = found.diagnosis
    return [
        *(_cause(cause) for cause in said.causes),
        f"Something outside the catalogue takes part with a probability of "
        f"{percent(said.unknown_probability)}.",
        *said.caveats,
        *_distance(said),
        *closed_by(said.gap),
        *_next(said),
    ]


def _cause(cause: Cause) -> str:
    told = []
    for name, value in cause.parameters.items():
        words, unit, scale = unit_of(name)
        low, high = (scale * end for end in cause.interval_95[name])
        known = "" if words == plain(cause.effect) else f"{words} "
        told.append(f"{known}{value_words(scale * value, low, high)} {unit}")
    sentence = f"{effect_words(cause.effect)}: {', '.join(told)}"
    others = [effect_words(e) for e in cause.equivalents]
    class_ = f"; these data can't tell it from {listed(others)}" if others else ""
    sentence = f"{sentence}; probability {percent(cause.probability)}{class_}."
    return sentence[0].upper() + sentence[1:]


def _distance(said: Diagnosis) -> list[str]:
    figure = said.gap.holdout_angle_arcsec
    if figure is None:
        return []
    after = "" if figure.after == figure.before else f" before, {number(figure.after)} after"
    return [
        f"On held-out tests simulation and gyro are {number(figure.before)} arcsec apart{after}; "
        f"noise alone leaves {number(figure.floor)} "
        f"({number(figure.floor_95[0])} to {number(figure.floor_95[1])})."
    ]


def _next(said: Diagnosis) -> list[str]:
    if said.next_test is None:
        return []
    test = said.next_test
    return [f"Next test: {test.kind.replace('_', ' ')}, {test.hours:g} h. {test.why}"]
