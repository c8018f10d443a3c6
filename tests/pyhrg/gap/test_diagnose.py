"""Diagnoses of short campaigns that the gyro with sampled loops made: what is there is found, and
where nothing is, nothing.

Larger numbers of seeds: `benchmarks/gap_controls.py`.
"""

import json
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG, HZ
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.closing.prediction import predict
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import EFFECTS, Catalogue
from pyhrg.gap.evidence.rounds.iteration import attribute_gap
from pyhrg.gap.replay.observations import ObservedTest, observe_test
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign import Campaign, CampaignError
from tests.pyhrg.gap.bench import recorded, tiny
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.soundness.spoil import Change, at, change_logs, removed, take_kinds

FEW = tuple(
    EFFECTS[name]
    for name in (
        *("damping_anisotropy", "drive_gain_mismatch", "pickoff_gain_mismatch"),
        *("demodulation_phase_error", "phase_temperature", "coriolis_factor_error"),
    )
)
"""Enough of the catalogue for a test's time."""


def diagnosed_few(simulation: Simulation, campaign: Campaign) -> CampaignDiagnosis:
    return diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation)


@pytest.fixture(scope="module")
def mismatched(simulation: Simulation, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a campaign of a gyro with a drive gain mismatch."""
    folder = tmp_path_factory.mktemp("campaign")
    given = recorded(simulation.sampled, replace(NOMINAL, drive_gain_mismatch=1e-3))
    campaigns.write_campaign(given, folder)
    return folder


@pytest.fixture(scope="module")
def found(simulation: Simulation, mismatched: Path) -> CampaignDiagnosis:
    """Its diagnosis, which reports its progress."""
    lines: list[str] = []
    found = diagnose(
        str(mismatched), catalogue=Catalogue(FEW), simulation=simulation, progress=lines.append
    )
    assert lines[0] == "round 1: simulating"
    return found


def test_the_front_door_speaks_in_tables(
    simulation: Simulation, mismatched: Path, found: CampaignDiagnosis, tmp_path: Path
) -> None:
    """From a folder to causes, residuals, a figure, files, and a prediction by these."""
    (cause,) = found.causes.itertuples()
    assert (cause.effect, cause.parameter) == ("drive_gain_mismatch", "drive_gain_mismatch")
    assert cause.low_95 < cause.value < cause.high_95
    table = found.residuals("ride")
    assert table.attrs["units"]["gyro_angle_before_arcsec"] == "arcsec"
    assert set(table.attrs["units"]) == set(table.columns)
    held_out = found.diagnosis.gap.holdout_angle_arcsec
    assert held_out is not None
    for stage in ("before", "after"):
        rms = np.sqrt((table[f"gyro_angle_{stage}_arcsec"] ** 2).mean())
        assert rms == pytest.approx(getattr(held_out, stage))
    axes = found.plot("ride", Figure().subplots())
    assert [line.get_label() for line in axes.lines] == ["before", "after"]
    with pytest.raises(HrgError, match="test_id: found 'nowhere', expected one of still, "):
        found.residuals("nowhere")
    found.write(tmp_path / "out")
    given = campaigns.read_campaign(mismatched)
    log = next(test.log for test in given.tests if test.id == "ride")
    predictions = [
        predict(source, log, mismatched, simulation=simulation)
        for source in (found, found.diagnosis, tmp_path / "out" / "diagnosis.json")
    ]
    angle = predictions[0]["gyro_angle_deg"] * DEG
    assert np.sqrt(np.mean((log.gyro_angle - angle) ** 2)) < 2 * held_out.after * ARCSEC
    for other in predictions[1:]:
        np.testing.assert_allclose(other["gyro_angle_deg"] * DEG, angle, atol=1e-12)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_no_gap(simulation: Simulation, seed: int) -> None:
    """None of three: by a benchmark of many, a false alarm is rarer than one in fifty."""
    found = diagnosed_few(simulation, tiny(simulation, seed=seed)).diagnosis
    assert found.verdict == "no_gap"
    assert found.causes == ()


def test_an_effect_is_found_and_closed(found: CampaignDiagnosis) -> None:
    assert found.verdict == "explained"
    (cause,) = found.diagnosis.causes
    assert cause.effect == "drive_gain_mismatch"
    low, high = cause.interval_95["drive_gain_mismatch"]
    assert abs(1e-3 - (low + high) / 2) < 1.3 * (high - low) / 2
    held = found.diagnosis.gap.holdout_angle_arcsec
    assert held is not None
    assert held.before > 3 * held.floor_95[1]
    assert held.after < held.floor_95[1]


@pytest.mark.parametrize(
    ("name", "value", "alike"),
    [
        ("electrostatic_cubic", 2e-3, "duffing_stiffness"),
        ("sampling_skew", 5e-5, "pickoff_nonorthogonality"),
        ("filter_delay", 1e-3, "loop_delay"),
    ],
)
def test_effects_are_told_from_what_resembles_them(
    simulation: Simulation, name: str, value: float, alike: str
) -> None:
    true = EFFECTS[name].put(NOMINAL, np.array([value]))
    catalogue = Catalogue((EFFECTS[name], EFFECTS[alike], *FEW))
    campaign = recorded(simulation.sampled, true)
    found = diagnose(campaign, catalogue=catalogue, simulation=simulation).diagnosis
    assert [cause.effect for cause in found.causes] == [name]
    ((key, (low, high)),) = found.causes[0].interval_95.items()
    (declared,) = (k for k in EFFECTS[name].keys if k.name == key)
    assert declared.to_si(low) < value < declared.to_si(high)


@dataclass(frozen=True)
class Shy(Simulation):
    """Refuses the first gyro that is not the believed one."""

    refused: list[Device] = field(default_factory=list)

    def simulate(self, device: Device, test: ObservedTest) -> dict[str, Array]:
        if device.drive_gain_mismatch and device in (self.refused or [device]):
            self.refused.append(device)
            raise GyroError("refused")
        return super().simulate(device, test)


def test_a_move_to_a_gyro_that_is_refused_goes_half_the_way(simulation: Simulation) -> None:
    shy = Shy(simulation.sampled, simulation.quasi_steady)
    true = replace(NOMINAL, drive_gain_mismatch=-0.03)
    tests = [observe_test(t, NOMINAL) for t in tiny(simulation, true).tests]
    found = attribute_gap(shy, NOMINAL, tests, Catalogue((EFFECTS["drive_gain_mismatch"],)))
    assert shy.refused
    assert found.settled
    assert found.device.drive_gain_mismatch == pytest.approx(-0.03, rel=0.01)


def test_what_a_linear_search_leaves_of_a_large_effect_has_no_name(simulation: Simulation) -> None:
    """The pattern turns by degrees while the gyro warms: 2 % of it are not linear."""
    true = replace(NOMINAL, phase_per_kelvin=-2.5e-4)
    bench = Bench(simulation.sampled, true)
    warm = NOMINAL.reference_temperature + np.append(np.linspace(0, 30, 1201), np.full(400, 30))
    power_ons = [
        PowerOn("still", "static", bench.programme().rest(600)),
        PowerOn("ramp", "thermal_ramp", bench.programme().rest(1600).set_temperatures(warm)),
    ]
    given = recorded(simulation.sampled, true, power_ons=power_ons)
    found = diagnosed_few(simulation, given).diagnosis
    assert [cause.effect for cause in found.causes] == ["phase_temperature"]


MANY = {
    "frequency_split": 0.8e-3 * HZ,
    "damping_anisotropy": 1e-6,
    "pickoff_gain_mismatch": 4e-4,
    "pickoff_nonorthogonality": 3e-4,
    "drive_gain_mismatch": -3e-4,
    "drive_nonorthogonality": 4e-4,
    "phase_error": 1e-3,
}
"""A gyro as it comes, by field of a device."""
MANY_NAMES = [name.replace("phase_error", "demodulation_phase_error") for name in MANY]


def test_of_many_effects_at_once_the_small_ones_are_found_beside_the_large(
    simulation: Simulation,
) -> None:
    ideal = replace(NOMINAL, frequency_split=0.0, damping_anisotropy=0.0)
    given = recorded(simulation.sampled, replace(ideal, **MANY), ideal)
    few = [EFFECTS[name] for name in (*MANY_NAMES, "drive_frame_rotation", "loop_delay")]
    found = diagnose(given, catalogue=Catalogue(tuple(few)), simulation=simulation)
    assert found.diagnosis.settled
    assert found.diagnosis.verdict == "explained"
    assert {cause.effect for cause in found.diagnosis.causes} == set(MANY_NAMES)
    gap = found.diagnosis.gap.holdout_angle_arcsec
    assert gap is not None
    assert gap.after < gap.floor_95[1] < gap.before / 100


def test_a_search_that_is_ended_is_left_where_the_gyro_was_simulated(
    simulation: Simulation, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pyhrg.gap.evidence.rounds.iteration.MAX_ROUNDS", 1)
    true = replace(NOMINAL, drive_gain_mismatch=1e-3)
    tests = [observe_test(test, NOMINAL) for test in tiny(simulation, true).tests]
    found = attribute_gap(simulation, NOMINAL, tests, Catalogue(FEW))
    assert not found.settled
    assert all(part.device is found.device for part in found.parts)


def test_backwards_in_time_no_effect_explains(
    simulation: Simulation, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The residual of an effect, reversed: something is there that no name explains. A search for
    it need not settle: a few rounds are enough to say so."""
    monkeypatch.setattr("pyhrg.gap.evidence.rounds.iteration.MAX_ROUNDS", 2)
    true = replace(NOMINAL, drive_gain_mismatch=1e-3)
    given, honest = (tiny(simulation, device) for device in (true, NOMINAL.without_noise()))
    tests = []
    for test, clean in zip(given.tests, honest.tests, strict=True):
        residual = test.log.gyro_angle - clean.log.gyro_angle
        turned = residual[-1] - np.concatenate([[0.0], residual[:0:-1]])
        angle = clean.log.gyro_angle + turned
        wave = clean.log.wave_angle - NOMINAL.bryan_factor * turned
        log = replace(clean.log, gyro_angle=angle, wave_angle=wave)
        tests.append(replace(test, recording=log))
    found = diagnosed_few(simulation, replace(given, tests=tuple(tests))).diagnosis
    assert found.verdict == "unexplained"


SPOILT: list[Change] = [
    at(slice(50, 60), np.nan, "gyro_angle"),
    at(slice(0, 1), np.nan, "gyro_angle"),
    at(slice(50, 60), np.nan, "amplitude"),
    removed("amplitude"),
    removed("amplitude_force", "frequency_offset"),
    removed("temperature"),
    at(slice(None), 298.15, "temperature"),  # without noise
]


@pytest.mark.parametrize("change", SPOILT)
def test_what_is_missing_makes_no_gap(simulation: Simulation, change: Change) -> None:
    found = diagnosed_few(simulation, change_logs(tiny(simulation), change)).diagnosis
    assert found.verdict == "no_gap"
    found.document()


@pytest.mark.parametrize(
    "missing",
    [
        at(slice(60, 61), np.nan, "amplitude"),
        removed("amplitude"),
        at(slice(60, 70), np.nan, "frequency_offset"),
    ],
)
def test_what_is_missing_while_a_pattern_rings_down_hides_no_effect(
    simulation: Simulation, missing: Change
) -> None:
    true = replace(NOMINAL, drive_gain_mismatch=1e-3)
    lost = at(slice(60, 62), np.nan, "gyro_angle")
    few = take_kinds(recorded(simulation.sampled, true), "static", "rate", "ring_down")
    given = change_logs(few, lambda log: lost(missing(log)), "ring")
    found = diagnosed_few(simulation, given).diagnosis
    assert [cause.effect for cause in found.causes] == ["drive_gain_mismatch"]
    json.dumps(found.document(), allow_nan=False)


def test_tests_without_one_of_the_angles_are_left_out(simulation: Simulation) -> None:
    given = tiny(simulation)
    found = diagnosed_few(simulation, change_logs(given, removed("wave_angle"), "pos")).diagnosis
    assert [s for s in found.excluded if s.startswith("pos: not used: no row with both")]
    with pytest.raises(CampaignError, match="no test can be fitted to; still: not used"):
        diagnosed_few(simulation, change_logs(given, removed("wave_angle")))


def test_one_short_test_is_enough_to_say_something(simulation: Simulation) -> None:
    given = tiny(simulation)
    found = diagnosed_few(simulation, replace(given, tests=given.tests[1:2])).diagnosis
    assert found.gap.fit_rate_deg_h is None
    assert found.gap.holdout_angle_arcsec is None
    assert "no test is held out: a diagnosis can't be verified" in found.excluded
