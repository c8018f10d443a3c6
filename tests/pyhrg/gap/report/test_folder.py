"""A diagnosis' files appear together or not at all."""

import json
from pathlib import Path

import pytest

from pyhrg.gap.campaign_diagnosis import FILES, CampaignDiagnosis
from pyhrg.gap.report import page
from pyhrg.gap.report.sections import Section


def names(path: Path) -> set[str]:
    return {file.name for file in path.iterdir()}


def test_with_the_report(with_gap: CampaignDiagnosis, tmp_path: Path) -> None:
    page.write_report(with_gap, tmp_path / "out")
    assert names(tmp_path / "out") == {*FILES, "report.html"}


def test_without_the_report(with_gap: CampaignDiagnosis, tmp_path: Path) -> None:
    with_gap.write(tmp_path / "out")
    assert names(tmp_path / "out") == set(FILES)


def test_added_sections_have_files_of_their_own(
    with_gap: CampaignDiagnosis, tmp_path: Path
) -> None:
    section = Section("position", "Position", "<p>12 m</p>", {"metres": 12})
    page.write_report(with_gap, tmp_path, [section])
    assert names(tmp_path) == {*FILES, "position.json", "report.html"}
    assert json.loads((tmp_path / "position.json").read_text()) == {"metres": 12}
    assert "<p>12 m</p>" in (tmp_path / "report.html").read_text()


def test_nothing_is_left_where_the_page_fails(
    with_gap: CampaignDiagnosis, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> str:
        raise RuntimeError("no page")

    with_gap.write(tmp_path)
    before = names(tmp_path)
    (tmp_path / "diagnosis.json").write_text("of before")
    monkeypatch.setattr(page, "build_page", fail)
    with pytest.raises(RuntimeError):
        page.write_report(with_gap, tmp_path)
    assert names(tmp_path) == before
    assert (tmp_path / "diagnosis.json").read_text() == "of before"
    with pytest.raises(RuntimeError):
        page.write_report(with_gap, tmp_path / "new")
    assert not (tmp_path / "new").exists()
