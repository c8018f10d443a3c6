"""A whole challenge on short campaigns, with a diagnosis that says the same of all."""

import json
import os
import shutil
import signal
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pyhrg.challenge import run
from pyhrg.challenge.roster import Folder, Settings
from pyhrg.challenge.run import Challenge
from pyhrg.challenge.truths.seal import ChallengeError, hash_truth
from pyhrg.common.cli import main
from pyhrg.common.errors import HrgError
from pyhrg.gap.findings.diagnosis import Diagnosis, Gap, GapFigure, NextTest, write
from pyhrg.records import campaign
from tests.pyhrg.challenge.short import quick_cases  # noqa: F401

SETTINGS = Settings({"none": 2, "single": 1}, seed=3)
FIGURE = GapFigure(1.0, 1.0, 1.0, (0.5, 2.0))
NO_GAP = Diagnosis(
    device="unit",
    verdict="no_gap",
    causes=(),
    unknown_probability=0.02,
    where=(),
    sizes=(),
    gap=Gap(FIGURE, None, None, None, None, None),
    next_test=None,
    unnamed={},
    excluded=(),
)
CONFOUNDED = replace(NO_GAP, verdict="ambiguous", next_test=NextTest("tumble", "it separates", 0.5))


def says_no_gap(campaign: Path, out: Path, without: Sequence[str]) -> None:
    write(NO_GAP, out)


def asks_for_a_test(campaign: Path, out: Path, without: Sequence[str]) -> None:
    write(CONFOUNDED, out)


def says_nothing(campaign: Path, out: Path, without: Sequence[str]) -> None:
    """As a diagnosis that failed without a word."""


def refuses(campaign: Path, out: Path, without: Sequence[str]) -> None:
    """As a diagnosis of records that can't be used."""
    raise HrgError(f"{campaign.name}: no test can be fitted to")


def is_killed(campaign: Path, out: Path, without: Sequence[str]) -> None:
    """As by a system that has no memory left."""
    os.kill(os.getpid(), signal.SIGKILL)


def is_interrupted(campaign: Path, out: Path, without: Sequence[str]) -> None:
    """As by Ctrl-C, of which the first process alone is told, while all are at work."""
    if campaign.name == "unit-0002":
        os.kill(os.getppid(), signal.SIGINT)
    time.sleep(600)


def files(root: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(root)): path.read_bytes() for path in root.rglob("*") if path.is_file()
    }


@pytest.mark.usefixtures("quick_cases")
def test_same_bytes_again_and_resumed(tmp_path: Path) -> None:
    Challenge(Folder(tmp_path / "a"), SETTINGS, says_no_gap).run(1)
    with pytest.raises(ChallengeError, match=r"has written no diagnosis\.json"):
        Challenge(Folder(tmp_path / "b"), SETTINGS, says_nothing).run(1)
    assert not (tmp_path / "b" / "score.json").exists()
    Challenge(Folder(tmp_path / "b"), SETTINGS, says_no_gap).run(1)
    assert files(tmp_path / "a") == files(tmp_path / "b")


