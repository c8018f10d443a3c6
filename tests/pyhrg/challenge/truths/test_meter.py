"""Strengths, against closed forms."""

import math
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.programme import Programme, make_course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.challenge.campaigns.laboratory import vary_each
from pyhrg.challenge.truths.meter import Meter, make_measured_course
from pyhrg.challenge.truths.noise_strength import measure_noise
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS, KNOWN, NOISES
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from pyhrg.theory.closed_forms import beyond_the_average
from tests.pyhrg.challenge.short import GRAVITY, GYRO

ROWS = 400
RATE = 1e-3 * DEG_PER_H


def meter(simulation: Simulation, nominal: Device = GYRO, rate: float = 0.0) -> Meter:
    programme = Programme(1.0, GRAVITY).spin(rate, ROWS)
    course = make_course(programme, 1.0)
    return Meter(simulation, nominal, [(course, 0.3)], Instruments())


def test_no_gap_has_no_strength(simulation: Simulation) -> None:
    assert meter(simulation).sigmas(GYRO) == 0


def test_a_rate_on_random_walk(simulation: Simulation) -> None:
    """W sqrt(t)/N, where walk is all the noise."""
    device = replace(GYRO, angle_white_noise=1e-12, frequency_split=0.0, damping_anisotropy=0.0)
    disturbance = Disturbance(rate=lambda course, start: np.full((1, 1), RATE))
    found = meter(simulation, device).sigmas(device, disturbance)
    assert found == pytest.approx(RATE * math.sqrt(ROWS) / device.angle_random_walk, rel=0.01)


def test_a_rate_that_the_latitude_imitates(simulation: Simulation) -> None:
    """Beside a parameter with a standard deviation of s sigma in the records, S is S/sqrt(1 + s^2):
    at rest the latitude's tolerance t is a rate of t W_E cos(latitude)."""
    device = replace(GYRO, angle_white_noise=1e-12, frequency_split=0.0, damping_anisotropy=0.0)
    laboratories = vary_each(device, 2.0)
    tolerance = EFFECTS["site_latitude"].tolerance_of(device)
    assert max(lab.errors["latitude_error"] for lab in laboratories) == 2 * tolerance
    assert len(laboratories) == sum(known.size for known in KNOWN)
    assert vary_each(device, 0.0) == []
    disturbance = Disturbance(rate=lambda course, start: np.full((1, 1), RATE))
    walk = device.angle_random_walk / math.sqrt(ROWS)
    site = EARTH_RATE * math.cos(device.site.latitude) * 2 * tolerance / walk
    assert site > 0.3
    measuring = replace(meter(simulation, device), laboratories=laboratories)
    expected = RATE / walk / math.hypot(1, site)
    assert measuring.sigmas(device, disturbance) == pytest.approx(expected, rel=0.01)


def test_a_ramp_on_white_noise(simulation: Simulation) -> None:
    """W sqrt(sum t^2)/R, where reading noise is all there is."""
    device = replace(
        GYRO, angle_random_walk=1e-14, angle_white_noise=ARCSEC, frequency_split=0.0,
        damping_anisotropy=0.0,
    )  # fmt: skip
    disturbance = Disturbance(rate=lambda course, start: np.full((1, 1), RATE))
    times = np.arange(1, ROWS + 1)
    expected = RATE * math.sqrt(float(np.sum(times**2))) / ARCSEC
    assert meter(simulation, device).sigmas(device, disturbance) == pytest.approx(
        expected, rel=0.01
    )


def test_an_effect_leaves_nothing_beyond_itself(simulation: Simulation) -> None:
    measuring = meter(simulation, rate=5 * DEG)
    effect = EFFECTS["pickoff_gain_mismatch"]
    gap = measuring.residual(effect.put(GYRO, np.array([1e-6])))
    assert measuring.sigmas_beyond(effect, gap) < 1e-3 * np.linalg.norm(gap)
    assert measuring.sigmas_beyond_catalogue(gap) < 1e-3 * np.linalg.norm(gap)
    other = EFFECTS["input_axis_misalignment"]
    assert measuring.sigmas_beyond(other, gap) > 0.5 * np.linalg.norm(gap)


def test_what_the_average_leaves_out_is_noise_of_its_shape(simulation: Simulation) -> None:
    """Three times it are three deviations, however far it stands out of the rows' noise."""
    course = make_measured_course(Programme(0.1, GRAVITY).rest(5).spin(100 * DEG, 20))
    rate = course.rate.mean(axis=1)

    def shown(log: Log) -> Log:
        middle = log.wave_angle + GYRO.bryan_factor * rate * log.interval / 2
        more = beyond_the_average(GYRO, rate, middle)["quadrature_force"]
        return replace(log, quadrature_force=log.quadrature_force + 3 * more)

    found = Meter(simulation, GYRO, [(course, 0.3)], Instruments())
    assert found.sigmas(GYRO, Disturbance(shown=shown)) == pytest.approx(3, rel=0.01)


