"""Compares diagnoses with truths, and checks the calibration of the stated probabilities."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from pyhrg.challenge.scoring.figure import (
    CONFIDENCE,
    RESAMPLES,
    Figure,
    Sense,
    proportion,
    quantile,
)
from pyhrg.challenge.scoring.named import (
    AnyCase,
    RefusedCase,
    ScoredCase,
    has_all_named,
    has_none_invented,
    is_family_right,
    is_right,
    is_unexplained,
    is_wrong,
    list_answered,
    list_named,
    merge_classes,
    score_names,
)
from pyhrg.challenge.truths.truth import DETECTION_SIGMAS
from pyhrg.common.arrays import Array
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import Device
from pyhrg.device.keys import KEYS
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.findings.diagnosis import Diagnosis
from pyhrg.gap.findings.localisation import sum_shares

BINS = 10
"""Number of bins of claims by their probability, with equal counts."""
Claims = Sequence[tuple[float, bool]]
"""Stated probability of each claim, and whether the claim is true."""


def compute_squared_error(claims: Array) -> float:
    """Mean squared calibration error of (n, 2) probabilities and outcomes over bins of equal count,
    bias-corrected. It can be negative by chance.

    In each bin the variance of the mean outcome is taken out: A. Kumar, P. Liang, T. Ma, Verified
    Uncertainty Calibration (2019), Def. 3.1.
    """
    ordered = claims[np.lexsort(claims.T[::-1])]
    total = 0.0
    for part in np.array_split(ordered, min(BINS, len(ordered) // 2)):
        stated, true = part[:, 0].mean(), part[:, 1].mean()
        total += len(part) * ((stated - true) ** 2 - true * (1 - true) / (len(part) - 1))
    return float(total / len(ordered))


def score_calibration(
    name: str, campaigns: Sequence[Claims], seed: int, sense: Sense, target: float
) -> Figure:
    """The root of the squared calibration error, not below zero, and its interval by resampling
    campaigns.

    The interval is the basic one of the bootstrap (A. Davison, D. Hinkley, 1997, Eq. 5.6), for the
    square: resampling repeats outcomes, which looks like an error, and that is taken out. Claims of
    one campaign are correlated, so campaigns are drawn whole.
    """
    by_campaign = [np.array(campaign, dtype=np.float64).reshape(-1, 2) for campaign in campaigns]
    claims = np.concatenate([np.empty((0, 2)), *by_campaign])
    if len(claims) < 2:
        return Figure(name, 0, math.nan, 0.0, 1.0, sense, target)
    square = compute_squared_error(claims)
    generator = np.random.default_rng(seed)
    drawn = []
    for _ in range(RESAMPLES):
        chosen = generator.integers(len(campaigns), size=len(campaigns)).tolist()
        again = np.concatenate([by_campaign[i] for i in chosen])
        drawn.append(compute_squared_error(again) if len(again) > 1 else square)
    tail = (1 - CONFIDENCE) / 2
    below, above = np.quantile(drawn, (tail, 1 - tail)).tolist()
    ends = (_take_root(2 * square - above), _take_root(2 * square - below))
    return Figure(name, len(claims), _take_root(square), *ends, sense, target)


def _take_root(square: float) -> float:
    return math.sqrt(max(0.0, square))


COORDINATES = {
    effect.name: frozenset(effect.coordinates)
    for declaration in read_declarations(Device).values()
    for effect in (declaration.effect, declaration.noise)
    if effect
}
"""Coordinates in which the greatest share of an effect's gap may lie, by the effect's name; both
as the record format calls them. A catalogue may lack the effect."""
STRENGTH_EDGES = (1.0, 1.5, 2.0, 3.0, 4.0, DETECTION_SIGMAS, 10.0, 20.0, math.inf)
"""Edges of the strengths that the points of a curve stand for, sigmas."""


@dataclass(frozen=True)
class CurvePoint:
    """Single effects within a range of strengths, sigmas, and the number that was rightly named."""

    low: float
    high: float
    right: Figure


def score_figures(cases: Sequence[AnyCase], seed: int) -> list[Figure]:
    """All figures with their targets (docs/methods/challenge.md); seed: of the resampling."""
    by_kind: dict[str, list[AnyCase]] = {}
    for case in cases:
        by_kind.setdefault(case.truth.kind, []).append(case)
    none, outside, left_out = (by_kind.get(kind, []) for kind in ("none", "outside", "left_out"))
    single, pair, several = (by_kind.get(kind, []) for kind in ("single", "pair", "several"))
    known = single + pair
    answered = list_answered(known + several)
    claims = [list_claims(case) for case in list_answered(none + known + several + outside)]
    ratios = [ratio for ratio in map(find_residual_over_noise, answered) if ratio is not None]
    areas = [area for area in map(find_areas_over_floor, answered) if area is not None]
    before, after = ([area[stage] for area in areas] for stage in (0, 1))
    covered = [covered for case in answered for covered in list_coverage(case)]
    removed = [find_removed_share(case) for case in list_answered(outside)]
    shares = [share for share in removed if share is not None]
    settled = [is_settled(case) for case in answered if case.then]
    refused = [isinstance(case, RefusedCase) for case in cases]
    return [
        _share("false alarm without a gap", none, is_alarm, "at most", 0.02),
        _share("single: right effect or its class", single, is_right, "at least", 0.95),
        _share("pair: right effects or their classes", pair, is_right, "at least", 0.90),
        _share("several: all named", several, has_all_named, "at least", 0.85),
        _share("several: none invented", several, has_none_invented, "at least", 0.95),
        _share("effects: blamed on another", known + several, is_wrong, "at most", 0.03),
        _share("where: gyro, nominal, bench or record", cases, is_family_right, "at least", 0.98),
        _share("outside: recognised", outside, is_unexplained, "at least", 0.90),
        _share("outside: blamed on a named effect", outside, is_blamed, "at most", 0.03),
        _share("outside: a term in the right coordinate", outside, is_placed, "at least", 0.80),
        quantile("outside: held-out excess removed, median", shares, 0.5, "at least", 0.90),
        quantile("outside: held-out excess removed, 25 %", shares, 0.25, "at least", 0.70),
        _share("a term where there is none", none + known, has_term, "at most", 0.02),
        _share("left out: none of these, or a stand-in", left_out, is_owned, "at least", 0.85),
        *score_names(cases, seed),
        proportion("95 % intervals that cover", covered, "about", 0.95),
        score_calibration("calibration error", claims, seed, "at most", 0.05),
        quantile("held-out residual over noise, median", ratios, 0.5, "at most", 1.1),
        quantile("held-out residual over noise, 90 %", ratios, 0.9, "at most", 1.3),
        quantile("held-out area over its floor, before: median", before, 0.5, "at least", 0.0),
        quantile("held-out area over its floor, after: median", after, 0.5, "at most", 1.3),
        proportion("next test settles the class", settled, "at least", 0.95),
        proportion("diagnosis refused", refused, "at most", 0.0),
    ]


def score_curve(cases: Sequence[AnyCase]) -> list[CurvePoint]:
    """How often one effect is rightly named, by its strength."""
    single = [case for case in cases if case.truth.kind in ("single", "weak")]
    points = []
    for low, high in pairwise(STRENGTH_EDGES):
        within = [case for case in single if low <= case.truth.strengths[0] < high]
        points.append(CurvePoint(low, high, _share("right", within, is_right, "at least", 0.0)))
    return points


def _share(
    name: str,
    cases: Sequence[AnyCase],
    judge: Callable[[ScoredCase], bool],
    sense: Sense,
    target: float,
) -> Figure:
    """A share of campaigns; one that was refused counts against the diagnosis."""
    refused = sense == "at most"
    outcomes = [judge(c) if isinstance(c, ScoredCase) else refused for c in cases]
    return proportion(name, outcomes, sense, target)


def is_alarm(case: ScoredCase) -> bool:
    """The diagnosis states a gap that is not there."""
    return is_wrong(case) or case.diagnosis.verdict == "unexplained"


def is_blamed(case: ScoredCase) -> bool:
    """The diagnosis explains the gap by named causes alone, and not all of them are there."""
    return not is_unexplained(case) and is_wrong(case)


def is_placed(case: ScoredCase) -> bool:
    """A proposed term has the coordinate of the true form."""
    return any(case.truth.coordinate in term.coordinates for term in case.diagnosis.terms)


def has_term(case: ScoredCase) -> bool:
    """A term is proposed."""
    return bool(case.diagnosis.terms)


def find_removed_share(case: ScoredCase) -> float | None:
    """Share of the held-out excess over the noise floor that closing removes; None where there is
    no excess."""
    percent = case.diagnosis.gap.shrink_percent
    return None if percent is None else percent / 100


def is_owned(case: ScoredCase) -> bool:
    """Whether an effect that was left out of the catalogue was stated as unnamed in one of its
    coordinates, or named as an effect that is confounded with it in these tests."""
    truth, diagnosis = case.truth, case.diagnosis
    if is_unexplained(case):
        return find_main_coordinate(diagnosis) in COORDINATES[truth.effects[0]]
    named, stand_ins = list_named(diagnosis), set(truth.stand_ins)
    allowed = stand_ins | {*truth.beyond}
    is_there = any(effects & stand_ins for effects in named)
    return is_there and all(effects & allowed for effects in named)


def find_main_coordinate(diagnosis: Diagnosis) -> str | None:
    """The coordinate with the largest share of the gap."""
    shares = sum_shares(diagnosis.where, lambda place: place.coordinate)
    return max(shares, key=lambda name: shares[name]) if shares else None


def find_residual_over_noise(case: ScoredCase) -> float | None:
    """Held-out angle residual of the identified device over the rms of the true noise in the same
    records."""
    figure, noise = case.diagnosis.gap.holdout_angle_arcsec, case.truth.holdout_noise_arcsec
    return figure.after / noise if figure and figure.after > 0 and noise is not None else None


def find_areas_over_floor(case: ScoredCase) -> tuple[float, float] | None:
    """Area validation metric of the nominal and of the identified device on the held-out tests,
    over the median of what noise leaves of it."""
    figure = case.diagnosis.gap.holdout_area_arcsec
    return (figure.before / figure.floor, figure.after / figure.floor) if figure else None


def is_settled(case: ScoredCase) -> bool:
    """Whether exactly the true effects were named with the next test, beside known parameters that
    are beyond their tolerance."""
    if case.then is None or case.then.verdict != "explained":
        return False
    true = {frozenset({effect}) for effect in case.truth.effects}
    beyond = {*case.truth.beyond} - {*case.truth.effects}
    named = {*list_named(case.then)}
    return true <= named and all(each & beyond for each in named - true)


def list_claims(case: ScoredCase) -> list[tuple[float, bool]]:
    """Each stated probability, and whether its claim is true."""
    unknown = (case.diagnosis.unknown_probability, case.truth.kind == "outside")
    true = {*case.truth.effects, *case.truth.beyond}
    return [*((p, bool(effects & true)) for effects, p in merge_classes(case.diagnosis)), unknown]


def list_coverage(case: ScoredCase) -> list[bool]:
    """Whether each interval of an effect that is there holds the truth."""
    return [
        _is_within(case.truth.parameters[name], ends, _get_period(cause.effect, name))
        for cause in case.diagnosis.causes
        if cause.effect in case.truth.effects
        for name, ends in cause.interval_95.items()
        if name in case.truth.parameters
    ]


def _is_within(value: float, ends: tuple[float, float], period: float) -> bool:
    """Whether a value, modulo its period, is within an interval."""
    low, high = ends
    if math.isfinite(period):
        value = low + (value - low) % period
    return low <= value <= high


def _get_period(effect: str, name: str) -> float:
    """Period of an angle in the file's unit; infinite for other parameters."""
    entry = EFFECTS.get(effect)
    if entry is None or not entry.periods:
        return math.inf
    key = next(key for key in KEYS if key.name == name)
    return 360.0 / entry.periods if key.field == entry.fields[1] else math.inf
