"""Campaigns: what is written is read back, what is wrong is named by file and key."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import campaign
from pyhrg.records.campaign import Campaign, Test
from tests.pyhrg.records.made_up import LATITUDE, made_up_log


def made_up_campaign() -> Campaign:
    return Campaign(
        device="made up",
        site=Site(LATITUDE, 9.8015),
        nominal={"coriolis_factor": 0.277, "decay_time_s": 450.0},
        tests=(
            Test("still", "static", "fit", made_up_log(60)),
            Test("rate_pos", "rate", "fit", made_up_log(60, 5 * DEG)),
            Test("rate_neg", "rate", "holdout", made_up_log(60, -5 * DEG)),
        ),
        tolerances={"decay_time_s": 20.0, "amplitude_force_scale": 0.02},
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    campaign.write_campaign(made_up_campaign(), tmp_path / "campaign")
    return tmp_path / "campaign"


def edit(folder: Path, change: Callable[[dict[str, Any]], object]) -> None:
    path = folder / "campaign.json"
    index = json.loads(path.read_text())
    change(index)
    path.write_text(json.dumps(index))


def test_written_campaign_is_read_back(folder: Path, tmp_path: Path) -> None:
    made, found = made_up_campaign(), campaign.read_campaign(folder)
    assert found.device == made.device
    assert found.site.latitude == pytest.approx(made.site.latitude, rel=1e-15)
    assert found.site.gravity == made.site.gravity
    assert (found.nominal, found.tolerances) == (made.nominal, made.tolerances)
    for before, after in zip(made.tests, found.tests, strict=True):
        assert (after.id, after.kind, after.role) == (before.id, before.kind, before.role)
        assert after.log.exclusions == ()
        assert np.allclose(after.log.gyro_angle, before.log.gyro_angle, rtol=0, atol=1e-12)
    campaign.write_campaign(found, tmp_path / "again")
    with pytest.raises(campaign.CampaignError, match="again: found a campaign there; choose"):
        campaign.write_campaign(found, tmp_path / "again")
    campaign.write_campaign(found, tmp_path / "again", force=True)
    files = sorted(folder.iterdir())
    assert [file.name for file in sorted((tmp_path / "again").iterdir())] == [f.name for f in files]
    assert (tmp_path / "again" / "campaign.json").read_bytes() == files[0].read_bytes()


def test_tests_are_chosen_by_kind(folder: Path) -> None:
    found = campaign.read_campaign(folder)
    assert [test.id for test in found.of_kind("rate")] == ["rate_pos", "rate_neg"]
    assert [test.id for test in found.of_kind("static", "thermal")] == ["still"]
    assert [test.is_holdout for test in found.tests] == [False, False, True]


def test_logs_are_read_when_asked_for(folder: Path) -> None:
    (folder / "rate_pos.csv.gz").unlink()
    still, missing, _ = campaign.read_campaign(folder).tests
    assert len(still.log.time) == 60
    assert still.log is still.log
    with pytest.raises(HrgError, match=r"rate_pos\.csv\.gz: can't be read: No such file"):
        _ = missing.log


def test_number_of_rows_is_held_to_the_index(folder: Path) -> None:
    edit(folder, lambda index: index["tests"][0].update(n=3600))
    log = campaign.read_campaign(folder).tests[0].log
    assert log.exclusions == ("60 rows are of use; campaign.json says 3600",)


def test_interval_is_held_to_the_index(folder: Path) -> None:
    edit(folder, lambda index: index["tests"][0].update(interval_s=0.1))
    with pytest.raises(HrgError, match=r"still\.csv\.gz: time_s steps by 1; expected 0\.1"):
        _ = campaign.read_campaign(folder).tests[0].log


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            lambda c: c.update(schema="hrg-campaign/2"),
            r"schema: found 'hrg-campaign/2', expected hrg-",
        ),
        (lambda c: c.pop("schema"), "schema: found no such key, expected hrg-"),
        (lambda c: c.pop("site"), "site: found no such key, expected a table"),
        (lambda c: c["site"].pop("latitude_deg"), r"site\.latitude_deg: found no such key, exp"),
        (lambda c: c["site"].update(latitude_deg=120), r"latitude_deg: found 120, expected -90 to"),
        (lambda c: c["site"].update(gravity_m_s2=1), r"gravity_m_s2: found 1, expected 9\.7 to"),
        (
            lambda c: c["nominal"].update(decay_time_s="long"),
            r"nominal\.decay_time_s: found 'long'",
        ),
        (lambda c: c["nominal"].update(decay_time_s=np.nan), r"decay_time_s: found nan, expected"),
        (lambda c: c["nominal"].update(decay_time_s=True), r"decay_time_s: found True, exp"),
        (lambda c: c["nominal"].update(decay_time_s=10**400), r"decay_time_s: found 1000.*, exp"),
        (lambda c: c.update(tests={}), r"tests: found \{\}, expected tables"),
        (lambda c: c["tests"].append(7), r"tests\[3\]: found 7, expected a table"),
        (lambda c: c["tests"][1].pop("file"), r"tests\[1\]\.file: found no such key, exp"),
        (lambda c: c["tests"][1].update(file="../x.csv"), r"tests\[1\]\.file: found '\.\./x\.csv'"),
        (lambda c: c["tests"][1].update(role="train"), r"role: found 'train', expected fit or"),
        (lambda c: c["tests"][1].update(n=6.5), r"tests\[1\]\.n: found 6\.5, expected a whole"),
        (
            lambda c: c["tests"][1].update(interval_s=0),
            r"tests\[1\]\.interval_s: found 0, expected",
        ),
        (lambda c: c["tests"][1].update(id="still"), "test 'still': expected a file name, each"),
    ],
)
def test_wrong_key_is_named(
    folder: Path, change: Callable[[dict[str, Any]], object], message: str
) -> None:
    edit(folder, change)
    with pytest.raises(HrgError, match=message) as caught:
        campaign.read_campaign(folder)
    assert "campaign.json" in str(caught.value)


def test_folder_without_an_index_is_no_campaign(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"campaign\.json: can't be read"):
        campaign.read_campaign(tmp_path)
    (tmp_path / "campaign.json").write_text("[1, 2")
    with pytest.raises(HrgError, match=r"campaign\.json: found what is no JSON"):
        campaign.read_campaign(tmp_path)
    (tmp_path / "campaign.json").write_text("[1, 2]")
    with pytest.raises(HrgError, match="found list, expected a JSON object"):
        campaign.read_campaign(tmp_path)


@pytest.mark.parametrize("names", [("a/b", "c"), ("a", "a"), ("", "b")])
def test_campaign_is_not_written_under_impossible_names(
    tmp_path: Path, names: tuple[str, str]
) -> None:
    tests = tuple(Test(name, "static", "fit", made_up_log(12)) for name in names)
    with pytest.raises(HrgError, match="expected a file name, each once"):
        campaign.write_campaign(Campaign("x", Site(LATITUDE, 9.8), {}, tests), tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_recorded_campaign_is_read(recorded_campaign: Path) -> None:
    found = campaign.read_campaign(recorded_campaign)
    assert found.nominal["coriolis_factor"] == 0.277
    assert [test.kind for test in found.tests if test.is_holdout] == ["manoeuvre"]
    assert all(test.log.exclusions == () for test in found.tests)


@pytest.mark.parametrize(
    ("key", "value", "expected"),
    [
        ("decay_time", 20.0, "tolerances.decay_time: found an unknown key"),
        ("decay_time_s", 0.0, "tolerances.decay_time_s: found 0.0, expected"),
    ],
)
def test_a_wrong_tolerance_is_named(folder: Path, key: str, value: float, expected: str) -> None:
    edit(folder, lambda index: index["tolerances"].update({key: value}))
    with pytest.raises(HrgError, match=expected):
        campaign.read_campaign(folder)
