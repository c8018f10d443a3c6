"""The verdict and the answers: what they say, on the page and in the terminal."""

import html
import re
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.findings.diagnosis import (
    Verdict,
    Worth,
)
from pyhrg.gap.findings.faults import list_fault_causes, list_tolerated_faults
from pyhrg.gap.findings.term import Formula, Term
from pyhrg.gap.replay.recorder import SCALES
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.report.next_steps import REMEDIES
from pyhrg.gap.report.page import build_page
from pyhrg.gap.report.terms import build_terms
from pyhrg.gap.report.verdict import (
    answer_questions,
    summarize_diagnosis,
    write_headline,
)
from pyhrg.gap.soundness.fault import FAULT_NAMES, LOST_ROWS, OUTLIERS, TABLE_SIGN, Fault


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
        "Off within tolerance, which is no gap: outliers.",
    ]
    assert answers["What next"][:2] == [REMEDIES["mounting_sign"], REMEDIES["lost_rows"]]
    assert not any("use them" in sentence for sentence in answers["What next"])
    page = build_page(replace(without_gap, diagnosis=diagnosis))
    assert "after.toml where it has them" in page
    assert re.search("Off within tolerance.*<td>outliers</td><td>0.1</td><td>0</td>", page)


def test_every_fault_has_a_remedy() -> None:
    assert set(REMEDIES) == {*FAULT_NAMES, *SCALES.values()}


def test_page_and_terminal_begin_with_the_same_five_answers(
    with_gap: CampaignDiagnosis,
) -> None:
    text = build_page(with_gap)
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
    assert any(re.search("mechanism 30, .*authority. To tell:", s) for s in answers["What next"])
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
        assert "is nearest to known mechanism 1, damping anisotropy." in next_steps
        assert ("To tell: a ring-down" in next_steps) == is_asked
        assert ("To tell: a ring-down" in build_terms(result)) == is_asked


def test_what_a_cause_makes_is_what_the_simulated_gyro_makes(
    with_gap: CampaignDiagnosis, simulation: Simulation
) -> None:
    """In the output angle of the fitted test where it is largest."""
    (cause,) = with_gap.diagnosis.causes
    ends, fitted = (with_gap.nominal, with_gap.identified), with_gap.attribution.parts
    changes = [simulation.compute_difference(*ends, part.test)["gyro_angle"] for part in fitted]
    largest = max(float(np.sqrt(np.mean(change**2))) for change in changes) / ARCSEC
    assert cause.worth
    assert cause.worth.angle_arcsec == pytest.approx(largest, rel=0.01)
    assert with_gap.causes["makes_arcsec"].unique() == [cause.worth.angle_arcsec]
    (said,) = [s for s in answer_questions(with_gap)["How much"] if " makes up to " in s]
    assert said.startswith("Damping anisotropy makes up to ")
    assert not said.endswith("immaterial.")


def test_an_immaterial_cause_is_named_last(with_gap: CampaignDiagnosis) -> None:
    (large,) = with_gap.diagnosis.causes
    small = replace(large, effect="frequency_split", worth=Worth(0.01, 1e-6, 1e-6))
    diagnosis = replace(with_gap.diagnosis, causes=(small, large))
    both = replace(with_gap, diagnosis=diagnosis)
    assert write_headline(diagnosis).endswith(
        "its cause is damping anisotropy; frequency split takes part too, but what it makes is "
        "immaterial."
    )
    assert sum(s.endswith("; immaterial.") for s in answer_questions(both)["How much"]) == 1
    alone = write_headline(replace(diagnosis, causes=(small,)))
    assert alone.endswith("its cause is frequency split, immaterial by the bound.")


def test_an_immaterial_cause_without_a_name_stands_in_the_headline(
    with_gap: CampaignDiagnosis,
) -> None:
    diagnosis = replace(with_gap.diagnosis, unknown_probability=0.999)
    assert diagnosis.verdict == "explained"
    words = "; a cause outside the catalogue takes part too, but what it makes is immaterial."
    assert write_headline(diagnosis).endswith(f"damping anisotropy{words}")
    answers = answer_questions(replace(with_gap, diagnosis=diagnosis))
    assert any(s.endswith("but immaterial by the bound.") for s in answers["How sure"])
    cases: tuple[tuple[float, Verdict], ...] = ((0.4, "explained"), (0.999, "unexplained"))
    for probability, verdict in cases:
        said = replace(diagnosis, unknown_probability=probability, verdict=verdict)
        assert words not in write_headline(said)


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


def test_a_search_that_did_not_converge_is_said_first(with_gap: CampaignDiagnosis) -> None:
    result = replace(with_gap, diagnosis=replace(with_gap.diagnosis, settled=False))
    headline = write_headline(result.diagnosis)
    assert headline.startswith("Do not rely on this, the search did not converge. The gap is ")
    first, *_ = answer_questions(result)["What next"]
    assert first.startswith("First check units and scales of the records, above all of the output")
