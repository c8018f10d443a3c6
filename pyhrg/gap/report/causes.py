"""The causes that were found, and the hypotheses by posterior probability."""

import html
from collections.abc import Sequence

from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.svg import format_interval, format_number
from pyhrg.device.declarations import format_effect
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.findings.diagnosis import Cause, KnownValue
from pyhrg.gap.report.words import (
    build_table,
    format_group,
    format_percent,
    parse_parameter,
    read_nominal_value,
    show_share,
)

LISTED_SETS, LISTED_EFFECTS = 10, 10
"""Rows that the tables of sets and of single effects have at most."""
SMALLEST_PROBABILITY = 1e-3
"""Posterior probability below which a single effect has no row (chosen)."""


def build_causes(result: CampaignDiagnosis) -> str:
    """Tables of the named causes, a row a parameter, of the causes without a name, and of what is
    off within its tolerance."""
    diagnosis = result.diagnosis
    parts = []
    if diagnosis.causes:
        rows = [row for cause in diagnosis.causes for row in _make_rows(cause, result)]
        header = ("Effect", "Probability", "Parameter", "Value (95 % interval)", "Nominal", "Unit")
        made = ("Makes up to, arcsec", "deg/h", "Confounded with")
        title = "Total values, as in after.toml where it has them"
        parts.append(build_table(title, (*header, *made), rows))
    else:
        parts.append(make_paragraph("No effect of the catalogue is needed."))
    if diagnosis.unnamed:
        listed = [(html.escape(w), format_percent(p)) for w, p in diagnosis.unnamed.items()]
        parts.append(build_table("Outside the catalogue", ("Depends on", "Probability"), listed))
    if diagnosis.within_tolerance:
        columns = ("Effect", "Parameter", "Value (95 % interval)", "Stated", "Tolerance", "Unit")
        off = [_make_known_row(known) for known in diagnosis.within_tolerance]
        parts.append(build_table("Off within tolerance", columns, off))
    return "".join(parts)


def _make_known_row(known: KnownValue) -> tuple[str, ...]:
    words, unit, scale = parse_parameter(known.parameter)
    value, *interval = (scale * number for number in (known.value, *known.interval_95))
    stated, tolerance = (format_number(scale * size) for size in (known.stated, known.tolerance))
    names = (html.escape(name) for name in (format_effect(known.name), words))
    return *names, format_interval(value, *interval), stated, tolerance, unit


def _make_rows(cause: Cause, result: CampaignDiagnosis) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    sizes = cause.worth.sizes[:2] if cause.worth else ()
    makes = [*map(format_number, sizes)] or ["", ""]
    for i, (parameter, value) in enumerate(cause.parameters.items()):
        words, unit, scale = parse_parameter(parameter)
        nominal = scale * read_nominal_value(result.nominal, parameter)
        low, high = (scale * end for end in cause.interval_95[parameter])
        text = format_interval(scale * value, low, high)
        equivalents = html.escape(", ".join(format_effect(e) for e in cause.equivalents) or "–")
        weight = " (immaterial)" if result.diagnosis.is_immaterial(cause) else ""
        name = html.escape(f"{format_effect(cause.effect)}{weight}")
        effect = (f"<b>{name}</b>", format_percent(cause.probability))
        lead, last = (effect, (*makes, equivalents)) if i == 0 else (("", ""), ("", "", ""))
        rows.append((*lead, html.escape(words), text, format_number(nominal), unit, *last))
    return rows


def build_ranking(result: CampaignDiagnosis) -> str:
    """Tables of the noise hypotheses, of the sets of effects under the most probable noise, and of
    each effect by itself."""
    return _build_noises(result) + _build_sets(result) + _build_effects(result)


def _build_noises(result: CampaignDiagnosis) -> str:
    """Table of the noise hypotheses of the output angle; empty where there is only one."""
    posterior = result.attribution.posterior
    if len(posterior.hypotheses) < 2:
        return ""
    pairs = zip(posterior.hypotheses, posterior.probabilities, strict=True)
    rows = [
        (
            html.escape(" + ".join(_list_noises(hypothesis.noise)) or "nominal"),
            _name_set(hypothesis.ranking.best.groups),
            *show_share(probability),
        )
        for hypothesis, probability in pairs
    ]
    title = "Noise hypotheses of the output angle, each with its most probable set of effects"
    return build_table(title, ("Noise", "Set", "Probability", ""), rows)


def _list_noises(noise: NoiseHypothesis) -> list[str]:
    named = [format_effect(added.effect.name) for added in noise.added]
    return named + ([f"unnamed: {noise.unnamed.words}"] if noise.unnamed else [])


def _name_set(groups: Sequence[Group]) -> str:
    return html.escape(" + ".join(format_group(group) for group in groups) or "no effect")


def _build_sets(result: CampaignDiagnosis) -> str:
    ranking = result.attribution.ranking
    best = ranking.best.log_evidence
    pairs = list(zip(ranking.fits, ranking.probabilities, strict=True))
    rows = [
        (
            _name_set(fit.groups),
            *show_share(probability),
            format_number(fit.log_evidence - best),
            str(sum(len(v) for v in fit.values)),
        )
        for fit, probability in pairs[:LISTED_SETS]
    ]
    others = sum(p for _, p in pairs[LISTED_SETS:])
    if others:
        count = f"{len(pairs) - LISTED_SETS} other sets"
        rows.append((count, *show_share(others), "", ""))
    header = ("Set", "Probability", "", "ln Bayes factor to the best", "Fitted numbers")
    return build_table("Sets of effects under the most probable noise", header, rows)


def _build_effects(result: CampaignDiagnosis) -> str:
    posterior = result.attribution.posterior
    names = {name for hypothesis in posterior.hypotheses for name in hypothesis.every_name}
    known = posterior.best.exact.effects  # causes by their tolerance, not by this probability
    names -= {effect.name for effect in known}
    chances = [(posterior.probability(name), format_effect(name)) for name in names]
    chances += [(p, f"unnamed: {words}") for words, p in posterior.list_unnamed().items()]
    chances = sorted(chances, key=lambda chance: (-chance[0], chance[1]))[:LISTED_EFFECTS]
    rows = [(html.escape(w), *show_share(p)) for p, w in chances if p > SMALLEST_PROBABILITY]
    if not rows:
        return ""
    title = (
        "Probability of each effect, summed over all sets and noise hypotheses; from "
        f"{format_percent(SMALLEST_PROBABILITY)}"
    )
    return build_table(title, ("Effect", "Probability", ""), rows)
