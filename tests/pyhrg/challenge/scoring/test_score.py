"""What is right, by cases that say so."""

import math
from dataclasses import replace

import pytest

from pyhrg.challenge.scoring import named, score
from pyhrg.challenge.scoring.named import RefusedCase, ScoredCase
from pyhrg.challenge.scoring.score import COORDINATES
from pyhrg.challenge.truths.truth import Truth
from pyhrg.gap.effects.catalogue import EFFECT_NAMES
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis, Verdict
from pyhrg.gap.findings.localisation import Place
from pyhrg.gap.findings.term import Formula, Term
from tests.pyhrg.challenge.test_run import FIGURE, NO_GAP

DAMPING = "damping_anisotropy"
GAIN = "drive_gain_mismatch"


def judged(truth: Truth, diagnosis: Diagnosis, then: Diagnosis | None = None) -> ScoredCase:
    return ScoredCase("unit", truth, diagnosis, then)


def single(effect: str = DAMPING, **parameters: float) -> Truth:
    return Truth("single", (effect,), parameters, (8.0,))


def said(*causes: Cause, verdict: Verdict = "explained", unknown: float = 0.0) -> Diagnosis:
    return replace(NO_GAP, verdict=verdict, causes=causes, unknown_probability=unknown)


def unexplained(*shares: tuple[str, float]) -> Diagnosis:
    """With shares of the gap by coordinate."""
    where = tuple(Place("a", "amplitude", name, share, 12.0) for name, share in shares)
    return replace(NO_GAP, verdict="unexplained", where=where, unknown_probability=0.99)


@pytest.mark.parametrize(
    ("diagnosis", "right"),
    [
        (said(Cause(DAMPING, 0.99)), True),
        (said(Cause(GAIN, 0.99)), False),
        (said(Cause(GAIN, 0.6, equivalents=(DAMPING,)), verdict="ambiguous"), True),
        (said(Cause(DAMPING, 0.99), Cause("duffing_stiffness", 0.9)), False),
        (said(Cause(DAMPING, 0.99), Cause("duffing_stiffness", 0.1)), True),
        (said(Cause(DAMPING, 0.3)), False),
        (said(Cause(DAMPING, 0.99), verdict="unexplained"), False),
        (said(verdict="no_gap"), False),
    ],
)
def test_a_single_effect_is_right_alone_or_in_its_class(diagnosis: Diagnosis, right: bool) -> None:
    assert named.is_right(judged(single(), diagnosis)) is right


def test_members_of_a_class_share_its_probability() -> None:
    halves = said(
        Cause(DAMPING, 0.4, equivalents=(GAIN,)),
        Cause(GAIN, 0.4, equivalents=(DAMPING,)),
        verdict="ambiguous",
    )
    assert named.list_named(halves) == [frozenset({DAMPING, GAIN})]
    assert named.is_right(judged(single(), halves))


@pytest.mark.parametrize(
    ("causes", "right"),
    [
        ((Cause(DAMPING, 0.9), Cause("duffing_stiffness", 0.9)), True),
        ((Cause("duffing_stiffness", 0.9), Cause(GAIN, 0.9, equivalents=(DAMPING,))), True),
        ((Cause(DAMPING, 0.9),), False),
        ((Cause(DAMPING, 0.9, equivalents=("duffing_stiffness",)), Cause(GAIN, 0.9)), False),
    ],
)
def test_a_pair_needs_a_class_for_each(causes: tuple[Cause, ...], right: bool) -> None:
    truth = Truth("pair", (DAMPING, "duffing_stiffness"), {}, (8.0, 8.0))
    assert named.is_right(judged(truth, said(*causes))) is right


@pytest.mark.parametrize(("third", "right"), [("loop_delay", True), (DAMPING, False)])
def test_each_of_several_needs_a_class(third: str, right: bool) -> None:
    truth = Truth("several", (GAIN, DAMPING, "loop_delay"), {}, (8.0, 70.0, 500.0))
    alike = ("duffing_stiffness",)
    causes = (Cause(DAMPING, 0.9, equivalents=alike), Cause(GAIN, 0.9), Cause(third, 0.9))
    assert named.is_right(judged(truth, said(*causes))) is right


@pytest.mark.parametrize(
    ("value", "low", "high", "covered"),
    [(89.5, -1.0, 1.0, True), (89.5, 89.0, 91.0, True), (45.0, -1.0, 1.0, False)],
)
def test_an_axis_is_covered_after_a_quarter_turn(
    value: float, low: float, high: float, covered: bool
) -> None:
    cause = Cause(DAMPING, 0.9, {}, {"damping_axis_deg": (low, high)})
    truth = single(damping_anisotropy_per_s=1e-6, damping_axis_deg=value)
    assert score.list_coverage(judged(truth, said(cause))) == [covered]