@pytest.mark.usefixtures("quick_cases")
def test_a_refused_campaign_is_scored_with_its_sentence(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    Challenge(folder, SETTINGS, refuses).run(1)
    (challenge,) = json.loads(folder.score.read_text())["challenges"]
    assert [case["refused"] for case in challenge["cases"]] == [
        f"unit-000{i}: no test can be fitted to" for i in (1, 2, 3)
    ]
    again = Challenge(folder, SETTINGS, says_no_gap).run(1)  # a refusal is not tried again
    assert again.figures[0].value == 1


@pytest.mark.usefixtures("quick_cases")
def test_a_worker_that_is_killed_is_told_with_its_campaign(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    Challenge(folder, SETTINGS, says_no_gap).run(1)
    done = files(tmp_path)
    shutil.rmtree(folder.diagnosis("unit-0002"))
    with pytest.raises(ChallengeError, match=r"diagnosed: a worker was killed, .* unit-0002; what"):
        Challenge(folder, SETTINGS, is_killed).run(2)
    Challenge(folder, SETTINGS, says_no_gap).run(2)
    assert files(tmp_path) == done


@pytest.mark.usefixtures("quick_cases")
def test_an_interrupted_challenge_ends_at_once_and_goes_on(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    Challenge(folder, SETTINGS, says_no_gap).run(1)
    done = files(tmp_path)
    for name in ("unit-0001", "unit-0002", "unit-0003"):
        shutil.rmtree(folder.diagnosis(name))
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        Challenge(folder, SETTINGS, is_interrupted).run(2)
    assert time.monotonic() - begun < 300
    Challenge(folder, SETTINGS, says_no_gap).run(1)
    assert files(tmp_path) == done


@pytest.mark.usefixtures("quick_cases")
def test_what_is_diagnosed_tells_nothing_of_the_truth(tmp_path: Path) -> None:
    seen: list[Path] = []

    def looking(folder: Path, out: Path, without: Sequence[str]) -> None:
        seen.append(folder)
        assert (tmp_path / "challenge.json").exists()
        names = {path.name for path in folder.iterdir()}
        assert names == {"campaign.json", "rate.csv.gz", "manoeuvre.csv.gz"}
        assert not any(
            word in (folder / "campaign.json").read_text() for word in ("truth", "kind:")
        )
        says_no_gap(folder, out, without)

    score = Challenge(Folder(tmp_path), SETTINGS, looking).run(1)
    assert [folder.name for folder in seen] == ["unit-0001", "unit-0002", "unit-0003"]
    assert sorted(case.truth.kind for case in score.cases) == ["none", "none", "single"]
    index = json.loads((tmp_path / "challenge.json").read_text())
    assert set(index["cases"][0]) == {"name", "sha256", "without"}


@pytest.mark.usefixtures("quick_cases")
def test_a_truth_that_was_changed_is_refused(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    Challenge(folder, SETTINGS, says_no_gap).run(1)
    path = folder.truth("unit-0001")
    path.write_text(path.read_text().replace("{", "{ ", 1))
    with pytest.raises(ChallengeError, match="truths are not those that it has published"):
        Challenge(folder, SETTINGS, says_no_gap).run(1)
    assert hash_truth(path)


@pytest.mark.usefixtures("quick_cases")
def test_a_suggested_test_is_made_and_diagnosed(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    settings = Settings({"single": 1}, seed=3)
    score = Challenge(folder, settings, asks_for_a_test).run(1)
    (case,) = score.cases
    extended = campaign.read_campaign(folder.next.campaign(case.name))
    assert [test.kind for test in extended.tests] == ["rate", "manoeuvre", "tumble"]
    settled = next(f for f in score.figures if f.name.startswith("next test"))
    assert (settled.n, settled.value) == (1, 0.0)


@pytest.mark.usefixtures("quick_cases")
def test_challenges_of_other_seeds_are_scored_together(tmp_path: Path) -> None:
    one, two, same, begun = (Folder(tmp_path / name) for name in ("1", "2", "same", "begun"))
    Challenge(one, SETTINGS, says_no_gap).run(1)
    other = Challenge(two, replace(SETTINGS, seed=4), says_no_gap)
    score = other.run(1, [one])
    assert [len(challenge.cases) for challenge in score.challenges] == [3, 3]
    assert [figure.n for figure in score.figures[:2]] == [4, 2]
    listed = json.loads(two.score.read_text())["challenges"]
    assert [(of["seed"], len(of["cases"])) for of in listed] == [(4, 3), (3, 3)]
    with pytest.raises(ChallengeError, match="1: seed 3 is scored already"):
        Challenge(same, SETTINGS, says_no_gap).run(1, [one])
    with pytest.raises(HrgError, match=r"settings\.json: can't be read: No such file"):
        other.run(1, [begun])
    begun.begin(SETTINGS)
    with pytest.raises(HrgError, match=r"challenge\.json: can't be read: No such file"):
        other.run(1, [begun])
    begun.index.write_text("{}")
    with pytest.raises(HrgError, match=r"challenge\.json: cases: found None, expected"):
        other.run(1, [begun])
    begun.index.write_text('{"cases": []}')
    with pytest.raises(HrgError, match=r"unit-0001\.json: can't be read"):
        other.run(1, [begun])


@pytest.mark.usefixtures("quick_cases")
def test_another_challenge_is_not_mixed_in(tmp_path: Path) -> None:
    Folder(tmp_path).begin(SETTINGS)
    with pytest.raises(ChallengeError, match="another challenge was begun here"):
        Folder(tmp_path).begin(Settings({"none": 1}, seed=3))


@pytest.mark.usefixtures("quick_cases")
def test_results_of_two_versions_are_not_mixed(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    folder.begin(SETTINGS)
    settings = json.loads(folder.settings.read_text())
    settings["made_by"]["code"] = "older"
    folder.settings.write_text(json.dumps(settings))
    with pytest.raises(ChallengeError, match="another version: code: found older, expected"):
        folder.begin(SETTINGS)
    assert json.loads(folder.settings.read_text()) == settings


def test_names_and_order_tell_nothing_of_the_kinds() -> None:
    counts = {"none": 30, "single": 30, "outside": 30, "left_out": 3}
    cases = Settings(counts, seed=1).list_cases()
    assert [case.name for case in cases] == [f"unit-{i:04d}" for i in range(1, 94)]
    kinds = [case.kind for case in cases]
    assert sorted(kinds) != kinds
    assert {kind: kinds.count(kind) for kind in counts} == counts
    assert len({case.seed for case in cases}) == len(cases)
    assert len({case.without for case in cases if case.without}) == 3
    assert Settings(counts, seed=2).list_cases()[0].seed != cases[0].seed


@pytest.mark.usefixtures("quick_cases")
def test_command_prints_the_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(run, "diagnose_folder", says_no_gap)
    few = ["--none", "1", "--single", "0", "--pairs", "0", "--outside", "0", "--workers", "1"]
    assert main(["gap", "challenge", "--out", str(tmp_path), *few]) == 0
    shown = capsys.readouterr().out
    assert "false alarm without a gap" in shown
    assert "<= 0.02  pass" in shown
    assert "no case" in shown
    figures = json.loads((tmp_path / "score.json").read_text())["figures"]
    assert figures[0]["n"] == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"none": -1}, "none: found -1, expected a whole number from 0"),
        ({"seed": -1}, "seed: found -1, expected"),
        ({"workers": 0}, "workers: found 0, expected"),
        ({"data": "none"}, "data: found 'none', expected full, few, short, coarse"),
        ({"strongest": 6.0}, "strongest: found 6, expected above 6"),
        ({"strongest": 2.0**63}, r"strongest: found 9.22337e\+18, expected above 6, up to 1e\+06"),
    ],
)
def test_arguments_out_of_range_are_refused(
    tmp_path: Path, arguments: dict[str, Any], message: str
) -> None:
    with pytest.raises(HrgError, match=message):
        run.run_challenge(tmp_path, diagnose=says_no_gap, **arguments)
