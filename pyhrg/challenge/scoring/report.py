"""A challenge's score, as JSON and as a table."""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from pyhrg.challenge.roster import Settings, encode_json
from pyhrg.challenge.scoring import score
from pyhrg.challenge.scoring.figure import Figure
from pyhrg.challenge.scoring.score import CurvePoint, ScoredCase
from pyhrg.challenge.truths.truth import DETECTION_SIGMAS
from pyhrg.common.files import write_whole

SCHEMA = "hrg-challenge-score/2"
SIGNS = {"at most": "<=", "at least": ">=", "about": "="}


@dataclass(frozen=True)
class Finished:
    """One challenge's cases with their answers."""

    settings: Settings
    cases: Sequence[ScoredCase]


@dataclass(frozen=True)
class Score:
    """The score of challenges, taken together.

    challenges: one at least.
    """

    challenges: Sequence[Finished]

    @property
    def cases(self) -> list[ScoredCase]:
        """Cases of all challenges."""
        return [case for challenge in self.challenges for case in challenge.cases]

    @cached_property
    def figures(self) -> list[Figure]:
        """Figures with their targets."""
        return score.score_figures(self.cases, self.challenges[0].settings.seed)

    @cached_property
    def curve(self) -> list[CurvePoint]:
        """Share of rightly named single effects by strength."""
        return score.score_curve(self.cases)

    @property
    def summary(self) -> str:
        """Figures with their intervals and targets, as a table in plain text."""
        return text(self)


def write(result: Score, path: Path) -> None:
    """Write `score.json`, whole or not at all.

    Raises:
        OSError: the folder can't be written.
    """
    write_whole(
        path,
        encode_json(
            {
                "schema": SCHEMA,
                "figures": [_figure(figure) for figure in result.figures],
                "curve": [_point(point) for point in result.curve],
                "challenges": [_finished(challenge) for challenge in result.challenges],
            }
        ),
    )


def text(result: Score) -> str:
    """Figures and curve as a table in plain text."""
    lines = [f"{'':44}{'value':>8}{'95 % interval':>19}{'n':>6}  target"]
    lines += [_line(figure) for figure in result.figures]
    shown = [point for point in result.curve if point.right.n]
    if shown:
        lines += ["", "singles rightly named, by strength"]
        lines += [f"{_range(p):>20}{_numbers(p.right)}" for p in shown]
    return "\n".join(lines)


def _line(figure: Figure) -> str:
    verdict = {True: "pass", False: "FAIL", None: "no case"}[figure.passed]
    return f"{figure.name:44}{_numbers(figure)}  {SIGNS[figure.sense]} {figure.target:g}  {verdict}"


def _numbers(figure: Figure) -> str:
    ends = f"{figure.low:.3f} .. {figure.high:.3f}"
    return f"{figure.value:8.3f}{ends:>19}{figure.n:6d}"


def _range(point: CurvePoint) -> str:
    return f"{point.low:g} to {point.high:g} sigma"


def _figure(figure: Figure) -> dict[str, Any]:
    return {**_finite(asdict(figure)), "passed": figure.passed}


def _point(point: CurvePoint) -> dict[str, Any]:
    numbers = {"low_sigmas": point.low, "high_sigmas": point.high, "n": point.right.n}
    right = {"right": point.right.value, "low": point.right.low, "high": point.right.high}
    return _finite({**numbers, **right})


def _finished(challenge: Finished) -> dict[str, Any]:
    settings = challenge.settings
    return {
        "seed": settings.seed,
        "counts": dict(settings.counts),
        "strengths_sigmas": [DETECTION_SIGMAS, settings.strongest],
        "cases": [_case(case) for case in challenge.cases],
    }


def _case(case: ScoredCase) -> dict[str, Any]:
    truth, said = asdict(case.truth), case.diagnosis
    return {
        "name": case.name,
        "truth": truth,
        "verdict": said.verdict,
        "named": sorted(sorted(effects) for effects in said.named),
        "right": score.is_right(case),
        "coordinate": score.find_main_coordinate(said),
    }


def _finite(values: dict[str, Any]) -> dict[str, Any]:
    """Values with None in place of infinity and NaN, which JSON lacks."""
    return {
        name: None if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in values.items()
    }
