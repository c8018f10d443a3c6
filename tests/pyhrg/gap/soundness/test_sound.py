"""No gyro's own error is taken out, and what is mixed up is named."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pyhrg.common.units import DEG, HZ
from pyhrg.fmu import GyroFmu
from pyhrg.gap.effects.catalogue import DETERMINISTIC, NOISES, Effect, NoiseEffect
from pyhrg.gap.soundness import sound
from pyhrg.records import COLUMNS, Log, campaign
from pyhrg.records.campaign import Campaign, CampaignError
from tests.pyhrg.gap.soundness.conftest import BELIEVED, recorded
from tests.pyhrg.gap.soundness.spoil import (
    Change,
    lacking,
    removed,
    scaled,
    shifted,
    spoilt,
    swapped,
)

STRONG = 10
"""Times a size that is nothing special."""


def check_untouched(given: Campaign) -> None:
    found, exclusions = sound(given)
    assert exclusions == ()
    assert [test.id for test in found.tests] == [test.id for test in given.tests]
    for before, after in zip(given.tests, found.tests, strict=True):
        for column in COLUMNS:
            values = getattr(before.log, column.field), getattr(after.log, column.field)
            np.testing.assert_array_equal(*values)


def test_an_honest_campaign_is_untouched(honest: Campaign) -> None:
    check_untouched(honest)


@pytest.mark.parametrize("effect", DETERMINISTIC, ids=lambda effect: effect.name)
def test_no_effect_is_taken_out(slow_fmu: GyroFmu, effect: Effect) -> None:
    strength = np.zeros(effect.size)
    strength[0] = STRONG * effect.scale
    device = effect.put(BELIEVED, effect.vector(BELIEVED) + strength)
    check_untouched(recorded(slow_fmu, device))


@pytest.mark.parametrize("noise", NOISES, ids=lambda noise: noise.name)
def test_no_noise_is_taken_out(slow_fmu: GyroFmu, noise: NoiseEffect) -> None:
    loud: dict[str, Any] = {noise.field: STRONG * noise.scale}
    check_untouched(recorded(slow_fmu, replace(BELIEVED, **loud)))


def test_coarse_and_skewed_logs_are_untouched(honest: Campaign) -> None:
    def coarse(log: Log) -> Log:
        later = log.wave_angle + 5e-3 * np.gradient(log.wave_angle, log.interval)
        return replace(log, wave_angle=0.1 * DEG * np.round(later / (0.1 * DEG)))

    check_untouched(spoilt(honest, coarse))


@pytest.mark.parametrize("number", range(1, 7))
def test_recorded_campaigns_are_untouched(recorded_campaign: Path, number: int) -> None:
    check_untouched(campaign.read(recorded_campaign.parent / f"dev-0{number}"))


ANGLES_SWAPPED = [("wave", "gyro"), ("table", "gyro"), ("table", "wave")]


@pytest.mark.parametrize(("one", "other"), ANGLES_SWAPPED)
def test_swapped_angles_are_refused(honest: Campaign, one: str, other: str) -> None:
    names = rf"{one}_angle and {other}_angle|{other}_angle and {one}_angle"
    with pytest.raises(CampaignError, match=rf"and others: columns ({names}): .* swapped\?"):
        sound(spoilt(honest, swapped(f"{one}_angle", f"{other}_angle")))


ANOTHER_GYRO: list[tuple[Change, str]] = [
    (scaled(-1, "wave_angle"), r"coriolis_factor: .* says coriolis_factor -0\.277; expected 0\.2"),
    (scaled(1e3 * DEG, "wave_angle"), "says coriolis_factor 4.83"),
    (scaled(3600, "gyro_angle"), "says coriolis_factor 7.69"),
    (shifted(300 * HZ, "frequency_offset"), "says frequency_Hz 7300; expected 69"),
    (shifted(7000 * HZ, "frequency_offset"), "says frequency_Hz 1.4e"),
]


@pytest.mark.parametrize(("change", "message"), ANOTHER_GYRO)
def test_logs_of_another_gyro_are_refused(honest: Campaign, change: Change, message: str) -> None:
    with pytest.raises(CampaignError, match=f"{message}.*another gyro's"):
        sound(spoilt(honest, change))


@pytest.mark.parametrize(("key", "value"), [("coriolis_factor", 0.3), ("decay_time_s", 900.0)])
def test_nominal_values_of_another_gyro_are_refused(
    honest: Campaign, key: str, value: float
) -> None:
    with pytest.raises(CampaignError, match=rf"campaign\.json: nominal\.{key}: contradicted by"):
        sound(replace(honest, nominal={**honest.nominal, key: value}))


def test_nominal_values_are_checked(honest: Campaign) -> None:
    short = {key: value for key, value in honest.nominal.items() if key != "decay_time_s"}
    with pytest.raises(CampaignError, match=r"nominal\.decay_time_s: missing; expected a number"):
        sound(replace(honest, nominal=short))
    with pytest.raises(CampaignError, match=r"nominal: decay_time_s: found -1\.0, expected 1 to"):
        sound(replace(honest, nominal=short | {"decay_time_s": -1.0}))
    found, exclusions = sound(replace(honest, nominal={**honest.nominal, "colour": 3.0}))
    assert exclusions == ("campaign.json: nominal.colour: not known, ignored",)
    assert "colour" not in found.nominal


LEFT_OUT: list[tuple[Change, tuple[str, ...], str]] = [
    (
        swapped("amplitude_force", "quadrature_force"),
        ("amplitude_force", "quadrature_force"),
        r"the second holds 1/\d+(\.\d+)? s, the decay: are they swapped\?",
    ),
    (
        scaled(3600, "amplitude_force"),
        ("amplitude_force",),
        r"amplitude_force_per_s: says decay_time_s 0\.12\d*; expected 360 to 540",
    ),
    (scaled(2, "amplitude"), ("amplitude",), "2 of amplitude_setpoint; expected about 1"),
    (
        shifted(300 * HZ, "frequency_offset"),
        ("frequency_offset",),
        "frequency_offset_Hz: says frequency_Hz 7300; expected 6993 to 7007",
    ),
]


@pytest.mark.parametrize(("change", "fields", "message"), LEFT_OUT)
def test_an_output_that_can_not_be_is_left_out(
    honest: Campaign, change: Change, fields: tuple[str, ...], message: str
) -> None:
    found, exclusions = sound(spoilt(honest, change, "still"))
    assert len(exclusions) == 1
    assert re.match(rf"still: columns? .*{message}", exclusions[0])
    for test in found.tests:
        for field in fields:
            assert np.isnan(getattr(test.log, field)).all() == (test.id == "still")


NOT_USED: list[tuple[Change, str]] = [
    (scaled(-1, "wave_angle"), r"gyro_angle_deg, wave_angle_deg: .*but -0\.277; expected 0\.277"),
    (scaled(-1, "table_angle"), r"turns by 29\d.*table_angle's -29.*is a sign reversed\?"),
    (scaled(2, "table_angle"), "turns by 29.*; expected table_angle's 59.* beside it$"),
    (shifted(500.0, "time"), r"time_s 500\.5 to 570 in 140 rows; expected 0\.5 to 70"),
    (removed("gyro_angle", "wave_angle"), "no angle of the gyro is left"),
    (removed("axis_up", "acceleration_z"), "columns axis_up and accel_z_m_s2 missing; expected on"),
    (removed("table_angle"), r"turns by 29\d.*table_angle's 0 deg"),
]


@pytest.mark.parametrize(("change", "message"), NOT_USED)
def test_a_test_that_can_not_be_replayed_is_left_out(
    honest: Campaign, change: Change, message: str
) -> None:
    found, exclusions = sound(spoilt(honest, change, "pos"))
    assert [test.id for test in found.tests] == [t.id for t in honest.tests if t.id != "pos"]
    assert any(re.search(message, text) for text in exclusions)
    assert any(text.startswith("pos: not used: ") for text in exclusions)


def test_a_log_that_can_not_be_read_is_left_out(honest: Campaign, tmp_path: Path) -> None:
    campaign.write(honest, tmp_path)
    (tmp_path / "pos.csv.gz").write_bytes(b"time_s\n1\nx\n")
    (tmp_path / "neg.csv.gz").unlink()
    found, exclusions = sound(campaign.read(tmp_path))
    assert len(found.tests) == len(honest.tests) - 2
    assert "pos: not used: pos.csv.gz: row 3, time_s: 'x'; expected a number" in exclusions
    assert any(re.match(r"neg: not used: .*No such file", text) for text in exclusions)


def test_truth_is_not_read(honest: Campaign, tmp_path: Path) -> None:
    campaign.write(honest, tmp_path)
    (tmp_path / "truth.json").write_text("{ no json")
    assert sound(campaign.read(tmp_path))[1] == ()


def test_nothing_to_fit_is_refused(honest: Campaign) -> None:
    with pytest.raises(CampaignError, match=r"no test that may be fitted.*: all are held out"):
        sound(replace(honest, tests=tuple(t for t in honest.tests if t.is_holdout)))
    with pytest.raises(CampaignError, match=r"no test that may be fitted.*no angle of the gyro"):
        sound(spoilt(honest, removed("gyro_angle", "wave_angle")))


def test_what_is_held_out_was_not_given_before(honest: Campaign) -> None:
    twin = replace(honest.tests[0], id="twin", role="holdout")
    found, exclusions = sound(replace(honest, tests=(*honest.tests, twin)))
    assert exclusions == ("twin: not used: the same log as still",)
    assert len(found.tests) == len(honest.tests)
    assert sound(lacking(honest, "ride"))[1] == (
        "no test is held out: a diagnosis can't be verified",
    )
