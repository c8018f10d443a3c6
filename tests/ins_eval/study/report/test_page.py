"""The page: whole, self-contained, small, the same bytes for the same study."""

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest

from ins_eval.study.report.page import make_sections, render_page, select_shown, write_page
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from tests.elements import check_drawings_have_words, check_nothing_is_loaded, elements
from tests.ins_eval.study.report.synthetic import MISSIONS, synthetic

MOST_BYTES = 3_000_000
ROWS = 8000


@pytest.fixture(scope="module")
def result() -> StudyData:
    return synthetic(12)


@pytest.fixture(scope="module")
def text(result: StudyData) -> str:
    return render_page(result)


def test_same_study_same_bytes(text: str) -> None:
    assert render_page(synthetic(12)) == text


def test_every_section_can_be_reached(result: StudyData, text: str) -> None:
    anchors = {attributes.get("id") for _, attributes in elements(text)}
    links = {a["href"] for tag, a in elements(text) if tag == "a"}
    assert links == {f"#{section.name}" for section in make_sections(result)}
    assert {str(link)[1:] for link in links} <= anchors


def test_nothing_is_loaded_from_anywhere(text: str) -> None:
    check_nothing_is_loaded(text)


def test_drawings_have_words_for_those_who_do_not_see_them(text: str) -> None:
    check_drawings_have_words(text)


def test_a_study_of_8000_rows_is_small_enough() -> None:
    large = synthetic(ROWS // len(MISSIONS) // 2, conditions=False)
    assert len(large.table) == ROWS
    assert len(render_page(large).encode()) <= MOST_BYTES


def test_embedded_points_are_those_of_the_table(result: StudyData, text: str) -> None:
    embedded = re.search(r'<script type="application/json" id="study">(.*?)</script>', text)
    assert embedded
    study = json.loads(embedded[1])
    judged = result.table[result.table[c.ROLE] == "test"]
    assert study["triad"] == judged[c.TRIAD].tolist()
    assert study["numbers"][c.FLOWN_RADIAL] == pytest.approx(
        (judged[c.FLOWN_RADIAL] / 1852).tolist(), rel=6e-4
    )
    named = study["names"][c.MISSION]
    assert [named["levels"][code] for code in named["codes"]] == judged[c.MISSION].tolist()


def test_the_page_shows_judged_triads_in_nautical_miles(result: StudyData) -> None:
    shown = select_shown(result).table
    assert set(shown[c.ROLE]) == {"test"}
    row = shown.index[0]
    assert shown[c.FLOWN_RADIAL][row] == result.table[c.FLOWN_RADIAL][row] / 1852
    assert shown[c.GROWTH][row][-1] == result.table[c.GROWTH][row][-1] / 1852
    assert shown[c.HOURS][row] == result.table[c.HOURS][row]


def test_missing_predictions_leave_a_word(result: StudyData) -> None:
    gone = {p: float("nan") for p in ("true_parameters_median_m", "true_parameters_low_m")}
    text = render_page(replace(result, table=result.table.assign(**gone)))
    assert "No predictions." in text
    elements(text)


def test_a_study_without_scores_says_so(result: StudyData) -> None:
    text = render_page(replace(result, scores=[]))
    assert "Not scored in this study" in text
    elements(text)


def test_names_are_only_names(result: StudyData) -> None:
    evil = "</script><script>alert(1)</script>"
    table = result.table.replace({c.MISSION: {"car": evil}, c.CLASS: {"car": evil}})
    text = render_page(replace(result, table=table))
    assert evil not in text
    assert text.count("<script") == 3
    elements(text)


def test_written_whole_or_not_at_all(result: StudyData, tmp_path: Path) -> None:
    write_page(result, tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == ["report.html"]
    before = (tmp_path / "report.html").read_bytes()
    broken = replace(result, table=result.table.drop(columns=[c.GROWTH]))
    with pytest.raises(KeyError):
        write_page(broken, tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == ["report.html"]
    assert (tmp_path / "report.html").read_bytes() == before
