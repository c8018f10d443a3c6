"""Claims say what their scores say: verdict, figures, where they fail."""

from dataclasses import replace

import pytest

from ins_eval.study.report.claim_table import render_claims
from ins_eval.study.report.claims import (
    describe_claim,
    describe_conditions,
    format_score,
    judge_claims,
    judge_conditions,
    list_conditions,
    state_claims,
)
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import score as scored
from ins_eval.study.tables.score import ALL, Score
from tests.ins_eval.study.report.synthetic import synthetic

TABLE = synthetic(4).table
ABOUT = {"interval_percent": 90}
R2 = Score(
    scored.R2_RADIAL, "fitted_map", "map", "ship", TEST, 0.98, 0.975, 0.99, 0.95, 40, 1,
    asked=">= 0.97", verdict="holds",
)  # fmt: skip
CAR = replace(R2, mission_class="car", value=0.9, low=0.85, high=0.94, verdict="fails")


def study(*scores: Score) -> StudyData:
    return StudyData(TABLE, scores, ABOUT)


@pytest.mark.parametrize(
    ("verdicts", "verdict"),
    [
        (("holds", "holds"), "holds"),
        (("fails", "fails"), "fails"),
        (("holds", "fails"), "holds in part"),
        (("undecided", "fails"), "fails"),
        (("holds", "undecided"), "holds in part"),
        (("undecided", "undecided"), "undecided"),
    ],
)
def test_verdict_is_that_of_all_classes(verdicts: tuple[str, str], verdict: str) -> None:
    ship, car = (
        replace(R2, mission_class=name, verdict=each)
        for name, each in zip(("ship", "car"), verdicts, strict=True)
    )
    (judged,) = judge_claims(study(ship, car), "map")
    assert (judged.claim.letter, judged.verdict, judged.n) == ("c", verdict, 40)


def test_where_a_claim_fails_is_said_with_its_figure() -> None:
    overall = replace(R2, mission_class=ALL, value=0.95, low=0.94, high=0.96, verdict="fails")
    (judged,) = judge_claims(study(overall, R2, CAR), "map")
    assert describe_claim(judged) == (
        "(c) The fitted map and the trajectory predict each flight: HOLDS IN PART "
        "(n = 40 triads)\n"
        "    R2 of single flights, required >= 0.97:\n"
        "        car   0.900 (0.850 to 0.940): fails\n"
        "        ship  0.980 (0.975 to 0.990): holds"
    )
    assert "<b>0.900</b><br><small>0.850 to 0.940" in render_claims(study(overall, R2, CAR))
    assert state_claims(study(R2, CAR)) == (
        "Mean calibrated: no claim was scored; whole map calibrated: (c) holds in part."
    )


def test_figures_without_a_requirement_decide_nothing() -> None:
    ceiling = replace(R2, predictor="true_parameters", value=0.92, low=0.88, high=0.95)
    beside = replace(ceiling, mission_class="car", asked="", verdict="")
    data = study(R2, CAR, beside)
    (judged,) = judge_claims(data, "map")
    assert judged.verdict == "holds in part"
    assert "0.920" not in describe_claim(judged)
    assert "<b>0.920</b>" in render_claims(data)


def test_controls_and_other_calibrations_decide_nothing() -> None:
    control, other = replace(R2, shuffled=True), replace(R2, calibration="mean")
    assert judge_claims(study(control, other), "map") == []


def test_r2_below_zero_is_worse_than_the_mean() -> None:
    assert format_score(replace(R2, value=-0.5, low=-1, high=0.1)).endswith("worse than the mean")
    assert "worse" not in format_score(R2)
    control = replace(R2, value=-0.5, low=-1, high=0.1, score=scored.R2_COMPONENTS)
    assert format_score(control).endswith("worse than zero")


def test_conditions_name_the_claims_that_fail() -> None:
    result = synthetic(12)
    assert [each.claim.letter for each in judge_conditions(result)] == [*"abc"]
    level, calibrated = list_conditions(result)
    assert (level.figures["fails"], level.n) == ([], 12)
    assert calibrated.figures["fails"][0].startswith("(b) flown / predicted, by the class constant")
    assert level.figures["undecided"][0].startswith("(c) R2 of single flights")
    assert describe_conditions(result) == [
        "straight & level  n = 12: (a) holds, (b) holds, (c) undecided",
        "self-calibrated   n = 12: (a) holds, (b) fails, (c) undecided",
    ]
    assert describe_conditions(synthetic(4, conditions=False)) == []
