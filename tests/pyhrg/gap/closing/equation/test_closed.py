"""A sixth harmonic of the bias: proposed, written, built, verified; FMPy runs what was built."""

import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import fmpy
import numpy as np
import pytest

from fmu_build import build_fmu, check_fmu
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.fmu import GyroFmu
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.closing.equation.closed_class import write_class
from pyhrg.gap.closing.equation.closed_fmu import load_closed_fmu, put_terms
from pyhrg.gap.closing.equation.places import find_acting
from pyhrg.gap.closing.equation.proposal import Coefficient, list_coefficients
from pyhrg.gap.closing.equation.refinement import estimate_missed
from pyhrg.gap.closing.prediction import predict
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.effects.jump import Jump, make_bias_jump
from pyhrg.gap.effects.term_columns import build_term_columns, compute_response
from pyhrg.gap.findings.diagnosis_reader import read_diagnosis
from pyhrg.gap.findings.term import Formula, Term
from pyhrg.gap.replay.observations import CHANNELS, observe_test
from pyhrg.gap.replay.sampled import replay_sampled
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.bench import tiny
from tests.pyhrg.gap.closing.equation.planted import COS6, SIN6, record_sixth_harmonic
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.test_diagnose import FEW
from tests.pyhrg.records.made_up import made_up_log

JUMP_TIME = 30.0
GAIN = NOMINAL.bryan_factor
FAULTY = replace(NOMINAL.without_noise(), pickoff_nonorthogonality=1e-4, time_division=1)
WARM = "harmonic 4 of the pattern angle, times the temperature"
NEGLIGIBLE = 1e-11
"""Difference of an angle, rad, or a force, 1/s, far below the noise of any reading."""
Everything = tuple[dict[CandidateTerm, Term], GyroFmu]
"""All terms, and the FMU that has them."""
AGREEMENT = 0.05 * ARCSEC
"""Largest difference of two runs of one gyro."""


@pytest.fixture(scope="module")
def diagnosed(simulation: Simulation) -> CampaignDiagnosis:
    campaign = record_sixth_harmonic(simulation.sampled)
    return diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation)


