"""The page: whole, self-contained, small, the same bytes for the same diagnosis."""

import html
import re
from dataclasses import replace

import pytest

from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.evidence.noise.noise_hypothesis import UnnamedNoise
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.findings.diagnosis import UNSETTLED, WORSE_HELD_OUT, Cause, NextTest, Verdict
from pyhrg.gap.findings.faults import list_fault_causes, list_tolerated_faults
from pyhrg.gap.findings.term import Formula, Term
from pyhrg.gap.report.page import build_page
from pyhrg.gap.report.sections import Section
from pyhrg.gap.report.terms import build_terms
from pyhrg.gap.report.verdict import (
    IMMATERIAL_CAUSE,
    REMEDIES,
    answer_questions,
    summarize_diagnosis,
    write_headline,
)
from pyhrg.gap.soundness.fault import FAULT_NAMES, LOST_ROWS, OUTLIERS, TABLE_SIGN, Fault
from pyhrg.gap.whitening.whitening import CorrelatedNoise
from tests.elements import check_drawings_have_words, check_nothing_is_loaded, elements

MOST_BYTES = 3_000_000
SECTIONS = (
    "causes",
    "terms",
    "ranking",
    "where",
    "residuals",
    "held-out",
    "closing",
    "next",
    "data",
)


@pytest.fixture(scope="module")
def text(with_gap: CampaignDiagnosis) -> str:
    return build_page(with_gap)


def test_same_diagnosis_same_bytes(text: str, with_gap: CampaignDiagnosis) -> None:
    assert build_page(with_gap) == text


def test_every_section_can_be_reached(text: str) -> None:
    found = elements(text)
    links = [a["href"] for tag, a in found if tag == "a"]
    assert links == [f"#{name}" for name in SECTIONS]
    assert set(SECTIONS) <= {a.get("id") for _, a in found}


def test_nothing_is_loaded_from_anywhere(text: str) -> None:
    check_nothing_is_loaded(text)


def test_drawings_have_words_for_those_who_do_not_see_them(text: str) -> None:
    check_drawings_have_words(text)


def test_small_enough(text: str) -> None:
    assert len(text.encode()) < MOST_BYTES


def test_no_value_is_undefined(text: str) -> None:
    drawn = " ".join(str(a["d"]) for tag, a in elements(text) if tag == "path")
    assert drawn
    assert "nan" not in drawn
    assert "inf" not in drawn


def test_the_cause_is_told_with_its_interval(text: str) -> None:
    assert "The gap is explained, and lies in the gyro: its cause is damping anisotropy." in text
    told = re.search(r"Damping anisotropy: ([\d.e−]+) \(", text)
    assert told
    assert float(told[1].replace("−", "-")) == pytest.approx(3e-6, rel=0.02)


def test_faults_of_bench_and_record_are_told_with_what_to_do(
    without_gap: CampaignDiagnosis,
) -> None:
    faults = Fault(TABLE_SIGN, -1.0, 1e-4), Fault(LOST_ROWS, 2.0, 0.0), Fault(OUTLIERS, 0.1, 0.0)
    causes, listed = list_fault_causes(faults), list_tolerated_faults(faults)
    diagnosis = replace(
        without_gap.diagnosis, verdict="explained", causes=causes, within_tolerance=listed
    )
    answers = answer_questions(replace(without_gap, diagnosis=diagnosis))
    assert answers["Where"][0] == "In the bench and the record."
    assert answers["What"] == [
        "Mounting sign: table angle sign −1.00000 (−1.00020 to −0.99980), not 1.",
        "Lost rows: 2 %.",
        "Within its tolerance: outliers: 0.1 %, not 0.",
    ]
    assert answers["What next"][:2] == [REMEDIES["mounting_sign"], REMEDIES["lost_rows"]]
    assert not any("use them" in sentence for sentence in answers["What next"])
    assert "after.toml where it has them" in build_page(replace(without_gap, diagnosis=diagnosis))


def test_every_fault_has_a_remedy() -> None:
    assert set(REMEDIES) == set(FAULT_NAMES)


def test_page_and_terminal_begin_with_the_same_five_answers(
    with_gap: CampaignDiagnosis, text: str
) -> None:
    questions = ["Where", "What", "How sure", "How much", "What next"]
    answers = answer_questions(with_gap)
    assert list(answers) == questions
    assert re.findall("<dt>([^<]*)</dt>", text) == questions
    printed = " ".join(summarize_diagnosis(with_gap).split())
    for sentences in answers.values():
        assert sentences
        for sentence in sentences:
            assert html.escape(sentence) in text
            assert " ".join(sentence.split()) in printed
    assert "In the gyro." in answers["Where"]
    assert text.index("<dl>") < text.index("<figure>") < text.index("<nav")


