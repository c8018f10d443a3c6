"""The diagnosis in sentences, and as a few lines for the terminal."""

from pyhrg.common.pages.svg import format_number
from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis, KnownValue
from pyhrg.gap.report.closing import describe_closing
from pyhrg.gap.report.words import (
    format_effect,
    format_interval,
    format_name,
    format_percent,
    format_value,
    join_words,
    parse_parameter,
)

FAMILIES = {
    "gyro": "the gyro",
    "nominal": "the nominal values",
    "bench": "the bench",
    "record": "the record",
}
"""Where a cause lies, in words."""


def write_headline(diagnosis: Diagnosis) -> str:
    """The verdict in one sentence."""
    names = join_words([format_effect(c.effect) for c in diagnosis.causes])
    is_single = len(diagnosis.causes) == 1
    if diagnosis.verdict == "no_gap":
        if diagnosis.within_tolerance or diagnosis.left.angle_arcsec:
            return "No gap: the records agree with the simulation within tolerances and noise."
        return "No gap: the records agree with the simulation of the nominal gyro within the noise."
    if diagnosis.verdict == "explained":
        where = join_words(list(dict.fromkeys(FAMILIES[c.family] for c in diagnosis.causes)))
        causes = "its cause is" if is_single else "its causes are"
        return f"The gap is explained, and lies in {where}: {causes} {names}."
    if diagnosis.verdict == "ambiguous":
        others = "effects that these records can't separate from it"
        return f"The gap is explained by {names}, or by {others}."
    beside = f", beside {names}" if names else ""
    return f"The gap is not explained: a cause outside the catalogue takes part{beside}."


def describe_diagnosis(result: CampaignDiagnosis) -> list[str]:
    """Sentences on causes, reservations, residuals and the next test."""
    diagnosis, test = result.diagnosis, result.diagnosis.next_test
    return [
        *(_describe_cause(cause) for cause in diagnosis.causes),
        f"Probability that a cause outside the catalogue takes part: "
        f"{format_percent(diagnosis.unknown_probability)}.",
        describe_leftover(diagnosis),
        *(_describe_known(known) for known in diagnosis.within_tolerance),
        *diagnosis.caveats,
        *_describe_residual(diagnosis),
        *describe_closing(diagnosis.gap),
        *([f"Next test: {format_name(test.kind)}, {test.hours:g} h. {test.why}"] if test else []),
    ]


def summarize_diagnosis(result: CampaignDiagnosis) -> str:
    """Verdict, causes, reservations, angle residuals and the next test, a line each."""
    diagnosis = result.diagnosis
    lines = [f"{diagnosis.device}: {format_name(diagnosis.verdict)}"]
    for cause in diagnosis.causes:
        values = ", ".join(f"{name} {value:.4g}" for name, value in cause.parameters.items())
        lines.append(f"  {cause.effect}: probability {cause.probability:.3f}  {values}")
        if cause.equivalents:
            lines.append(f"    confounded with {', '.join(cause.equivalents)}")
    for known in diagnosis.within_tolerance:
        lines.append(
            f"  within tolerance: {known.name}: {known.parameter} {known.value:.6g}, "
            f"told {known.told:.6g}"
        )
    unknown = diagnosis.unknown_probability
    lines.append(f"  a cause outside the catalogue: probability {unknown:.3f}")
    lines.append(f"  {describe_leftover(diagnosis)}")
    lines += [f"  {caveat}" for caveat in diagnosis.caveats]
    gap = diagnosis.gap
    figures = (("fitted", gap.fit_angle_arcsec), ("held-out", gap.holdout_angle_arcsec))
    for role, figure in figures:
        if figure is not None:
            lines.append(
                f"  angle residual, {role} tests: {figure.before:.3g} -> {figure.after:.3g} arcsec;"
                f" noise floor {figure.floor:.3g} "
                f"({figure.floor_95[0]:.3g} to {figure.floor_95[1]:.3g})"
            )
    if diagnosis.next_test is not None:
        test = diagnosis.next_test
        lines.append(f"  next test: {test.kind}, {test.hours:g} h - {test.why}")
    return "\n".join(lines)


def describe_leftover(diagnosis: Diagnosis) -> str:
    """What the explanation leaves, and whether it matters, in a sentence."""
    left, bound = diagnosis.left, diagnosis.bound
    sizes = (
        f"{format_number(left.angle_arcsec)} arcsec, {format_number(left.rate_deg_h)} deg/h "
        f"({format_number(left.document()['position_m'])} m after an hour)"
    )
    limits = f"{bound.angle_arcsec:g} arcsec, {bound.rate_deg_h:g} deg/h"
    role = "material" if left.exceeds(bound) else "immaterial"
    return f"Left unexplained: {sizes}; {role} by the bound of {limits}."


def _describe_known(known: KnownValue) -> str:
    words, unit, scale = parse_parameter(known.parameter)
    low, high = (scale * end for end in known.interval_95)
    value = format_value(scale * known.value, low, high)
    return (
        f"Within its tolerance: {format_name(known.name)}: {words} {value} {unit}, told "
        f"{format_number(scale * known.told)} {unit}."
    )


def _describe_cause(cause: Cause) -> str:
    values = []
    for name, value in cause.parameters.items():
        words, unit, scale = parse_parameter(name)
        low, high = (scale * end for end in cause.interval_95[name])
        label = "" if words == format_name(cause.effect) else f"{words} "
        values.append(f"{label}{format_value(scale * value, low, high)} {unit}")
    sentence = f"{format_effect(cause.effect)}: {', '.join(values)}"
    others = [format_effect(e) for e in cause.equivalents]
    confounded = f"; confounded with {join_words(others)} in these records" if others else ""
    sentence = f"{sentence}; probability {format_percent(cause.probability)}{confounded}."
    return sentence[0].upper() + sentence[1:]


def _describe_residual(diagnosis: Diagnosis) -> list[str]:
    figure = diagnosis.gap.holdout_angle_arcsec
    if figure is None:
        return []
    has_after = figure.after != figure.before
    after = f" with the nominal gyro, {format_number(figure.after)} with the identified one"
    return [
        f"Angle residual on held-out tests, rms: {format_number(figure.before)} arcsec"
        f"{after if has_after else ''}; noise floor "
        f"{format_interval(figure.floor, *figure.floor_95)}."
    ]
