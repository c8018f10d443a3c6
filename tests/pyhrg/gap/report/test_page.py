"""The page: whole, self-contained, small, the same bytes for the same diagnosis."""

import re
from dataclasses import replace

import pytest

from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.evidence.noise.noise_hypothesis import UnnamedNoise
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.findings.diagnosis import (
    UNSETTLED,
    WORSE_HELD_OUT,
    Cause,
    NextTest,
)
from pyhrg.gap.report.page import build_page
from pyhrg.gap.report.sections import Section
from pyhrg.gap.report.verdict import (
    summarize_diagnosis,
)
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