def test_a_term_is_said_with_its_rivals_and_what_tells_it_from_known_mechanisms(
    with_gap: CampaignDiagnosis,
) -> None:
    name = "bias_rate3_deg_h_per_deg3_s3"
    formula = Formula("bias", "biasRate3*turnRate*turnRate*turnRate")
    rivals = {"bias: rate times its magnitude (output angle)": 0.3}
    term = Term("bias", ("rate",), formula, {name: 3e-6}, {name: (2e-6, 4e-6)}, 0.6, 0.9,
                "gyro_angle", "bias: rate cubed", rivals, 93.0)  # fmt: skip
    said = replace(with_gap.diagnosis, terms=(term,), causes=())
    answers = answer_questions(replace(with_gap, diagnosis=said))
    assert any("3e−06 (2e−06 to 4e−06) deg/h per (deg/s)³" in s for s in answers["What"])
    assert any("rate times its magnitude (output angle) 30.0" in s for s in answers["How sure"])
    assert any("authority (30). To tell:" in s for s in answers["What next"])
    assert "removes 93 % of the excess" in build_page(replace(with_gap, diagnosis=said))


def test_a_test_that_the_campaign_has_is_not_asked_for(with_gap: CampaignDiagnosis) -> None:
    term = Term("damping", ("wave_angle",), Formula("damping", "w"), {"w": 1.0}, {"w": (0.0, 2.0)},
                0.6, 0.9, "amplitude_force", "damping: harmonic 2", {}, None)  # fmt: skip
    without = replace(with_gap, diagnosis=replace(with_gap.diagnosis, terms=(term,)))
    first, *others = without.tests
    ring_down = replace(first, test=replace(first.test, kind="ring_down"))
    for result, is_asked in (
        (without, True),
        (replace(without, tests=(ring_down, *others)), False),
    ):
        next_steps = " ".join(answer_questions(result)["What next"])
        assert "is next to damping anisotropy (1)." in next_steps
        assert ("To tell: a ring-down" in next_steps) == is_asked
        assert ("To tell: a ring-down" in build_terms(result)) == is_asked


def test_an_immaterial_cause_without_a_name_stands_in_the_headline(
    with_gap: CampaignDiagnosis,
) -> None:
    diagnosis = replace(with_gap.diagnosis, unknown_probability=0.999)
    assert diagnosis.verdict == "explained"
    assert write_headline(diagnosis).endswith(f"damping anisotropy; {IMMATERIAL_CAUSE}.")
    answers = answer_questions(replace(with_gap, diagnosis=diagnosis))
    assert any(s.endswith("but immaterial by the bound.") for s in answers["How sure"])
    cases: tuple[tuple[float, Verdict], ...] = ((0.4, "explained"), (0.999, "unexplained"))
    for probability, verdict in cases:
        said = replace(diagnosis, unknown_probability=probability, verdict=verdict)
        assert IMMATERIAL_CAUSE not in write_headline(said)


@pytest.mark.parametrize(
    ("verdict", "settled", "is_held_out", "said"),
    [
        ("explained", True, True, "are this gyro: use them from now on."),
        ("explained", True, False, "verified it: hold one out, then use it."),
        ("explained", False, True, "see the caveats above."),
        ("ambiguous", True, True, "in another test they may be wrong."),
        ("unexplained", True, True, "the named causes alone, not the whole gap."),
    ],
)
def test_the_closed_files_are_recommended_as_the_verdict_allows(
    with_gap: CampaignDiagnosis, verdict: Verdict, settled: bool, is_held_out: bool, said: str
) -> None:
    gap = with_gap.diagnosis.gap
    if not is_held_out:
        gap = replace(gap, holdout_angle_arcsec=None, shrink_percent=None)
    diagnosis = replace(with_gap.diagnosis, verdict=verdict, settled=settled, gap=gap)
    answers = answer_questions(replace(with_gap, diagnosis=diagnosis))
    assert answers["What next"][-1].endswith(said)


def test_a_search_that_did_not_come_to_rest_is_told(with_gap: CampaignDiagnosis, text: str) -> None:
    assert UNSETTLED not in text
    restless = replace(with_gap.diagnosis, settled=False)
    assert UNSETTLED in build_page(replace(with_gap, diagnosis=restless))


