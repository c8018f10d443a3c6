"""A table whose axis is tilted, or which twists, and a chamber with a gradient: what is named."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn, compute_earth_rate
from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.arrays import Array
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import ARCSEC, DEG, STANDARD_GRAVITY
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.findings.diagnosis import Diagnosis
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.report.verdict import summarize_diagnosis
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.closing.equation.planted import record_planted, shift_angle
from tests.pyhrg.gap.soundness.conftest import NOMINAL

LATITUDE = NOMINAL.site.latitude
EARTH = EARTH_RATE * np.array([0.0, np.cos(LATITUDE), np.sin(LATITUDE)])
"""Earth's rate along east, north and up, rad/s."""
ROOM = 293.15


def find_earth_rate(axis_up: Array, east: float, north: float) -> Array:
    """Earth's rate on an input axis that a base carries, which is tilted by a rotation."""
    axis = np.stack([np.sqrt(1 - axis_up**2), np.zeros_like(axis_up), axis_up], axis=-1)
    vector = np.array([-north, east, 0.0])
    angle = np.linalg.norm(vector)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return np.asarray(axis @ turn.T @ EARTH)


@pytest.mark.parametrize(("east", "north"), [(1e-3, 0.0), (0.0, 1e-3), (-7e-4, 5e-4)])
def test_a_tilt_is_a_rotation_of_the_base(east: float, north: float) -> None:
    axis_up = np.array([1.0, -1.0, 0.0])
    tilted = replace(NOMINAL, table_tilt_east=east, latitude_error=north)
    found = compute_earth_rate(tilted, axis_up, np.zeros(3))
    assert found == pytest.approx(find_earth_rate(axis_up, east, north), abs=1e-6 * EARTH_RATE)


def diagnose_tilt(simulation: Simulation, east: float, north: float) -> Diagnosis:
    def rate(course: Course, start: float) -> Array:
        up = course.each("axis_up")
        return find_earth_rate(up, east, north) - up * EARTH[2]

    bench = Bench(simulation.sampled, NOMINAL)
    tumble = bench.programme()
    for attitude in ((1.0, 0.0), (-1.0, 0.0), *((0.0, a * np.pi / 2) for a in range(4))):
        tumble.attitude(*attitude).rest(200)
    ride = bench.programme().rest(300)
    power_ons = [PowerOn("tumble", "tumble", tumble), PowerOn("ride", "manoeuvre", ride)]
    planted = record_planted(simulation.sampled, Disturbance(rate=rate), 4, power_ons=power_ons)
    return diagnose(planted, simulation=simulation).diagnosis


@pytest.mark.parametrize("tilt", [0.1, 0.4])
def test_a_tilt_to_the_east_has_its_name(simulation: Simulation, tilt: float) -> None:
    """One of 13 tolerances too, which was read as a random walk of the rate."""
    found = diagnose_tilt(simulation, tilt * DEG, 0.0)
    (cause,) = found.causes
    assert (cause.effect, cause.family) == ("table_axis_tilt", "bench")
    low, high = cause.interval_95["table_axis_tilt_east_deg"]
    assert low < tilt < high < low + 0.02


def test_a_tilt_to_the_north_is_a_latitude(simulation: Simulation) -> None:
    found = diagnose_tilt(simulation, 0.0, 0.1 * DEG)
    (cause,) = found.causes
    assert {"site_latitude", "table_axis_tilt"} <= cause.equivalence_class
    assert found.unknown_probability < 0.1


def test_a_tilt_within_tolerance_is_no_gap(simulation: Simulation) -> None:
    found = diagnose_tilt(simulation, 0.005 * DEG, -0.005 * DEG)
    assert found.verdict == "no_gap"
    assert not found.where


def record_tumbles(simulation: Simulation, disturbance: Disturbance, seed: int) -> Campaign:
    """A tumble, and another at another pattern angle, which is held out."""
    tumble = Bench(simulation.sampled, NOMINAL).programme()
    for attitude in ((1.0, 0.0), (-1.0, 0.0), *((0.0, a * np.pi / 2) for a in range(4))):
        tumble.attitude(*attitude).rest(100)
    kinds = (("tumble", "tumble"), ("again", "manoeuvre"))
    power_ons = [PowerOn(name, kind, tumble) for name, kind in kinds]
    return record_planted(simulation.sampled, disturbance, seed, power_ons)


def test_a_table_that_twists_is_an_error_of_the_bench(simulation: Simulation) -> None:
    """Between encoder and gyro, by an arcsecond per g along x."""

    def twist(course: Course, start: float) -> Array:
        angle = ARCSEC / STANDARD_GRAVITY * course.each("acceleration_x")
        return np.diff(angle.ravel(), prepend=angle[0, 0]).reshape(angle.shape) / course.step

    planted = record_tumbles(simulation, Disturbance(rate=twist), 1)
    found = diagnose(planted, simulation=simulation).diagnosis
    (term,) = found.terms
    assert (found.causes, term.place, term.coordinates) == ((), "bench", ("acceleration",))
    value = term.parameters["readout_acceleration_x_arcsec_per_m_s2"]
    assert value == pytest.approx(1 / STANDARD_GRAVITY, rel=0.05)
    figure = found.gap.holdout_angle_arcsec
    assert figure
    assert figure.after < figure.floor_95[1] < figure.before


def test_causes_that_held_out_tests_contradict_are_open(simulation: Simulation) -> None:
    """A read-out that follows the force, and not the pattern, looks like a gain at one angle."""

    def misread(log: Log) -> Log:
        force = log.acceleration_x / STANDARD_GRAVITY
        return shift_angle(log, ARCSEC * (force - force[0]))

    planted = record_tumbles(simulation, Disturbance(shown=misread), 2)
    found = diagnose(planted, simulation=simulation)
    assert [cause.effect for cause in found.diagnosis.causes] == ["g_sensitive_gain"]
    assert found.diagnosis.gap.is_wider_held_out
    assert found.verdict == "ambiguous"
    said = summarize_diagnosis(found)
    assert "agrees with the fitted tests, but not with the held-out ones" in said
    assert "Do not use closed.fmu" in " ".join(said.split())


def read_room(log: Log) -> Array:
    """A thermometer that is nearer to the room by a hundredth."""
    return np.asarray(log.temperature - 0.01 * (log.temperature - ROOM))


def read_wall(log: Log) -> Array:
    """A thermometer on the wall, from which the case differs in proportion to its own rate."""
    return np.asarray(log.temperature + 60 * np.gradient(log.temperature, log.interval))


@pytest.mark.parametrize(
    ("read", "name"), [(read_wall, "thermometer_lag"), (read_room, "thermometer_gain")]
)
def test_a_gradient_in_the_chamber_is_the_thermometers(
    simulation: Simulation, read: Callable[[Log], Array], name: str
) -> None:
    def show(log: Log) -> Log:
        return replace(log, temperature=read(log))

    bench = Bench(simulation.sampled, NOMINAL)
    course = bench.programme(10.0).rest(600)
    course.heat(NOMINAL.reference_temperature + 30, 1500).rest(1500)
    ride = bench.programme().rest(300)
    power_ons = [PowerOn("warm", "thermal", course), PowerOn("ride", "manoeuvre", ride)]
    planted = record_planted(simulation.sampled, Disturbance(shown=show), 5, power_ons=power_ons)
    found = diagnose(planted, simulation=simulation).diagnosis
    (cause,) = found.causes
    assert {name, "temperature_gradient"} <= cause.equivalence_class
    assert found.unknown_probability < 0.1
