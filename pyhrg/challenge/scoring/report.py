"""A challenge's score, as JSON and as a table."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from pyhrg.challenge.roster import Settings
from pyhrg.challenge.scoring import score
from pyhrg.challenge.scoring.figure import Figure
from pyhrg.challenge.scoring.named import AnyCase, RefusedCase, is_right, list_named
from pyhrg.challenge.scoring.score import CurvePoint
from pyhrg.challenge.truths.seal import encode_json
from pyhrg.challenge.truths.truth import DETECTION_SIGMAS
from pyhrg.common.arrays import to_json_value
from pyhrg.common.errors import describe_briefly
from pyhrg.common.files import write_whole

SCHEMA = "hrg-challenge-score/3"
SIGNS = {"at most": "<=", "at least": ">=", "about": "="}


@dataclass(frozen=True)
class Finished:
    """One challenge's cases with their answers."""

    settings: Settings
    cases: Sequence[AnyCase]


@dataclass(frozen=True)
class Score:
    """The score of one or more challenges, taken together."""

    challenges: Sequence[Finished]

    __repr__ = describe_briefly

    @property
    def cases(self) -> list[AnyCase]:
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
        lines = [f"{'':44}{'value':>8}{'95 % interval':>19}{'n':>6}  target"]
        lines += [_format_line(figure) for figure in self.figures]
        shown = [point for point in self.curve if point.right.n]
        if shown:
            lines += ["", "singles rightly named, by strength"]
        for point in shown:
            strengths = f"{point.low:g} to {point.high:g} sigma"
            lines.append(f"{strengths:>20}{_format_numbers(point.right)}")
        return "\n".join(lines)


def write(result: Score, path: Path) -> None:
    """Write `score.json`, whole or not at all."""
    document = {
        "schema": SCHEMA,
        "figures": [{**to_json_value(asdict(f)), "passed": f.passed} for f in result.figures],
        "curve": [
            to_json_value(
                {
                    "low_sigmas": point.low,
                    "high_sigmas": point.high,
                    "n": point.right.n,
                    "right": point.right.value,
                    "low": point.right.low,
                    "high": point.right.high,
                }
            )
            for point in result.curve
        ],
        "challenges": [
            {
                "seed": challenge.settings.seed,
                "counts": dict(challenge.settings.counts),
                "level": challenge.settings.level,
                "data": challenge.settings.data,
                "strengths_sigmas": [DETECTION_SIGMAS, challenge.settings.strongest],
                "cases": [_describe_case(case) for case in challenge.cases],
            }
            for challenge in result.challenges
        ],
    }
    write_whole(path, encode_json(document))


def _format_line(figure: Figure) -> str:
    target = f"{SIGNS[figure.sense]} {figure.target:g}"
    verdict = {True: "pass", False: "FAIL", None: "no case"}[figure.passed]
    return f"{figure.name:44}{_format_numbers(figure)}  {target}  {verdict}"


def _format_numbers(figure: Figure) -> str:
    ends = f"{figure.low:.3f} .. {figure.high:.3f}"
    return f"{figure.value:8.3f}{ends:>19}{figure.n:6d}"


def _describe_case(case: AnyCase) -> dict[str, Any]:
    if isinstance(case, RefusedCase):
        return {"name": case.name, "truth": asdict(case.truth), "refused": case.refusal}
    return {
        "name": case.name,
        "truth": asdict(case.truth),
        "verdict": case.diagnosis.verdict,
        "named": sorted(sorted(effects) for effects in list_named(case.diagnosis)),
        "right": is_right(case),
        "terms": [
            {"place": t.place, "coordinates": t.coordinates, "function": t.function}
            for t in case.diagnosis.terms
        ],
        "removed": score.find_removed_share(case),
        "coordinate": score.find_main_coordinate(case.diagnosis),
    }