def test_a_magnitude_does_not_wrap() -> None:
    cause = Cause(DAMPING, 0.9, {}, {"damping_anisotropy_per_s": (2e-6, 3e-6)})
    assert score.list_coverage(judged(single(damping_anisotropy_per_s=1e-6), said(cause))) == [
        False
    ]


@pytest.mark.parametrize(
    ("diagnosis", "owned"),
    [
        (unexplained(("wave_angle", 0.7), ("time", 0.3)), True),
        (unexplained(("time", 0.4), ("wave_angle", 0.45), ("time", 0.1)), False),
        (unexplained(), False),
        (said(Cause(GAIN, 0.9)), True),
        (said(Cause("duffing_stiffness", 0.9)), False),
        (said(verdict="ambiguous"), False),
        (said(verdict="no_gap"), False),
    ],
)
def test_an_effect_left_out_is_none_of_these_or_a_stand_in(
    diagnosis: Diagnosis, owned: bool
) -> None:
    truth = Truth("left_out", (DAMPING,), {}, (8.0,), stand_ins=(GAIN,))
    assert score.is_owned(judged(truth, diagnosis)) is owned


def test_a_term_is_placed_by_any_of_its_coordinates() -> None:
    truth = Truth("outside", (), {}, (9.0,), "form", "temperature")
    term = Term(
        "bias", ("rate", "temperature"), Formula("", ""), {}, {}, 0.9, 0.9, "gyro_angle", ""
    )
    shrunk = replace(NO_GAP.gap, shrink_percent=80.0)
    right = replace(NO_GAP, terms=(term,), gap=shrunk)
    cases = [judged(truth, right), judged(replace(truth, coordinate="time"), right)]
    cases += [judged(Truth("none"), NO_GAP), judged(Truth("none"), right)]
    figures = {figure.name: figure for figure in score.score_figures(cases, 1)}
    assert figures["outside: a term in the right coordinate"].value == 0.5
    assert figures["outside: held-out excess removed, median"].value == 0.8
    assert figures["a term where there is none"].value == 0.5


def test_a_form_is_blamed_on_what_is_not_there() -> None:
    outside = Truth("outside", beyond=("site_latitude",))
    assert score.is_blamed(judged(outside, said(Cause(GAIN, 0.9))))
    assert not score.is_blamed(judged(outside, said(Cause("site_latitude", 1.0))))
    assert not score.is_blamed(judged(outside, unexplained()))


def test_next_test_settles_what_is_then_named_alone() -> None:
    before = said(Cause(GAIN, 0.6, equivalents=(DAMPING,)), verdict="ambiguous")
    alone = said(Cause(DAMPING, 0.9))
    assert score.is_settled(judged(single(), before, alone))
    assert not score.is_settled(judged(single(), before, before))
    assert not score.is_settled(judged(single(), before, said(Cause(GAIN, 0.9))))
    both = said(Cause(DAMPING, 0.9), Cause("site_latitude", 1.0))
    assert not score.is_settled(judged(single(), before, both))
    assert score.is_settled(judged(replace(single(), beyond=("site_latitude",)), before, both))


def test_probabilities_are_held_against_the_truth() -> None:
    diagnosis = said(Cause(DAMPING, 0.7), Cause(GAIN, 0.2), unknown=0.1)
    assert score.list_claims(judged(single(), diagnosis)) == [
        (0.7, True),
        (0.2, False),
        (0.1, False),
    ]
    outside = Truth("outside", form="jump")
    assert score.list_claims(judged(outside, diagnosis))[-1] == (0.1, True)


def test_every_figure_counts_its_own_kind() -> None:
    cases = [judged(Truth("none"), NO_GAP)] * 30 + [judged(Truth("none"), said(Cause(GAIN, 0.9)))]
    cases += [judged(Truth("outside"), unexplained())] * 4
    cases += [judged(single(), said(Cause(DAMPING, 0.9)))] * 5
    figures = {figure.name: figure for figure in score.score_figures(cases, 1)}
    assert figures["false alarm without a gap"].n == 31
    assert figures["false alarm without a gap"].value == pytest.approx(1 / 31)
    assert figures["outside: recognised"].value == 1
    assert figures["outside: blamed on a named effect"].value == 0
    assert figures["single: right effect or its class"].n == 5
    assert figures["pair: right effects or their classes"].passed is None


def test_curve_has_every_single_once() -> None:
    weak = Truth("weak", (DAMPING,), {}, (1.2,))
    cases = [judged(weak, NO_GAP), judged(single(), said(Cause(DAMPING, 0.9)))]
    points = score.score_curve(cases)
    assert sum(point.right.n for point in points) == 2
    assert [p.right.value for p in points if p.right.n] == [0.0, 1.0]
    assert points[-1].high == math.inf