@pytest.mark.parametrize(("size", "least", "most"), [(0.9, 0.0, 0.01), (5.0, 10.0, math.inf)])
def test_a_swing_below_the_noise_of_the_thermometer_shows_nothing_at_rest(
    simulation: Simulation, size: float, least: float, most: float
) -> None:
    """Size over that noise: the replay gets the mean of readings that show no more than noise."""

    def read(log: Log) -> Log:
        swing = size * Instruments().temperature * np.sin(2 * math.pi * log.time / 100.0)
        return replace(log, temperature=log.temperature + swing)

    assert least <= meter(simulation).sigmas(GYRO, Disturbance(shown=read)) <= most


def test_parameters_say_the_effect(simulation: Simulation) -> None:
    measuring = meter(simulation, rate=5 * DEG)
    effect = EFFECTS["damping_anisotropy"]
    vector = effect.vector(GYRO) + 1e-8
    direct = measuring.sigmas(effect.put(GYRO, vector))
    assert measuring.sigmas_of(effect.name, effect.parameters(vector)) == pytest.approx(direct)
    with pytest.raises(KeyError, match="no_such"):
        measuring.sigmas_of("no_such", {})


def test_twice_the_noise_of_white_readings(simulation: Simulation) -> None:
    """Twice the divergence of n variances r times as large is n (r - 1 - ln r); a level known to
    3 % may make up for some of it."""
    nominal = replace(GYRO, angle_random_walk=0.0)
    device = replace(nominal, angle_white_noise=2 * nominal.angle_white_noise)
    off = np.linspace(0, 30, 100_001)
    ratios = 4 * np.exp(-2 * 0.03 * off)
    expected = math.sqrt(np.min((ROWS - 1) * (ratios - 1 - np.log(ratios)) + off**2))
    assert expected < math.sqrt((ROWS - 1) * (4 - 1 - math.log(4)))
    assert meter(simulation, nominal).sigmas_of_noise(device) == pytest.approx(expected)


def test_quantisation_and_white_noise_stand_in_for_each_other(simulation: Simulation) -> None:
    measuring = meter(simulation)
    by_name = {noise.name: noise for noise in NOISES}
    coarse = replace(GYRO, quantization_step=0.5 * ARCSEC)
    assert measuring.sigmas_of_noise(coarse) > 10
    assert measuring.sigmas_of_noise_beyond(by_name["angle_white_noise"], coarse) < 0.1
    assert measuring.sigmas_of_noise_beyond(by_name["rate_random_walk"], coarse) > 10


def test_any_noise_has_a_strength() -> None:
    """Also one that no tolerance of a stated level explains; no number overflows on the way."""
    stated = replace(GYRO, angle_random_walk=1e-5)
    loud = replace(GYRO, bias_instability=1e-2)
    rests = ((0.1, 400.0), (1.0, 3600.0))
    courses = [make_course(Programme(row, GRAVITY).rest(time), row) for row, time in rests]
    assert 10 < measure_noise(loud, stated, courses) < math.inf


def test_noise_that_comes_is_as_strong_as_its_divergence_from_steady_noise(
    simulation: Simulation,
) -> None:
    """Five times the random walk's power in every other stretch of 256 s, beside none: walk is all
    the noise, r over the mean of 3.5. Loud everywhere, it is steady."""
    device = replace(GYRO, angle_white_noise=1e-12, frequency_split=0.0, damping_anisotropy=0.0)
    course = make_course(Programme(1.0, GRAVITY).spin(0.0, 8192), 1.0)
    measuring = Meter(simulation, device, [(course, 0.3)], Instruments())
    loud = np.arange(len(course)) // 256 % 2 == 0
    noise = np.random.default_rng(1).standard_normal(len(course))

    def sigmas(where: np.ndarray) -> float:
        rate = math.sqrt(5) * device.angle_random_walk * (where * noise)[:, None]
        return measuring.sigmas_of_unsteady(Disturbance(rate=lambda course, start: rate))

    ratio = np.where(loud, 6.0, 1.0) / 3.5
    expected = math.sqrt(float(np.sum(ratio - 1 - np.log(ratio))))
    assert sigmas(loud) == pytest.approx(expected, rel=0.1)
    assert sigmas(np.ones(len(course))) < 0.2 * expected