def test_a_closing_that_makes_held_out_tests_worse_is_told(
    with_gap: CampaignDiagnosis, text: str
) -> None:
    assert WORSE_HELD_OUT not in text
    gap = with_gap.diagnosis.gap
    figure = gap.holdout_angle_arcsec
    assert figure is not None
    worse = replace(gap, holdout_angle_arcsec=replace(figure, after=2 * figure.before))
    wider = replace(with_gap, diagnosis=replace(with_gap.diagnosis, gap=worse))
    assert WORSE_HELD_OUT in build_page(wider)
    assert WORSE_HELD_OUT in " ".join(summarize_diagnosis(wider).split())


def test_no_gap_has_no_after(without_gap: CampaignDiagnosis) -> None:
    text = build_page(without_gap)
    elements(text)
    assert "No gap: the records agree with the simulation of the nominal gyro" in text
    assert "No effect of the catalogue is needed." in text
    assert "nominal gyro</text>" in text
    assert "identified gyro</text>" not in text


def test_without_held_out_tests(with_gap: CampaignDiagnosis) -> None:
    kept = [i for i, t in enumerate(with_gap.tests) if not t.test.is_holdout]
    gap = replace(
        with_gap.diagnosis.gap,
        holdout_angle_arcsec=None,
        holdout_rate_deg_h=None,
        shrink_percent=None,
        whiteness=None,
    )
    text = build_page(
        replace(
            with_gap,
            diagnosis=replace(with_gap.diagnosis, gap=gap),
            tests=tuple(with_gap.tests[i] for i in kept),
            before=tuple(with_gap.before[i] for i in kept),
            after=tuple(with_gap.after[i] for i in kept),
        )
    )
    elements(text)
    assert "No test was held out" in text


def test_what_is_confounded_and_what_would_tell(with_gap: CampaignDiagnosis) -> None:
    cause = replace(with_gap.diagnosis.causes[0], equivalents=("drive_frame_rotation",))
    said = replace(
        with_gap.diagnosis,
        verdict="ambiguous",
        causes=(cause,),
        next_test=NextTest("phase_step", "It turns one and not the other.", 2.5),
    )
    text = build_page(replace(with_gap, diagnosis=said))
    assert "or drive frame rotation: confounded in these records" in text
    assert "Next test: phase step, 2.5 h: It turns one and not the other." in text
    assert "<b>phase step</b>: It turns one and not the other." in text


def test_noises_are_causes_too(with_gap: CampaignDiagnosis) -> None:
    name = "angle_random_walk_deg_sqrt_h"
    noise = Cause("angle_random_walk", 0.97, {name: 1e-3}, {name: (8e-4, 1.2e-3)})
    text = build_page(replace(with_gap, diagnosis=replace(with_gap.diagnosis, causes=(noise,))))
    assert "Angle random walk: 0.00100 (0.00080 to 0.00120) deg/√h" in text
    assert "Angle random walk: probability 97.0" in text


def test_names_are_only_names(with_gap: CampaignDiagnosis) -> None:
    evil = "</script><script>alert(1)</script>"
    first = with_gap.tests[0]
    tests = (replace(first, test=replace(first.test, id=evil)), *with_gap.tests[1:])
    where = tuple(replace(w, test=evil) for w in with_gap.diagnosis.where)
    said = replace(with_gap.diagnosis, device=evil, where=where, excluded=(evil,))
    text = build_page(replace(with_gap, diagnosis=said, tests=tests))
    assert evil not in text
    assert text.count("<script") == 1
    elements(text)


def test_sections_of_others_stand_before_the_next_test(with_gap: CampaignDiagnosis) -> None:
    text = build_page(with_gap, [Section("position", "Position", "<p>12 m</p>", {})])
    elements(text)
    assert text.index('id="closing"') < text.index('id="position"') < text.index('id="next"')
    assert "<p>12 m</p>" in text


def test_noises_that_the_records_leave_open_are_told(with_gap: CampaignDiagnosis) -> None:
    one = with_gap.attribution.posterior.best
    lasting = UnnamedNoise(CorrelatedNoise(1e-9, 30.0, of_rate=True), 0.0)
    other = replace(one, noise=replace(one.noise, unnamed=lasting))
    both = replace(with_gap.attribution, posterior=Posterior((one, other), (0.75, 0.25)))
    told = build_page(replace(with_gap, attribution=both))
    title = "Noise hypotheses of the output angle, each with its most probable set of effects"
    words = "unnamed: noise of the rate that lasts 30 s (output angle)"
    assert title in told
    assert words in told
    assert "25.0" in told[told.index(words) :][:200]
    alone = replace(both, posterior=Posterior((one,), (1.0,)))
    assert title not in build_page(replace(with_gap, attribution=alone))