@pytest.fixture(scope="module")
def written(diagnosed: CampaignDiagnosis, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("diagnosis")
    diagnosed.write(folder)
    return folder


def test_the_sixth_harmonic_is_proposed_alone(diagnosed: CampaignDiagnosis) -> None:
    (term,) = diagnosed.diagnosis.terms
    assert (term.place, term.coordinates) == ("bias", ("wave_angle",))
    assert term.function == "bias: harmonic 6 of the pattern angle"
    assert term.probability > 0.95
    for name, truth in (("bias_cos6_deg_h", COS6), ("bias_sin6_deg_h", SIN6)):
        low, high = term.interval_95[name]
        assert low <= truth <= high
        assert high - low < 0.02


def test_what_its_linear_response_misses_is_foreseen(
    diagnosed: CampaignDiagnosis, everything: Everything
) -> None:
    """A harmonic 2000 times as large turns the pattern by 10 mrad: the FMU with it, less the linear
    response, beside what is foreseen."""
    (term,) = diagnosed.diagnosis.terms
    large = replace(term, parameters={n: 2000 * v for n, v in term.parameters.items()})
    (candidate,) = (
        c for c, t in everything[0].items() if t.parameters.keys() == term.parameters.keys()
    )
    own = list_coefficients(candidate)
    size = np.array([large.parameters[c.name] * c.factor for c in own])
    part = max(diagnosed.attribution.parts, key=lambda p: len(p.test.log.time))
    ends = put_terms(part.device, [large], part.test.test.id), part.device
    on, off = (replay_sampled(everything[1], d, part.test.inputs)["gyro_angle"] for d in ends)
    linear = compute_response(part.where, "gyro_angle", {candidate: size})
    missed = on - off - linear
    foreseen = estimate_missed(part, {candidate: size})["gyro_angle"]
    assert GAIN * np.abs(linear).max() > 0.01
    assert np.linalg.norm(foreseen - missed) < 0.2 * np.linalg.norm(missed)


def test_the_held_out_gap_shrinks(diagnosed: CampaignDiagnosis) -> None:
    (term,) = diagnosed.diagnosis.terms
    assert (term.shrink_percent or 0.0) > 90
    assert (diagnosed.diagnosis.gap.shrink_percent or 0.0) > 90


def test_the_file_says_the_same(diagnosed: CampaignDiagnosis, written: Path) -> None:
    assert read_diagnosis(written) == diagnosed.diagnosis
    (entry,) = json.loads((written / "diagnosis.json").read_text())["terms"]
    assert entry["formula"]["modelica"] == "biasCos6*cos(6*pattern) + biasSin6*sin(6*pattern)"


def test_closed_mo_builds_to_closed_fmu_without_findings(written: Path) -> None:
    built = build_fmu(class_file=written / "closed.mo")
    assert built.read_bytes() == (written / "closed.fmu").read_bytes()
    assert check_fmu(built).finding_count == 0


def test_fmpy_alone_gives_what_the_prediction_gives(
    diagnosed: CampaignDiagnosis, written: Path, simulation: Simulation
) -> None:
    """The held-out log, its inputs at 10 ms, the defaults of `closed.fmu` but for noise."""
    test = diagnosed.tests[-1]
    inputs, steps = test.inputs, 50
    rates = inputs.table.compute_rates(steps)
    latitude = NOMINAL.site.compute_earth_rate(1.0, 0.0, np.zeros(1))
    table = np.zeros(rates.size, dtype=[("time", float), ("angularRate", float)])
    table["time"] = np.arange(rates.size) * inputs.log.interval / steps
    table["angularRate"] = rates.ravel() + float(np.ravel(latitude)[0])
    silent = {"gyro.noise.angleRandomWalk": 0.0, "gyro.noise.pickOff": 0.0}
    run = fmpy.simulate_fmu(
        str(written / "closed.fmu"),
        stop_time=len(inputs.log.time) * inputs.log.interval,
        step_size=inputs.log.interval / steps,
        output_interval=inputs.log.interval / steps,
        start_values={"startAngle": inputs.start_angle, **silent},
        input=_hold(table),
        output=["gyroAngle"],
    )
    rows = np.arange(1, len(inputs.log.time) + 1) * steps
    predicted = diagnosed_angle(diagnosed, written, simulation)
    np.testing.assert_allclose(run["gyroAngle"][rows], predicted, rtol=0, atol=AGREEMENT)


def _hold(table: np.ndarray) -> np.ndarray:
    """Values that hold from their time on: FMPy interpolates between rows."""
    held = np.repeat(table, 2)
    held["time"][1:-1:2] = table["time"][1:] - 1e-7
    held["time"][-1] = table["time"][-1] + 1.0
    return held


def diagnosed_angle(
    diagnosed: CampaignDiagnosis, written: Path, simulation: Simulation
) -> np.ndarray:
    log = diagnosed.tests[-1].log
    campaign = record_sixth_harmonic(simulation.sampled)
    table = predict(written / "diagnosis.json", log, campaign, simulation=simulation)
    return np.asarray(table["gyro_angle_deg"] * DEG)


def test_no_gap_no_term_but_an_fmu(simulation: Simulation, tmp_path: Path) -> None:
    found = diagnose(tiny(simulation), catalogue=Catalogue(FEW), simulation=simulation)
    assert found.diagnosis.terms == ()
    found.write(tmp_path)
    assert "closed.fmu" in {file.name for file in tmp_path.iterdir()}
    assert fmpy.read_model_description(str(tmp_path / "closed.fmu")).modelName == "closed"


@pytest.fixture(scope="module")
def everything(diagnosed: CampaignDiagnosis) -> Everything:
    """All candidate terms without sizes, and a class with all of them, beside errors of the
    pick-offs and a mode that is a whole number."""
    part, terms = diagnosed.attribution.parts[-1], dict[CandidateTerm, Term]()
    for channel in CHANNELS:
        for candidate, columns in build_term_columns(part.where, channel):
            own = list_coefficients(candidate)
            assert len(own) == (0 if candidate.is_of_each_power_on else columns.shape[1])
            if own:
                terms[candidate] = _make_term(candidate, own)
    jump = make_bias_jump([("ride", JUMP_TIME)], 0.0)
    terms[jump] = _make_term(jump, list_coefficients(jump))
    return terms, load_closed_fmu(FAULTY, list(terms.values()))


def test_every_candidate_term_can_be_written_at_once(
    diagnosed: CampaignDiagnosis, everything: Everything
) -> None:
    """All terms at once build; without sizes they change nothing. A jump acts in its own test, from
    its time on."""
    terms, fmu = everything
    part = diagnosed.attribution.parts[-1]
    names = [name for term in terms.values() for name in term.parameters]
    assert len(names) == len(set(names))
    plain = replay_sampled(load_closed_fmu(FAULTY, ()), FAULTY, part.test.inputs)
    same = replay_sampled(fmu, FAULTY, part.test.inputs)
    for channel in CHANNELS:
        np.testing.assert_allclose(same[channel], plain[channel], rtol=0, atol=1e-15)
    (jump,) = (term for candidate, term in terms.items() if isinstance(candidate, Jump))
    jumped = replace(jump, parameters={"bias_jump1_deg_h": 1.0})
    turned = [
        replay_sampled(fmu, put_terms(FAULTY, [jumped], test), part.test.inputs)
        for test in ("ride", "still")
    ]
    expected = DEG_PER_H * np.maximum(part.test.log.time - JUMP_TIME, 0.0)
    added = turned[0]["gyro_angle"] - turned[1]["gyro_angle"]
    np.testing.assert_allclose(added, expected, rtol=0.02, atol=DEG_PER_H)
    np.testing.assert_array_equal(turned[1]["gyro_angle"], same["gyro_angle"])
    written = write_class(FAULTY, [jumped], "All", ())
    assert "biasJump1 = 0.0" in written
    assert "bias_jump1_deg_h = 1 there, 0 else" in written


@pytest.mark.parametrize(
    ("channel", "function", "size", "changed", "share"),
    [
        ("gyro_angle", f"pick-off: {WARM}", (0.0, 1e-5 / (4 * GAIN)),
         {"pickoff_gain_per_kelvin": 1e-5}, 0.01),
        ("amplitude_force", WARM, (5e-8 * np.cos(1.2), 5e-8 * np.sin(1.2)),
         {"damping_anisotropy_per_kelvin": 1e-2}, 0.01),
        ("gyro_angle", "phase: temperature of the case", (1e-6,),
         {"phase_per_kelvin": 1e-6}, 0.02),
        ("gyro_angle", "drive: settling in 150 s", (5e-8 * NOMINAL.decay_time,),
         {"bias_per_acceleration": 1e-8}, 0.01),
    ],
)  # fmt: skip
def test_a_written_term_is_what_the_gyro_does(
    simulation: Simulation,
    channel: str,
    function: str,
    size: tuple[float, ...],
    changed: dict[str, float],
    share: float,
) -> None:
    """A gain mismatch of the pick-offs, an anisotropy of damping and a phase that follow the
    temperature, and a drive frame that follows a specific force which settles: as a term beside the
    gyro, and as a parameter of it. The resonator lags by 1 s of the case, whose swing has a time
    constant of 64 s: 1.6 %. What a change of the phase adds to the frequency is left out
    (docs/methods/effects.md, after Eq. 5f)."""
    rows = np.arange(200) / 200
    still = made_up_log(200, noise=0.0)
    log = replace(
        still,
        acceleration_z=5 * np.exp(-still.time / 150),
        temperature=298.15 + 10 * np.sin(np.pi * rows) ** 2,
        table_angle=6 * rows,
        virtual_rotation=np.full(200, 1 * DEG),
    )
    faulty = replace(FAULTY, damping_anisotropy=1e-5, damping_axis=0.3)
    device = replace(faulty, frequency_split=0.01, stiffness_axis=0.7, thermal_lag=1.0)
    test = observe_test(Test("warm", "static", "fit", log), device)
    inputs = test.inputs
    where = compute_coordinates(test, simulation.simulate(device, test), device)
    (candidate,) = (t for t, _ in build_term_columns(where, channel) if t.function == function)
    own = list_coefficients(candidate)
    term = _make_term(candidate, own)
    fmu = load_closed_fmu(FAULTY, [term])
    values = {c.name: value / c.factor for c, value in zip(own, size, strict=True)}
    with_term = put_terms(device, [replace(term, parameters=values)], "warm")
    before, by_term = (replay_sampled(fmu, d, inputs) for d in (device, with_term))
    by_gyro = replay_sampled(fmu, replace(device, **changed), inputs)
    names = ["gyro_angle", "amplitude_force", "quadrature_force"]
    if not function.startswith("phase"):
        names.append("frequency_offset")
    for name in names:
        expected = by_gyro[name] - before[name]
        apart = by_term[name] - before[name] - expected
        assert np.abs(apart).max() < share * np.abs(expected).max() + NEGLIGIBLE, name


def _make_term(candidate: CandidateTerm, own: Sequence[Coefficient]) -> Term:
    return Term(
        find_acting(candidate).place,
        (candidate.coordinate,),
        Formula("", " + ".join(f"{c.variable}*{c.basis.modelica}" for c in own)),
        {c.name: 0.0 for c in own},
        {c.name: (0.0, 0.0) for c in own},
        1.0,
        1.0,
        candidate.channel,
        candidate.function,
    )
