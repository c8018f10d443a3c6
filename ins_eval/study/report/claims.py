"""The claims that a study decides, each with its own verdict, in words and by mission class."""

from collections.abc import Sequence
from dataclasses import dataclass

from ins_eval.study.report.figures.matrix import name_negative_r2
from ins_eval.study.report.figures.parts import name_calibration
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    FITTED_MAP,
    FIXED_RULE,
    TRUE_PARAMETERS,
)
from ins_eval.study.tables.score import (
    ALL,
    COVERAGE,
    FAILS,
    HOLDS,
    MEDIAN_RATIO,
    MOUNTING_SHARE,
    R2_MOUNTED,
    R2_RADIAL,
    R2_SHORTFALL,
    SPEARMAN,
    UNDECIDED,
    Score,
)
from pyhrg.common.pages.svg import format_estimate

IN_PART = "holds in part"
NO_FAILURE = "no claim fails"


@dataclass(frozen=True)
class Claim:
    """A claim. letter: its name; statement: a sentence; parts: score, predictor and words of each
    requirement; beside: the same of figures that explain the claim and have no requirement."""

    letter: str
    statement: str
    parts: tuple[tuple[str, str, str], ...]
    beside: tuple[tuple[str, str, str], ...] = ()


CLAIMS = (
    Claim(
        "a",
        "In-run stability at a fixed position says nothing of the flight",
        (
            (
                SPEARMAN,
                FIXED_RULE,
                "rank correlation (Spearman) of bench figure and gyro's rms error",
            ),
            (MEDIAN_RATIO, FIXED_RULE, "flown / predicted, by 0.01 deg/h = 1 nmi/h"),
        ),
    ),
    Claim(
        "b",
        "The full circumference ranks gyros and gives the size of the error",
        (
            (
                SPEARMAN,
                CIRCUMFERENCE_RULE,
                "rank correlation (Spearman) of bench figure and gyro's rms error",
            ),
            (MEDIAN_RATIO, CIRCUMFERENCE_CLASS, "flown / predicted, by the class constant"),
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
            (R2_RADIAL, TRUE_PARAMETERS, "R2 of the true maps, mounting unknown: the ceiling"),
            (R2_SHORTFALL, FITTED_MAP, "ceiling less R2 of the fitted map"),
            (MOUNTING_SHARE, "", "share of the mean square error due to mounting"),
            (R2_MOUNTED, FITTED_MAP, "R2 of north and east, mounting's part taken out"),
        ),
    ),
)


@dataclass(frozen=True)
class JudgedClaim:
    """A claim and its scores: those of each class, which decide, those over all classes, and by
    class those that explain it."""

    claim: Claim
    by_class: Sequence[Score]
    overall: Sequence[Score]
    beside: Sequence[Score]

    @property
    def verdict(self) -> str:
        """`HOLDS` where it holds in all classes, `IN_PART` where in some; where in none, `FAILS` if
        it fails in any, else `UNDECIDED`."""
        found = [self.judge_class(name) for name in self.classes]
        if HOLDS in found:
            return HOLDS if set(found) == {HOLDS} else IN_PART
        return FAILS if FAILS in found else UNDECIDED

    def judge_class(self, name: str) -> str:
        """The verdict in a class: `HOLDS` if all requirements do, `FAILS` if one fails."""
        found = {score.verdict for score in self.by_class if score.mission_class == name}
        if found == {HOLDS}:
            return HOLDS
        return FAILS if FAILS in found else UNDECIDED

    @property
    def n(self) -> int:
        """Number of judged triads."""
        return max((score.n for score in self.by_class), default=0)

    @property
    def classes(self) -> list[str]:
        """Names of the classes that decide."""
        return list(dict.fromkeys(score.mission_class for score in self.by_class))

    def find_exceptions(self) -> list[str]:
        """Class, requirement and figure of each score that does not hold."""
        return [
            f"{s.mission_class}: {name_requirement(self.claim, s)} {format_score(s)}, required "
            f"{s.asked}: {s.verdict}"
            for s in self.by_class
            if s.verdict != HOLDS
        ]

    def explain_exceptions(self) -> list[str]:
        """For each class in which the claim does not hold, the figures that explain it."""
        lines = []
        for name in self.classes:
            found = [s for s in self.beside if s.mission_class == name]
            if found and self.judge_class(name) != HOLDS:
                words = (f"{name_requirement(self.claim, s)} {format_score(s)}" for s in found)
                lines.append(f"{name}: {', '.join(words)}")
        return lines


def judge_claims(data: StudyData, calibration: str) -> list[JudgedClaim]:
    """The claims on the judged triads of a calibration; none without scores."""
    scores = [s for s in data.scores if s.calibration == calibration and not s.shuffled]
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


def list_failures(data: StudyData) -> list[tuple[str, int, list[str]]]:
    """Claim (d): each condition, its number of triads, and what fails there, with its figure."""
    judged = judge_conditions(data)
    return [
        (
            name,
            max(s.n for each in judged for s in each.by_class if s.mission_class == name),
            [
                f"({each.claim.letter}) {name_requirement(each.claim, s)} {format_score(s)}"
                for each in judged
                for s in each.by_class
                if s.mission_class == name and s.verdict == FAILS
            ],
        )
        for name in (data.conditions.classes if data.conditions else [])
    ]


def describe_claim(judged: JudgedClaim) -> str:
    """A claim, its verdict, its figures over all classes, and where it does not hold."""
    figures = "; ".join(
        f"{name_requirement(judged.claim, s)} {format_score(s)}"
        for s in judged.overall or judged.by_class
    )
    kinds = f"{len(judged.classes)} class{'es' if len(judged.classes) > 1 else ''}"
    line = (
        f"({judged.claim.letter}) {judged.claim.statement}: {judged.verdict.upper()}. "
        f"{figures[:1].upper()}{figures[1:]} (n = {judged.n} triads, {kinds})."
    )
    if exceptions := judged.find_exceptions():
        line += f" Not shown in {'; '.join(exceptions)}."
    if explained := judged.explain_exceptions():
        line += f" Beside it, {'; '.join(explained)}."
    return line


def describe_conditions(data: StudyData) -> list[str]:
    """Claim (d) in words: a line for each condition."""
    return [
        f"{name} ({n} triads, linear flights): {'; '.join(failing) or NO_FAILURE}."
        for name, n, failing in list_failures(data)
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
        [s for s in beside if s.mission_class != ALL],
    )


def _pick(scores: Sequence[Score], parts: Sequence[tuple[str, str, str]]) -> list[Score]:
    """Scores of these kinds, in the order of the kinds."""
    kinds = [(score, predictor) for score, predictor, _ in parts]
    found = [s for s in scores if (s.score, s.predictor) in kinds]
    return sorted(found, key=lambda s: kinds.index((s.score, s.predictor)))
