"""`diagnosis.json` as the campaign format states it."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from pyhrg.device.device import Device
from pyhrg.gap.closing.closing import with_causes
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.findings import diagnosis
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis, DiagnosisError, Gap, GapFigure, Where

FIGURE = GapFigure(3.0, 2.0, 1.0, (0.5, 1.5))
GIVEN = Diagnosis(
    device="made up",
    verdict="explained",
    causes=(
        Cause(
            "damping_anisotropy",
            0.99,
            {"damping_anisotropy_per_s": 2e-6, "damping_axis_deg": 45.0},
            {"damping_anisotropy_per_s": (1e-6, 3e-6), "damping_axis_deg": (44.0, 46.0)},
            ("drive_gain_mismatch",),
        ),
        Cause(
            "angle_random_walk",
            0.9,
            {"angle_random_walk_deg_sqrt_h": 1e-3},
            {"angle_random_walk_deg_sqrt_h": (9e-4, 1.1e-3)},
        ),
    ),
    unknown_probability=0.01,
    where=(Where("still", "gyro_angle", "wave_angle", 0.9, 12.0, 4),),
    sizes=(),
    gap=Gap(FIGURE, None, FIGURE, FIGURE, 50.0, 0.3),
    next_test=None,
    unnamed={},
    excluded=(),
)


def kept(folder: Path, given: Diagnosis = GIVEN) -> Path:
    (folder / diagnosis.FILE).write_text(json.dumps(given.document(), allow_nan=False))
    return folder / diagnosis.FILE


def test_keys_are_the_format_s(tmp_path: Path) -> None:
    found = json.loads(kept(tmp_path).read_text())
    assert found["schema"] == "hrg-diagnosis/1"
    assert found["verdict"] == "explained"
    cause = found["causes"][0]
    assert set(cause) >= {"effect", "probability", "parameters", "interval_95", "equivalents"}
    assert cause["interval_95"]["damping_axis_deg"] == [44.0, 46.0]
    assert set(found["where"][0]) >= {"test", "channel", "coordinate", "harmonic", "share"}
    for stage in ("before", "after", "floor"):
        assert set(found["gap"][stage]) == {"fit", "holdout"}
        assert set(found["gap"][stage]["holdout"]) == {"angle_arcsec", "rate_deg_h"}
        assert set(found["gap"][stage]["fit"]) == {"angle_arcsec"}
    assert found["gap"]["shrink_percent"] == 50.0
    assert found["next_test"] is None
    assert found["unknown_probability"] == 0.01


def test_a_place_that_is_no_angle_has_no_harmonic() -> None:
    places = (replace(GIVEN.where[0], harmonic=None),)
    assert "harmonic" not in replace(GIVEN, where=places).document()["where"][0]


def test_causes_are_put_into_the_gyro(tmp_path: Path) -> None:
    causes = diagnosis.causes_of(kept(tmp_path), GIVEN.device)
    device = with_causes(Device(), causes)
    effect = EFFECTS["damping_anisotropy"]
    assert effect.parameters(effect.vector(device)) == pytest.approx(
        {"damping_anisotropy_per_s": 2e-6, "damping_axis_deg": 45.0}
    )
    assert device.angle_random_walk == 0.0


def test_a_missing_parameter_is_named() -> None:
    with pytest.raises(DiagnosisError, match="damping_anisotropy: damping_axis_deg: missing"):
        with_causes(Device(), {"damping_anisotropy": {"damping_anisotropy_per_s": 1e-6}})


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "can't be read"),
        ("[]", r"schema: found \[\], expected 'hrg-diagnosis/1'"),
        ('{"schema": "other"}', "found 'other'"),
        ('{"schema": "hrg-diagnosis/1"}', "KeyError"),
        ('{"schema": "hrg-diagnosis/1", "causes": [3]}', "expected effect and parameters"),
    ],
)
def test_other_files_are_refused(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "a.json").write_text(text)
    with pytest.raises(DiagnosisError, match=message):
        diagnosis.causes_of(tmp_path / "a.json", "unit")
