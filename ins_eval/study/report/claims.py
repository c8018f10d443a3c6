"""The claims that a study decides, each with its own verdict, in words and by mission class."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from ins_eval.study.report.figures.matrix import name_negative_r2
from ins_eval.study.report.figures.parts import name_calibration
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables.columns import (
    ANY_ANGLE,
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    FITTED_MAP,
    FIXED_MEAN,
    FIXED_RULE,
    TRUE_PARAMETERS,
    TURN_ON,
)
from ins_eval.study.tables.score import (
    ALL,
    COVERAGE,
    FAILS,
    FLIGHT_SPEARMAN,
    FLIGHT_SPEARMAN_GAIN,
    HOLDS,
    MEDIAN_RATIO,
    MOUNTING_SHARE,
    R2_MOUNTED,
    R2_OVER_FIXED,
    R2_OVER_FIXED_MEAN,
    R2_RADIAL,
    R2_SHORTFALL,
    SKILL_OVER_CLASS,
    SKILL_OVER_FIXED,
    SPEARMAN,
    UNDECIDED,
    Score,
)
from pyhrg.common.pages.svg import format_estimate

IN_PART = "holds in part"
NO_FAILURE = "no figure"


@dataclass(frozen=True)
class Claim:
    """A claim. letter: its name; statement: a sentence; parts: score, predictor and words of each
    requirement; beside: the same of figures that explain the claim and have no requirement."""

    letter: str
    statement: str
    parts: tuple[tuple[str, str, str], ...]
    beside: tuple[tuple[str, str, str], ...] = ()


RANK = "rank correlation with the gyro's rms error (linear model, start angle averaged out)"
FLIGHT_RANK = "rank correlation with single flights (co-simulated)"
CLAIMS = (
    Claim(
        "a",
        "In-run stability at a fixed position neither ranks gyros nor gives the size of the error",
        (
            (SPEARMAN, FIXED_RULE, RANK),
            (MEDIAN_RATIO, FIXED_RULE, "flown / predicted, by 0.01 deg/h = 1 nmi/h"),
        ),
        (
            (FLIGHT_SPEARMAN, FIXED_RULE, FLIGHT_RANK),
            (SPEARMAN, TURN_ON, "the same test's repeatability over turn-ons, same linear rank"),
            (R2_RADIAL, FIXED_MEAN, "R2 of single flights by the same test's mean bias"),
        ),
    ),
    Claim(
        "b",
        "The full circumference ranks gyros and gives the size of the error",
        (
            (SPEARMAN, CIRCUMFERENCE_RULE, RANK),
            (MEDIAN_RATIO, CIRCUMFERENCE_CLASS, "flown / predicted, by the class constant"),
            (
                SKILL_OVER_FIXED,
                CIRCUMFERENCE_CLASS,
                "interval score saved over the fixed position with its own class constant",
            ),
            (
                SKILL_OVER_CLASS,
                CIRCUMFERENCE_CLASS,
                "interval score saved over the class alone, no bench test",
            ),
        ),
        (
            (FLIGHT_SPEARMAN, CIRCUMFERENCE_RULE, FLIGHT_RANK),
            (FLIGHT_SPEARMAN_GAIN, CIRCUMFERENCE_RULE, f"{FLIGHT_RANK} less the fixed position's"),
            (R2_RADIAL, CIRCUMFERENCE_CLASS, "R2 of single flights, by the class constant"),
            (
                R2_OVER_FIXED,
                CIRCUMFERENCE_CLASS,
                "R2 less that of the fixed position, own constant",
            ),
        ),
    ),
    Claim(
        "c",
        "The fitted map and the trajectory predict each flight",
        (
            (R2_RADIAL, FITTED_MAP, "R2 of single flights"),
            (COVERAGE, FITTED_MAP, "share of flights inside the predicted intervals"),
        ),
        (
            (R2_RADIAL, ANY_ANGLE, "R2 with the start angle unknown"),
            (R2_OVER_FIXED_MEAN, FITTED_MAP, "R2 less that of the fixed position's mean bias"),
            (R2_RADIAL, TRUE_PARAMETERS, "R2 of the true maps, mounting unknown: the ceiling"),
            (R2_SHORTFALL, FITTED_MAP, "ceiling less R2 of the fitted map"),
            (MOUNTING_SHARE, "", "share of the mean square error due to mounting"),
            (R2_MOUNTED, FITTED_MAP, "R2 of north and east, mounting's part taken out"),
        ),
    ),
)


@dataclass(frozen=True)
class JudgedClaim:
    """A claim and its scores: those of each class, which decide, those over all classes, and those
    that explain it."""

    claim: Claim
    by_class: Sequence[Score]
    overall: Sequence[Score]
    beside: Sequence[Score]

    @property
    def verdict(self) -> str:
        """`HOLDS` where it holds in all classes, `IN_PART` where in some; where in none, `FAILS` if
        it fails in any, else `UNDECIDED`."""
        verdicts = [self.judge_class(name) for name in self.classes]
        if HOLDS in verdicts:
            return HOLDS if set(verdicts) == {HOLDS} else IN_PART
        return FAILS if FAILS in verdicts else UNDECIDED

    def judge_class(self, name: str) -> str:
        """The verdict in a class: `HOLDS` if all requirements do, `FAILS` if one fails."""
        verdicts = {score.verdict for score in self.by_class if score.mission_class == name}
        if verdicts == {HOLDS}:
            return HOLDS
        return FAILS if FAILS in verdicts else UNDECIDED

    @property
    def n(self) -> int:
        """Number of judged triads."""
        return max((score.n for score in self.by_class), default=0)

    @property
    def classes(self) -> list[str]:
        """Names of the classes that decide."""
        return list(dict.fromkeys(score.mission_class for score in self.by_class))


def judge_claims(data: StudyData, calibration: str) -> list[JudgedClaim]:
    """The claims on the judged triads of a calibration; none without scores."""
    order = {name: place for place, name in enumerate(data.classes, 1)}
    scores = sorted(
        (s for s in data.scores if s.calibration == calibration and not s.shuffled),
        key=lambda s: order.get(s.mission_class, 0),
    )
    judged = [_judge(claim, scores) for claim in CLAIMS]
    return [each for each in judged if each.by_class]


def state_claims(data: StudyData) -> str:
    parts = []
    for calibration in data.calibrations:
        judged = judge_claims(data, calibration)
        verdicts = ", ".join(f"({each.claim.letter}) {each.verdict}" for each in judged)
        parts.append(f"{name_calibration(calibration)}: {verdicts or 'no claim was scored'}")
    text = "; ".join(parts)
    return f"{text[:1].upper()}{text[1:]}."


def judge_conditions(data: StudyData) -> list[JudgedClaim]:
    """The claims in the conditions, which stand in the place of classes; none without them."""
    if data.conditions is None:
        return []
    scores = [s for s in data.conditions.scores if not s.shuffled]
    return [_judge(claim, scores) for claim in CLAIMS]


@dataclass(frozen=True)
class ConditionResult:
    """Verdicts of the claims in a condition of claim (d).

    Attributes:
        name: name of the condition.
        n: number of triads.
        figures: claim, requirement and figure of each score, by its verdict.
    """

    name: str
    n: int
    figures: Mapping[str, Sequence[str]]

    @property
    def lines(self) -> list[str]:
        """What fails, what its interval leaves undecided, what holds."""
        return [
            f"{verdict}: {'; '.join(figures) or NO_FAILURE}"
            for verdict, figures in self.figures.items()
            if figures or verdict == FAILS
        ]


def list_conditions(data: StudyData) -> list[ConditionResult]:
    """Claim (d), a result for each condition."""
    judged = judge_conditions(data)

    def describe(name: str, verdict: str) -> list[str]:
        return [
            f"({each.claim.letter}) {name_requirement(each.claim, s)} {format_score(s)}"
            for each in judged
            for s in each.by_class
            if (s.mission_class, s.verdict) == (name, verdict)
        ]

    return [
        ConditionResult(
            name,
            max(s.n for each in judged for s in each.by_class if s.mission_class == name),
            {verdict: describe(name, verdict) for verdict in (FAILS, UNDECIDED, HOLDS)},
        )
        for name in (data.conditions.classes if data.conditions else [])
    ]


def describe_claim(judged: JudgedClaim) -> str:
    """A claim with its verdict; below it a line for each requirement and class."""
    claim, wide = judged.claim, max(map(len, judged.classes))
    head = f"({claim.letter}) {claim.statement}: {judged.verdict.upper()}"
    lines = [f"{head} (n = {judged.n} triads)"]
    for words, scores in groupby(judged.by_class, lambda score: name_requirement(claim, score)):
        here = list(scores)
        lines.append(f"    {words}, required {here[0].asked}:")
        lines += [
            f"        {s.mission_class:<{wide}}  {format_score(s)}: {s.verdict}" for s in here
        ]
    return "\n".join(lines)


def describe_conditions(data: StudyData) -> list[str]:
    """The verdict of each claim in each condition, a line for each condition."""
    judged, counts = judge_conditions(data), {each.name: each.n for each in list_conditions(data)}
    wide = max(map(len, counts), default=0)
    return [
        f"{name:<{wide}}  n = {n}: "
        + ", ".join(f"({each.claim.letter}) {each.judge_class(name)}" for each in judged)
        for name, n in counts.items()
    ]


def format_score(score: Score) -> str:
    """A score with its interval; an R2 below zero in words too."""
    value, low, high = format_estimate(score.value, score.low, score.high)
    words = name_negative_r2(score)
    return f"{value} ({low} to {high})" + (f", {words}" if words else "")


def name_requirement(claim: Claim, score: Score) -> str:
    """The requirement of a claim that a score answers, or the figure beside it, in words."""
    return next(
        words
        for key, predictor, words in claim.parts + claim.beside
        if (key, predictor) == (score.score, score.predictor)
    )


def _judge(claim: Claim, scores: Sequence[Score]) -> JudgedClaim:
    asked, beside = (_pick(scores, parts) for parts in (claim.parts, claim.beside))
    asked = [s for s in asked if s.verdict]
    return JudgedClaim(
        claim,
        [s for s in asked if s.mission_class != ALL],
        [s for s in asked if s.mission_class == ALL],
        beside,
    )


def _pick(scores: Sequence[Score], parts: Sequence[tuple[str, str, str]]) -> list[Score]:
    """Scores of these kinds, in the order of the kinds."""
    kinds = [(score, predictor) for score, predictor, _ in parts]
    picked = [s for s in scores if (s.score, s.predictor) in kinds]
    return sorted(picked, key=lambda s: kinds.index((s.score, s.predictor)))
