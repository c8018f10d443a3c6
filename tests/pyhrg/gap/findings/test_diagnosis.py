"""`diagnosis.json` as the campaign format states it."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pyhrg.common.errors import HrgError
from pyhrg.device.device import Device
from pyhrg.gap.closing.closing import read_identified_device
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.findings.diagnosis import (
    FILE,
    Cause,
    Diagnosis,
    DiagnosisError,
    Gap,
    GapFigure,
    KnownValue,
    NextTest,
    Worth,
    write,
)
from pyhrg.gap.findings.diagnosis_reader import read_diagnosis
from pyhrg.gap.findings.localisation import Place
from pyhrg.gap.findings.quantity import Size

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
            worth=Worth(3.0, 2e-3, 1e-4),
        ),
        Cause(
            "angle_random_walk",
            0.9,
            {"angle_random_walk_deg_sqrt_h": 1e-3},
            {"angle_random_walk_deg_sqrt_h": (9e-4, 1.1e-3)},
        ),
    ),
    unknown_probability=0.01,
    where=(Place("still", "gyro_angle", "wave_angle", 0.9, 12.0, 4),),
    sizes=(),
    gap=Gap(FIGURE, None, FIGURE, FIGURE, 50.0, 0.3, FIGURE),
    next_test=None,
    unnamed={},
    excluded=(),
    within_tolerance=(
        KnownValue(
            "encoder_eccentricity",
            "bench",
            "encoder_eccentricity_arcsec",
            0.5,
            0.0,
            (0.4, 0.6),
            1.0,
            {"encoder_eccentricity_arcsec": 0.5, "encoder_eccentricity_phase_deg": 200.0},
        ),
    ),
)


def kept(folder: Path, given: Diagnosis = GIVEN) -> Path:
    write(given, folder)
    return folder / FILE


def test_keys_are_the_format_s(tmp_path: Path) -> None:
    found = json.loads(kept(tmp_path).read_text())
    assert found["schema"] == "hrg-diagnosis/1"
    assert found["verdict"] == "explained"
    cause = found["causes"][0]
    assert set(cause) >= {"effect", "probability", "parameters", "interval_95", "equivalents"}
    assert cause["interval_95"]["damping_axis_deg"] == [44.0, 46.0]
    assert cause["worth"]["position_m"] == pytest.approx(2e-3 * 185200)
    assert "worth" not in found["causes"][1]
    assert set(found["where"][0]) >= {"test", "channel", "coordinate", "harmonic", "share"}
    for stage in ("before", "after", "floor"):
        assert set(found["gap"][stage]) == {"fit", "holdout"}
        assert set(found["gap"][stage]["holdout"]) == {
            "angle_arcsec",
            "rate_deg_h",
            "area_arcsec",
        }
        assert set(found["gap"][stage]["fit"]) == {"angle_arcsec"}
    assert found["gap"]["shrink_percent"] == 50.0
    assert found["next_test"] is None
    assert found["unknown_probability"] == 0.01


def test_a_place_that_is_no_angle_has_no_harmonic() -> None:
    places = (replace(GIVEN.where[0], harmonic=None),)
    assert "harmonic" not in replace(GIVEN, where=places).document()["where"][0]


@pytest.mark.parametrize(
    "given",
    [
        GIVEN,
        replace(
            GIVEN,
            verdict="ambiguous",
            where=(replace(GIVEN.where[0], harmonic=None),),
            sizes=(Size("still", "amplitude", 10.0, 3.0, 0.0),),
            gap=Gap(FIGURE, None, None, None, None, None),
            next_test=NextTest("static", "2 h of rest separate them", 2.0),
            unnamed={"bias: a jump": 0.2},
            excluded=("a: not used",),
            settled=False,
        ),
    ],
)
def test_what_was_written_is_read_back(tmp_path: Path, given: Diagnosis) -> None:
    assert read_diagnosis(kept(tmp_path, given)) == given
    assert read_diagnosis(str(tmp_path)) == given


def test_causes_and_known_values_are_put_into_the_gyro(tmp_path: Path) -> None:
    lag = Cause("nominal_thermal_lag", 1.0, {"thermal_lag_s": 500.0}, {"thermal_lag_s": (1, 999)})
    found = read_diagnosis(kept(tmp_path, replace(GIVEN, causes=(*GIVEN.causes, lag))))
    device = read_identified_device(Device(), found)
    for entry in (GIVEN.causes[0], lag, GIVEN.within_tolerance[0]):
        effect = EFFECTS[entry.effect if isinstance(entry, Cause) else entry.name]
        assert effect.parameters(effect.vector(device)) == pytest.approx(entry.parameters)
    assert device.angle_random_walk == 0.0


def test_a_missing_parameter_is_named() -> None:
    cause = Cause("damping_anisotropy", 1.0, {"damping_anisotropy_per_s": 1e-6})
    with pytest.raises(DiagnosisError, match="damping_anisotropy: damping_axis_deg: missing"):
        read_identified_device(Device(), replace(GIVEN, causes=(cause,)))


CAUSE = GIVEN.document()["causes"][0]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"schema": "other"}, "schema: found 'other', expected hrg-diagnosis/1"),
        ({"record": "a.csv"}, "record: found 'a.csv', expected a campaign's diagnosis"),
        ({"verdict": "maybe"}, "verdict: found 'maybe', expected no_gap or"),
        ({"unknown_probability": 1.2}, "unknown_probability: found 1.2, expected 0 to 1"),
        ({"causes": [3]}, r"causes\[0\]: found 3"),
        ({"causes": [{**CAUSE, "probability": None}]}, r"causes\[0\]\.probability: found None"),
        (
            {"causes": [{**CAUSE, "interval_95": {"duffing_Hz": [2, 1]}}]},
            r"duffing_Hz: found \[2, 1\], expected \[low, high\]",
        ),
        ({"causes": [{**CAUSE, "equivalents": "x"}]}, "equivalents: found 'x'"),
        ({"next_test": {"why": "so"}}, "next_test.kind: found no such key"),
        ({"gap": {}}, "gap.before.fit.angle_arcsec: found no such key"),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, change: dict[str, Any], message: str) -> None:
    (tmp_path / FILE).write_text(json.dumps({**GIVEN.document(), **change}))
    with pytest.raises(HrgError, match=message):
        read_diagnosis(tmp_path / FILE)


@pytest.mark.parametrize(("text", "message"), [("{", "no JSON"), ("[]", "a JSON object")])
def test_other_files_are_refused(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "a.json").write_text(text)
    with pytest.raises(HrgError, match=message):
        read_diagnosis(tmp_path / "a.json")
