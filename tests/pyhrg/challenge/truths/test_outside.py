import ast
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pyhrg
from pyhrg.bench.programme import Course, Programme, make_course
from pyhrg.challenge.campaigns.gyro import Disturbance, TrueGyro
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.challenge.campaigns.plans import TESTS, Variation
from pyhrg.challenge.truths.form import FORMS_MODULE, PLACES, Form, load_forms
from pyhrg.challenge.truths.meter import Meter, make_measured_course
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from tests.pyhrg.challenge.short import GRAVITY, GYRO

ROOTS = [Path(pyhrg.__file__).parents[1] / name for name in ("pyhrg", "ins_eval", "fmu_build")]
COORDINATES = (
    *("wave_angle", "temperature", "temperature_rate", "rate", "acceleration"),
    *("table_angle", "amplitude", "time", "noise"),
)
BENCH_AND_RECORD = (
    *("thermometer_offset", "thermometer_lag", "thermometer_gain", "encoder_eccentricity"),
    *("encoder_noise", "table_ripple", "table_axis_tilt", "site_latitude", "mounting_sign"),
    *("drive_interruption", "clock_rate", "clock_latency", "time_jitter", "lost_rows", "outliers"),
    "amplitude_latency",
)
"""Names of the record format beside those of the effects."""
COMPARED = (
    *("gyro_angle", "wave_angle", "table_angle", "temperature", "amplitude"),
    *("amplitude_force", "quadrature_force", "frequency_offset"),
)
START = 0.3
"""Pattern angle at power-on, rad."""


@pytest.fixture(scope="module")
def meter(simulation: Simulation) -> Meter:
    """Of a whole campaign's tests."""
    vary = Variation(GYRO, np.random.default_rng(1))
    tests: list[tuple[Course, float]] = []
    for i, (_, _, role, profile) in enumerate(TESTS):
        programme = profile(vary)
        if role == "fit":
            tests.append((make_measured_course(programme), 0.1 + 0.1 * i))
    return Meter(simulation, GYRO, tests, Instruments())


def test_no_module_imports_them() -> None:
    name = FORMS_MODULE.rpartition(".")[2]
    for root in ROOTS:
        for path in root.rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text())):
                if isinstance(node, ast.Import | ast.ImportFrom):
                    names = [alias.name for alias in node.names]
                    module = getattr(node, "module", "") or ""
                    assert FORMS_MODULE not in (module, *names), path
                    assert not (module == FORMS_MODULE.rpartition(".")[0] and name in names), path


def test_there_are_forms_in_every_coordinate_and_place() -> None:
    forms = load_forms()
    assert len(forms) >= 28
    assert {form.coordinate for form in forms} == set(COORDINATES)
    assert {form.place for form in forms} == set(PLACES)
    assert len({form.name for form in forms}) == len({form.reason for form in forms}) == len(forms)


def test_no_form_has_a_name_of_the_catalogue() -> None:
    assert not {form.name for form in load_forms()} & {*EFFECTS, *BENCH_AND_RECORD}


@pytest.mark.parametrize("form", load_forms(), ids=lambda form: form.name)
def test_a_form_shows_beyond_the_catalogue(meter: Meter, form: Form) -> None:
    """Six sigmas and more within ten sizes that are nothing special."""
    gap = meter.residual(GYRO, form.disturbance(GYRO, 10.0, np.random.default_rng(3)))
    assert meter.sigmas_beyond_catalogue(gap) > 6


def vary_all() -> Programme:
    """A course in which every form acts: it rests, turns, tilts, warms and changes its commands."""
    course = Programme(1.0, GRAVITY).rest(1200.0).spin(50 * DEG, 20.0).attitude(0.0, 0.7)
    course.command(virtual_rotation=1 * DEG, amplitude_setpoint=1.2).rest(40.0)
    course.command(drive_on=0.0).spin(-50 * DEG, 60.0)
    return course.set_temperatures(GYRO.reference_temperature + np.linspace(0, 30, 1321))


def ring_down() -> Programme:
    return Programme(1.0, GRAVITY).rest(20.0).command(drive_on=0.0).rest(300.0)


def record(
    fmu: GyroFmu, programme: Programme, disturbance: Disturbance, device: Device = GYRO
) -> Log:
    gyro = TrueGyro(fmu, device, Instruments(), disturbance)
    return disturbance.shown(gyro.exact("", make_course(programme, 1.0), START, np.zeros((1, 1))))


@pytest.mark.parametrize("form", load_forms(), ids=lambda form: form.name)
def test_a_form_acts_alike_by_the_same_generator_and_not_without_a_size(
    slow_fmu: GyroFmu, form: Form
) -> None:
    once, again, none = (
        record(slow_fmu, vary_all(), form.disturbance(GYRO, size, np.random.default_rng(5)))
        for size in (1e3, 1e3, 0.0)
    )
    nominal = record(slow_fmu, vary_all(), Disturbance())
    changed = []
    for name in COMPARED:
        expected = getattr(nominal, name)
        np.testing.assert_array_equal(getattr(once, name), getattr(again, name), name)
        np.testing.assert_array_equal(getattr(none, name), expected, name)
        changed.append(not np.array_equal(getattr(once, name), expected))
    assert any(changed)


def find_form(name: str) -> Form:
    return next(form for form in load_forms() if form.name == name)


def test_a_bias_by_the_amplitude_follows_the_vibration_in_a_ring_down(fmu: GyroFmu) -> None:
    """A commanded amplitude is 1 throughout: it would give none."""
    size = 100.0
    even = replace(GYRO, frequency_split=0.0, damping_anisotropy=0.0)
    disturbance = find_form("amplitude_squared").disturbance(even, size, np.random.default_rng(2))
    without, log = (record(fmu, ring_down(), d, even) for d in (Disturbance(), disturbance))
    turned = log.gyro_angle - without.gyro_angle
    expected = size * 0.1 * DEG_PER_H * np.sum(without.amplitude**2 - 1)
    assert abs(turned[-1]) == pytest.approx(abs(expected), rel=0.01)


def test_a_damping_by_the_amplitude_follows_the_energy_of_a_free_ellipse(fmu: GyroFmu) -> None:
    """The split makes an ellipse of the free vibration, whose long axis alone would give 6 %
    too much."""
    size, tau = 1000.0, GYRO.decay_time
    split = replace(GYRO, stiffness_axis=START - math.pi / 8)
    disturbance = find_form("damping_amplitude").disturbance(split, size, np.random.default_rng(2))
    without, log = (record(fmu, ring_down(), d, split) for d in (Disturbance(), disturbance))
    lost = -np.log(log.amplitude / without.amplitude)
    free = 300.0
    expected = size * 3e-8 * (tau / 2 * (1 - np.exp(-2 * free / tau)) - free)
    assert abs(lost[-1]) == pytest.approx(abs(expected), rel=0.01)
    np.testing.assert_array_equal(log.amplitude_force[20:], without.amplitude_force[20:])
