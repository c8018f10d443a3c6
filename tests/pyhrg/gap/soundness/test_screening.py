"""Screening keeps every error of a gyro, and names mixed-up columns, units, signs and files."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG, HZ
from pyhrg.fmu import GyroFmu
from pyhrg.gap.effects.catalogue import DETERMINISTIC, NOISES, Effect, NoiseEffect
from pyhrg.gap.soundness import build_nominal_device, screen_campaign
from pyhrg.records import COLUMNS, Log, campaign
from pyhrg.records.campaign import Campaign, CampaignError
from tests.pyhrg.gap.soundness.conftest import NOMINAL, record_campaign
from tests.pyhrg.gap.soundness.spoil import (
    Change,
    added,
    change_logs,
    drop_tests,
    removed,
    scaled,
    shifted,
    swapped,
)

STRENGTH = 10
"""Size of a planted effect, in its scale."""


def assert_unchanged(given: Campaign) -> None:
    screened, exclusions, _ = screen_campaign(given)
    assert exclusions == ()
    assert [test.id for test in screened.tests] == [test.id for test in given.tests]
    for before, after in zip(given.tests, screened.tests, strict=True):
        for column in COLUMNS:
            values = getattr(before.log, column.field), getattr(after.log, column.field)
            np.testing.assert_array_equal(*values)


def test_a_campaign_without_errors_is_unchanged(error_free: Campaign) -> None:
    assert_unchanged(error_free)


@pytest.mark.parametrize("effect", DETERMINISTIC, ids=lambda effect: effect.name)
def test_no_effect_is_excluded(slow_fmu: GyroFmu, effect: Effect) -> None:
    strength = np.zeros(effect.size)
    strength[0] = STRENGTH * effect.scale
    device = effect.put(NOMINAL, effect.vector(NOMINAL) + strength)
    assert_unchanged(record_campaign(slow_fmu, device))


@pytest.mark.parametrize("noise", NOISES, ids=lambda noise: noise.name)
def test_no_noise_is_excluded(slow_fmu: GyroFmu, noise: NoiseEffect) -> None:
    loud: dict[str, Any] = {noise.field: STRENGTH * noise.scale}
    assert_unchanged(record_campaign(slow_fmu, replace(NOMINAL, **loud)))


def test_a_gyro_is_held_at_the_set_point_of_its_logs(error_free: Campaign) -> None:
    """Started at another amplitude, its first seconds were read as a filter delay."""
    amplitude = build_nominal_device(error_free).amplitude
    stated = replace(error_free, nominal={**error_free.nominal, "amplitude": 1.05 * amplitude})
    screened, (sentence,), _ = screen_campaign(stated)
    assert build_nominal_device(screened) == build_nominal_device(error_free)
    assert f"{1.05 * amplitude:g}, but every log begins with a set point of" in sentence


def test_coarse_and_badly_timed_logs_are_unchanged(error_free: Campaign) -> None:
    def coarse(log: Log) -> Log:
        later = log.wave_angle + 5e-3 * np.gradient(log.wave_angle, log.interval)
        return replace(log, wave_angle=0.1 * DEG * np.round(later / (0.1 * DEG)))

    assert_unchanged(change_logs(error_free, coarse))


@pytest.mark.parametrize("number", range(1, 7))
def test_recorded_campaigns_are_unchanged(recorded_campaign: Path, number: int) -> None:
    assert_unchanged(campaign.read_campaign(recorded_campaign.parent / f"dev-0{number}"))


ANGLES_SWAPPED = [("wave", "gyro"), ("table", "gyro"), ("table", "wave")]


@pytest.mark.parametrize(("one", "other"), ANGLES_SWAPPED)
def test_swapped_angles_are_refused(error_free: Campaign, one: str, other: str) -> None:
    names = rf"{one}_angle and {other}_angle|{other}_angle and {one}_angle"
    with pytest.raises(CampaignError, match=rf"and others: columns ({names}): .* swapped\?"):
        screen_campaign(change_logs(error_free, swapped(f"{one}_angle", f"{other}_angle")))


CONTRADICTED_NOMINAL: list[tuple[Change, str]] = [
    (
        scaled(-1, "wave_angle"),
        r"coriolis_factor: .* implies coriolis_factor -0\.277; expected 0\.2",
    ),
    (scaled(1e3 * DEG, "wave_angle"), "implies coriolis_factor 4.83"),
    (scaled(3600, "gyro_angle"), "implies coriolis_factor 7.69"),
    (shifted(300 * HZ, "frequency_offset"), "implies frequency_Hz 7300; expected 69"),
    (shifted(7000 * HZ, "frequency_offset"), "implies frequency_Hz 1.4e"),
]


@pytest.mark.parametrize(("change", "message"), CONTRADICTED_NOMINAL)
def test_logs_of_another_gyro_are_refused(
    error_free: Campaign, change: Change, message: str
) -> None:
    with pytest.raises(CampaignError, match=f"{message}.*another gyro's"):
        screen_campaign(change_logs(error_free, change))


@pytest.mark.parametrize(("key", "value"), [("coriolis_factor", 0.3), ("decay_time_s", 900.0)])
def test_nominal_values_of_another_gyro_are_refused(
    error_free: Campaign, key: str, value: float
) -> None:
    with pytest.raises(CampaignError, match=rf"campaign\.json: nominal\.{key}: contradicted by"):
        screen_campaign(replace(error_free, nominal={**error_free.nominal, key: value}))


def test_nominal_values_are_checked(error_free: Campaign) -> None:
    short = {key: value for key, value in error_free.nominal.items() if key != "decay_time_s"}
    with pytest.raises(CampaignError, match=r"nominal\.decay_time_s: missing; expected a number"):
        screen_campaign(replace(error_free, nominal=short))
    with pytest.raises(HrgError, match=r"nominal: decay_time_s: found -1\.0, expected 1 to"):
        screen_campaign(replace(error_free, nominal=short | {"decay_time_s": -1.0}))
    screened, exclusions, _ = screen_campaign(
        replace(error_free, nominal={**error_free.nominal, "colour": 3.0})
    )
    assert exclusions == ("campaign.json: nominal.colour: not known, ignored",)
    assert build_nominal_device(screened) == build_nominal_device(error_free)


EXCLUDED: list[tuple[Change, tuple[str, ...], str]] = [
    (
        swapped("amplitude_force", "quadrature_force"),
        ("amplitude_force", "quadrature_force"),
        r"the second holds 1/\d+(\.\d+)? s, the decay: are they swapped\?",
    ),
    (
        scaled(3600, "amplitude_force"),
        ("amplitude_force",),
        r"amplitude_force_per_s: implies decay_time_s 0\.12\d*; expected 360 to 540",
    ),
    (scaled(2, "amplitude"), ("amplitude",), "2 of amplitude_setpoint; expected about 1"),
    (
        shifted(300 * HZ, "frequency_offset"),
        ("frequency_offset",),
        "frequency_offset_Hz: implies frequency_Hz 7300; expected 6930 to 7070",
    ),
]


@pytest.mark.parametrize(("change", "fields", "message"), EXCLUDED)
def test_an_impossible_output_is_excluded(
    error_free: Campaign, change: Change, fields: tuple[str, ...], message: str
) -> None:
    screened, exclusions, _ = screen_campaign(change_logs(error_free, change, "still"))
    assert len(exclusions) == 1
    assert re.match(rf"still: columns? .*{message}", exclusions[0])
    for test in screened.tests:
        for field in fields:
            assert np.isnan(getattr(test.log, field)).all() == (test.id == "still")


NOT_USED: list[tuple[Change, str]] = [
    (
        scaled(-1, "wave_angle"),
        r"gyro_angle_deg, wave_angle_deg: .*the factor is -0\.277; expected 0\.277",
    ),
    (scaled(-1, "table_angle"), r"turns by 29\d.*expected -29.*is a sign reversed\?"),
    (scaled(2, "table_angle"), "turns by 29.*; expected 59.* as the table, plus Earth's rotation$"),
    (shifted(500.0, "time"), r"time_s 500\.5 to 570 in 140 rows; expected 0\.5 to 70"),
    (removed("gyro_angle", "wave_angle"), "no angle of the gyro is left"),
    (removed("axis_up", "acceleration_z"), "columns axis_up and accel_z_m_s2 missing; expected on"),
    (removed("table_angle"), r"turns by 29\d.*expected 0 deg"),
]


@pytest.mark.parametrize(("change", "message"), NOT_USED)
def test_a_test_that_cannot_be_replayed_is_excluded(
    error_free: Campaign, change: Change, message: str
) -> None:
    screened, exclusions, _ = screen_campaign(change_logs(error_free, change, "pos"))
    assert [test.id for test in screened.tests] == [t.id for t in error_free.tests if t.id != "pos"]
    assert any(re.search(message, text) for text in exclusions)
    assert any(text.startswith("pos: not used: ") for text in exclusions)


def test_a_log_without_temperature_is_used_only_at_rest(error_free: Campaign) -> None:
    """The still test without its thermometer, as it is, and warmed by 5 K as the loop shows."""
    blind = change_logs(error_free, removed("temperature"), "still")
    assert len(screen_campaign(blind).campaign.tests) == len(error_free.tests)
    log = next(test.log for test in blind.tests if test.id == "still")
    rise = NOMINAL.frequency * NOMINAL.frequency_per_kelvin * np.linspace(0, 5, len(log.time))
    warmed = change_logs(blind, added(rise, "frequency_offset"), "still")
    screened, sentences, _ = screen_campaign(warmed)
    assert len(screened.tests) == len(error_free.tests) - 1
    assert any("the loop's frequency changes as over 4.9 K" in text for text in sentences)


def test_an_unreadable_log_is_excluded(error_free: Campaign, tmp_path: Path) -> None:
    campaign.write_campaign(error_free, tmp_path)
    (tmp_path / "pos.csv.gz").write_bytes(b"time_s\n1\nx\n")
    (tmp_path / "neg.csv.gz").unlink()
    screened, exclusions, _ = screen_campaign(campaign.read_campaign(tmp_path))
    assert len(screened.tests) == len(error_free.tests) - 2
    assert "pos: not used: pos.csv.gz: row 3, time_s: 'x'; expected a number" in exclusions
    assert any(re.match(r"neg: not used: .*No such file", text) for text in exclusions)


def test_truth_is_not_read(error_free: Campaign, tmp_path: Path) -> None:
    campaign.write_campaign(error_free, tmp_path)
    (tmp_path / "truth.json").write_text("{ no json")
    assert screen_campaign(campaign.read_campaign(tmp_path))[1] == ()


def test_nothing_to_fit_is_refused(error_free: Campaign) -> None:
    with pytest.raises(CampaignError, match=r"no test that may be fitted.*: all are held out"):
        screen_campaign(
            replace(error_free, tests=tuple(t for t in error_free.tests if t.is_holdout))
        )
    with pytest.raises(CampaignError, match=r"no test that may be fitted.*no angle of the gyro"):
        screen_campaign(change_logs(error_free, removed("gyro_angle", "wave_angle")))


def test_a_holdout_that_is_also_fitted_is_dropped(error_free: Campaign) -> None:
    copy = replace(error_free.tests[0], id="copy", role="holdout")
    screened, exclusions, _ = screen_campaign(replace(error_free, tests=(*error_free.tests, copy)))
    assert exclusions == ("copy: not used: the same log as still",)
    assert len(screened.tests) == len(error_free.tests)
    assert screen_campaign(drop_tests(error_free, "ride"))[1] == (
        "no test is held out: a diagnosis can't be verified",
    )