def test_every_effect_shows_in_some_coordinate() -> None:
    assert set(COORDINATES) == set(EFFECT_NAMES)


def test_closing_is_measured_by_the_noise_of_the_same_records() -> None:
    truth = Truth("single", (DAMPING,), {}, (8.0,), holdout_noise_arcsec=2.0)
    gap = replace(NO_GAP.gap, holdout_angle_arcsec=replace(FIGURE, after=2.2))
    found = score.find_residual_over_noise(judged(truth, replace(NO_GAP, gap=gap)))
    assert found == pytest.approx(1.1)
    assert score.find_residual_over_noise(judged(truth, NO_GAP)) is None


LATITUDE = "site_latitude"


def test_causes_that_share_a_rival_are_two_classes() -> None:
    causes = (
        Cause(DAMPING, 0.9, equivalents=(LATITUDE,)),
        Cause(GAIN, 0.9, equivalents=(LATITUDE,)),
    )
    truth = Truth("pair", (DAMPING, GAIN), {}, (8.0, 8.0))
    assert named.is_right(judged(truth, said(*causes, verdict="ambiguous")))


def test_a_known_parameter_in_a_class_holds_the_effect() -> None:
    """Whichever of the two was chosen as the cause; alone it is wrong, unless it is off."""
    known = Cause(LATITUDE, 0.99, equivalents=(DAMPING,), family="bench")
    alone = judged(single(), said(replace(known, equivalents=())))
    assert named.is_right(judged(single(), said(known, verdict="ambiguous")))
    assert not named.is_right(alone)
    assert named.is_wrong(alone)
    off = judged(replace(single(), beyond=(LATITUDE,)), said(replace(known, equivalents=())))
    assert not named.is_wrong(off)
    assert not named.is_right(off)


@pytest.mark.parametrize(
    ("truth", "diagnosis", "right"),
    [
        (single(), said(Cause(GAIN, 0.9)), True),
        (single(), said(Cause(LATITUDE, 0.9, family="bench")), False),
        (single(), said(Cause(LATITUDE, 0.9, equivalents=(GAIN,), family="bench")), True),
        (single(), said(Cause(DAMPING, 0.9), Cause(LATITUDE, 0.9, family="bench")), False),
        (single(), said(verdict="no_gap"), False),
        (Truth("none"), said(verdict="no_gap"), True),
        (Truth("none"), said(Cause(DAMPING, 0.9)), False),
        (Truth("none", beyond=(LATITUDE,)), said(Cause(LATITUDE, 0.9, family="bench")), True),
        (Truth("none", beyond=(LATITUDE,)), said(verdict="no_gap"), True),
        (Truth("outside", form="jump"), said(verdict="no_gap", unknown=0.9), True),
        (Truth("outside", place="bench"), said(verdict="no_gap", unknown=0.9), False),
        (Truth("none"), said(verdict="unexplained", unknown=0.9), False),
    ],
)
def test_where_it_is_wrong(truth: Truth, diagnosis: Diagnosis, right: bool) -> None:
    assert named.is_family_right(judged(truth, diagnosis)) is right


def test_measures_of_names() -> None:
    """Three effects, of which one is missed and one is another: r = 2, w = 1 + 1."""
    truth = Truth("several", (GAIN, DAMPING, "loop_delay"), {}, (8.0, 70.0, 500.0))
    causes = (Cause(DAMPING, 0.8), Cause(GAIN, 0.7), Cause("duffing_stiffness", 0.9))
    case = judged(truth, said(*causes))
    figures = {figure.name: figure for figure in named.score_names([case], 1)}
    assert figures["localisation F1"].value == pytest.approx(2 * 2 / (2 * 2 + 2))
    assert figures["localisation F1"].n == 4
    assert figures["false discovery rate of names"].value == pytest.approx(1 / 3)
    assert figures["mean probability on the true fault"].value == pytest.approx(0.5)
    log = (math.log(0.8) + math.log(0.7) + math.log(named.LEAST_PROBABILITY)) / 3
    assert figures["log score of the true fault"].value == pytest.approx(log)


def test_a_refused_campaign_counts_against_the_diagnosis() -> None:
    cases = [
        RefusedCase("unit", truth, "no test can be used") for truth in (Truth("none"), single())
    ]
    figures = {figure.name: figure for figure in score.score_figures(cases, 1)}
    assert figures["false alarm without a gap"].value == 1
    assert figures["single: right effect or its class"].value == 0
    assert figures["effects: blamed on another"].value == 1
    assert figures["mean probability on the true fault"].value == 0
    assert figures["localisation F1"].value == 0
    assert figures["diagnosis refused"].value == 1
