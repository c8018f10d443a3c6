"""What was found, and the sets of effects by probability."""

import html

from pyhrg.common.pages.markup import paragraph
from pyhrg.common.pages.svg import number
from pyhrg.device.keys import KEYS
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.evidence.noise.noise_search import NoiseFound
from pyhrg.gap.findings.diagnosis import Cause
from pyhrg.gap.report.words import (
    bar,
    effect_words,
    group_words,
    markup_table,
    percent,
    unit_of,
    value_words,
)

SETS, GROUPS = 10, 10
"""Listed at most."""
LEAST = 1e-3
"""Probability below which an effect isn't listed."""


def causes(found: Diagnosed) -> str:
    """A row a parameter."""
    said = found.diagnosis
    parts = []
    if said.causes:
        rows = [row for cause in said.causes for row in _rows(cause, found)]
        header = ("Effect", "Probability", "Parameter", "Value (95 % interval)", "Believed", "Unit")
        title = "Total values, as after.toml has them"
        parts.append(markup_table(title, (*header, "Can't be told from"), rows))
    else:
        parts.append(paragraph("No effect of the catalogue is needed."))
    if said.unnamed:
        listed = [(html.escape(w), percent(p)) for w, p in said.unnamed.items()]
        parts.append(markup_table("Without a name", ("What it follows", "Probability"), listed))
    return "".join(parts)


def _rows(cause: Cause, found: Diagnosed) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = []
    for i, (name, value) in enumerate(cause.parameters.items()):
        words, unit, scale = unit_of(name)
        key = next(k for k in KEYS if k.name == name)
        believed = key.from_si(getattr(found.believed, key.field)) * scale
        low, high = (scale * end for end in cause.interval_95[name])
        told = value_words(scale * value, low, high)
        others = ", ".join(effect_words(e) for e in cause.equivalents) or "–"
        first = (f"<b>{effect_words(cause.effect)}</b>", percent(cause.probability))
        last = others if not i else ""
        lead = first if not i else ("", "")
        rows.append((*lead, words, told, number(believed), unit, last))
    return rows


def ranking(found: Diagnosed) -> str:
    """Noises, sets under the likeliest of them, then effects by themselves."""
    return _noises(found) + _sets(found) + _effects(found)


def _noises(found: Diagnosed) -> str:
    """What the output angle's noise may be, if there is any choice."""
    weighed = found.attribution.weighed
    if len(weighed.hypotheses) < 2:
        return ""
    rows = [
        (
            html.escape(" + ".join(_noise_words(one.noise)) or "as believed"),
            html.escape(" + ".join(group_words(g) for g in one.ranked.best.groups) or "nothing"),
            percent(probability),
            bar(probability),
        )
        for one, probability in zip(weighed.hypotheses, weighed.probabilities, strict=True)
    ]
    title = "Noise of the output angle, each with its most probable set"
    return markup_table(title, ("Noise", "Set", "Probability", ""), rows)


def _noise_words(noise: NoiseFound) -> list[str]:
    named = [effect_words(added.effect.name) for added in noise.added]
    return named + ([f"unnamed: {noise.nameless.words}"] if noise.nameless else [])


def _sets(found: Diagnosed) -> str:
    ranked = found.attribution.ranked
    best = ranked.best.log_evidence
    pairs = list(zip(ranked.fits, ranked.probabilities, strict=True))
    rows = [
        (
            html.escape(" + ".join(group_words(g) for g in fit.groups) or "nothing at all"),
            percent(probability),
            bar(probability),
            number(fit.log_evidence - best),
            str(sum(len(v) for v in fit.values)),
        )
        for fit, probability in pairs[:SETS]
    ]
    rest = sum(p for _, p in pairs[SETS:])
    if rest:
        rows.append((f"{len(pairs) - SETS} other sets", percent(rest), bar(rest), "", ""))
    header = ("Set", "Probability", "", "ln evidence, less the best's", "Numbers fitted")
    return markup_table(
        "Sets of effects under the likeliest noise, the most probable first", header, rows
    )


def _effects(found: Diagnosed) -> str:
    weighed = found.attribution.weighed
    names = {name for one in weighed.hypotheses for name in one.every_name}
    chances = [(weighed.probability(name), effect_words(name)) for name in names]
    chances += [(p, f"unnamed: {words}") for words, p in weighed.unnamed().items()]
    listed = sorted(chances, key=lambda chance: (-chance[0], chance[1]))[:GROUPS]
    rows = [(html.escape(w), percent(p), bar(p)) for p, w in listed if p > LEAST]
    if not rows:
        return ""
    title = f"Each effect alone, in whatever set and beside whatever noise; from {percent(LEAST)}"
    return markup_table(title, ("Effect", "Probability", ""), rows)
