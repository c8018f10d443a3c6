"""Scores of made-up flights whose truth is known."""

import numpy as np
import pandas as pd
import pytest

from ins_eval.study.tables.score import ALL
from ins_eval.study.witness.judge import (
    CORRECTED,
    CORRECTIONS,
    COVERAGE,
    NEES,
    POSITION_NEES,
    PREDICTORS,
    R2,
    SHUFFLED,
    WORST,
    WitnessScore,
    list_figures,
    score_witnesses,
)

TRIADS = 60


@pytest.fixture(scope="module")
def scores() -> list[WitnessScore]:
    """Channels that tell nine tenths of what the bench does not know, in two classes."""
    random = np.random.default_rng(3)
    tables = []
    for name in ("car", "ship"):
        flown = random.normal(0.0, 1000.0, (TRIADS, 2))
        estimated = flown + random.normal(0.0, 100.0, (TRIADS, 2))
        errors = {
            "flown": flown,
            "known": np.zeros_like(flown),
            "estimated": estimated,
            "by_bench": flown,
            "by_channels": flown - estimated,
            "by_self_test": np.full_like(flown, np.nan),
            "by_bound": flown - estimated,
            "by_true": np.full_like(flown, 1.0),
        }
        table = {f"{k}_{a}_m": v[:, i] for k, v in errors.items() for i, a in enumerate(AXES)}
        size = {"estimated": estimated, "bound": estimated, "true": flown, "known": flown[::-1]}
        for key, vector in size.items():
            radial = np.linalg.norm(vector, axis=-1)
            ends = {"low": radial - 165, "median": radial, "high": radial + 165}
            table |= {f"{key}_{end}_m": values for end, values in ends.items()}
        table["position_square"] = np.square((estimated - flown) / 100.0).sum(axis=1)
        table |= {"squares": np.full(TRIADS, 48.0), "degrees": np.full(TRIADS, 48.0)}
        rows = pd.DataFrame(table).assign(mission_class=name, mission=name)
        tables.append(rows.assign(triad=range(TRIADS), calibration="map", self_test_s=0.0))
    return score_witnesses(pd.concat(tables), seed=1)


AXES = ("north", "east")


def select(scores: list[WitnessScore], score: str, of: str) -> WitnessScore:
    (found,) = (s for s in scores if (s.score, s.of, s.mission_class) == (score, of, ALL))
    return found


def test_scores_are_what_was_made(scores: list[WitnessScore]) -> None:
    assert {each.mission_class for each in scores} == {ALL, "car", "ship"}
    assert select(scores, R2, "true").value == pytest.approx(1.0)
    assert select(scores, R2, "estimated").low > 0.9
    assert select(scores, R2, "known").high < 0.5
    assert select(scores, CORRECTED, "by_channels").value == pytest.approx(0.1, abs=0.03)
    assert select(scores, CORRECTED, "by_bench").value == pytest.approx(1.0)
    assert select(scores, WORST, "by_bench").value == pytest.approx(1.0)
    assert select(scores, WORST, "by_true").value < 0.01
    assert 0.1 < select(scores, WORST, "by_channels").value < 0.5
    coverage = select(scores, COVERAGE, "estimated")
    assert coverage.low < 0.9 < coverage.high
    assert select(scores, NEES, "estimated").value == pytest.approx(1.0)
    position = select(scores, POSITION_NEES, "estimated")
    assert position.low < 1.0 < position.high


def test_another_triads_channels_gain_nothing(scores: list[WitnessScore]) -> None:
    assert select(scores, CORRECTED, SHUFFLED).low > 1.0


def test_a_correction_that_was_not_flown_has_no_score(scores: list[WitnessScore]) -> None:
    assert not [each for each in scores if each.of == "by_self_test"]


def test_every_score_has_its_line(scores: list[WitnessScore]) -> None:
    lines = list_figures(scores)
    assert len(lines) == len(scores)
    titles = {*PREDICTORS.values(), *CORRECTIONS.values(), SHUFFLED}
    assert all(line[3].split(": ")[1] in titles for line in lines)
