"""Forms outside the catalogue."""

import ast
from pathlib import Path

import numpy as np
import pytest

import pyhrg
from pyhrg.challenge.campaigns.course import Course
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.challenge.campaigns.plans import TESTS, Variation
from pyhrg.challenge.truths.form import FORMS_MODULE, Form, load_forms
from pyhrg.challenge.truths.meter import Meter, make_measured_course
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.challenge.short import GYRO

ROOTS = [Path(pyhrg.__file__).parents[1] / name for name in ("pyhrg", "ins_eval", "fmu_build")]
COORDINATES = (
    *("wave_angle", "temperature", "rate", "acceleration"),
    *("table_angle", "amplitude", "time", "noise"),
)


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


def test_there_are_forms_in_every_coordinate() -> None:
    assert len(load_forms()) >= 12
    assert {form.coordinate for form in load_forms()} == set(COORDINATES)
    assert len({form.name for form in load_forms()}) == len(load_forms())


@pytest.mark.parametrize("form", load_forms(), ids=lambda form: form.name)
def test_a_form_shows_beyond_the_catalogue_and_vanishes_with_its_size(
    meter: Meter, form: Form
) -> None:
    """Six sigmas and more within ten sizes that are nothing special."""
    gaps = [
        meter.residual(GYRO, form.disturbance(GYRO, size, np.random.default_rng(3)))
        for size in (10.0, 1e-8)
    ]
    assert meter.sigmas_beyond_catalogue(gaps[0]) > 6
    assert np.linalg.norm(gaps[1]) < 1e-3 * np.linalg.norm(gaps[0])


@pytest.mark.parametrize("form", load_forms(), ids=lambda form: form.name)
def test_a_form_is_the_same_by_the_same_generator(meter: Meter, form: Form) -> None:
    course, start = meter.tests[0]
    rates = [
        form.disturbance(GYRO, 1.0, np.random.default_rng(seed)).rate(course, start)
        for seed in (5, 5)
    ]
    np.testing.assert_array_equal(rates[0], rates[1])
