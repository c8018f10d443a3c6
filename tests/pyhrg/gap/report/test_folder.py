"""A diagnosis' files, together or not at all."""

import json
from pathlib import Path

import pytest

from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.report import folder, sections
from pyhrg.gap.report.sections import Section


def names(path: Path) -> set[str]:
    return {file.name for file in path.iterdir()}


@pytest.fixture
def _alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """No package above."""
    monkeypatch.setattr(sections, "names", list)
    monkeypatch.setattr(sections, "sections", lambda _folder, _say: {})


@pytest.mark.usefixtures("_alone")
def test_with_the_report(with_gap: Diagnosed, tmp_path: Path) -> None:
    folder.keep_with_report(with_gap, tmp_path / "out")
    assert names(tmp_path / "out") == {*folder.FILES, "report.html"}


def test_without(with_gap: Diagnosed, tmp_path: Path) -> None:
    folder.keep(with_gap, tmp_path / "out")
    assert names(tmp_path / "out") == set(folder.FILES)


def test_sections_of_others_have_files_of_their_own(
    with_gap: Diagnosed, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[set[str]] = []

    def brought(place: Path, _say: object) -> dict[str, Section]:
        seen.append(names(place))
        return {"position": Section("Position", "<p>12 m</p>", {"metres": 12})}

    monkeypatch.setattr(sections, "names", lambda: ["position"])
    monkeypatch.setattr(sections, "sections", brought)
    folder.keep_with_report(with_gap, tmp_path)
    assert seen == [set(folder.FILES)]
    assert json.loads((tmp_path / "position.json").read_text()) == {"metres": 12}
    assert "<p>12 m</p>" in (tmp_path / "report.html").read_text()


@pytest.mark.usefixtures("_alone")
def test_nothing_is_left_where_the_page_fails(
    with_gap: Diagnosed, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object) -> str:
        raise RuntimeError("no page")

    folder.keep(with_gap, tmp_path)
    before = {name: (tmp_path / name).read_bytes() for name in names(tmp_path)}
    (tmp_path / "diagnosis.json").write_text("of before")
    monkeypatch.setattr(folder, "page", broken)
    with pytest.raises(RuntimeError):
        folder.keep_with_report(with_gap, tmp_path)
    assert names(tmp_path) == set(before)
    assert (tmp_path / "diagnosis.json").read_text() == "of before"
    with pytest.raises(RuntimeError):
        folder.keep_with_report(with_gap, tmp_path / "new")
    assert not (tmp_path / "new").exists()
