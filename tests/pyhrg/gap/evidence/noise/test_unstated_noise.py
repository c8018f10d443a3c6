"""Estimates of the noise that a campaign doesn't state."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_SQRT_H, HOUR
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.evidence.noise.unstated_noise import complete_stated_noise
from pyhrg.gap.replay.observations import ObservedTest, observe_test
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.whitening import NoiseModel, draw_noise
from pyhrg.records.campaign import CampaignError, Test

WHITE, WALK = 0.04 * ARCSEC, 4e-4 * DEG_PER_SQRT_H
BELIEVED = Device(damping_anisotropy=1e-6, damping_axis=20 * DEG)
TRUTH = replace(BELIEVED, damping_anisotropy=1.5e-6)


@pytest.fixture(scope="module")
def simulation(fmu: GyroFmu, slow_fmu: GyroFmu) -> Simulation:
    return Simulation(fmu, slow_fmu)


def recorded(simulation: Simulation, kind: str, seed: int, duration: float = HOUR) -> ObservedTest:
    """A gyro with a gap and noise, at rest or turning."""
    bench = Bench(simulation.quasi_steady, TRUTH, step=0.1)
    course = bench.programme(1.0)
    course = course.rest(duration) if kind == "static" else course.spin(5 * DEG, duration)
    log = bench.log(PowerOn(kind, kind, course, 17 * DEG)).log
    noise = draw_noise(NoiseModel(WHITE, WALK), len(log.time), 1.0, np.random.default_rng(seed))
    noisy = replace(log, gyro_angle=log.gyro_angle + noise)
    return observe_test(Test(kind, kind, "fit", noisy), BELIEVED)


def test_it_is_estimated_at_rest_whatever_the_gap(simulation: Simulation) -> None:
    """Mean of seeds 0 to 3 within a tenth, four standard errors of an hour's random walk."""
    tests = [recorded(simulation, "static", seed) for seed in range(4)]
    gyro, notes = complete_stated_noise(simulation, BELIEVED, tests)
    assert gyro.angle_white_noise == pytest.approx(WHITE, rel=0.1)
    assert gyro.angle_random_walk == pytest.approx(WALK, rel=0.1)
    noises = ("white noise of the output angle", "angle random walk")
    assert [note.partition(",")[0] for note in notes] == [f"nominal: states no {n}" for n in noises]
    assert replace(gyro, angle_white_noise=0.0, angle_random_walk=0.0) == BELIEVED


def test_short_stretches_give_it_without_a_bias(simulation: Simulation) -> None:
    """20 stretches of two minutes, within four standard errors of 20 times 117 rows."""
    tests = [recorded(simulation, "static", seed, 120.0) for seed in range(20)]
    gyro, _ = complete_stated_noise(simulation, BELIEVED, tests)
    assert gyro.angle_white_noise == pytest.approx(WHITE, rel=0.15)
    assert gyro.angle_random_walk == pytest.approx(WALK, rel=0.25)


def test_what_is_stated_stays(simulation: Simulation) -> None:
    stated = replace(BELIEVED, angle_white_noise=WHITE)
    assert complete_stated_noise(simulation, stated, [recorded(simulation, "rate", 1)]) == (
        stated,
        (),
    )


def test_white_noise_that_a_maker_leaves_out_is_estimated_beside_the_stated_walk(
    simulation: Simulation,
) -> None:
    """Mean of seeds 0 to 3; the walk stays as it is stated. A maker who states no noise of a
    reading does not say that there is none."""
    stated = replace(BELIEVED, angle_random_walk=WALK)
    tests = [recorded(simulation, "static", seed) for seed in range(4)]
    gyro, (note,) = complete_stated_noise(simulation, stated, tests)
    assert gyro.angle_white_noise == pytest.approx(WHITE, rel=0.1)
    assert gyro.angle_random_walk == WALK
    assert note.startswith("nominal: states no white noise of the output angle, which is taken")


def warmed(test: ObservedTest, change: float) -> ObservedTest:
    """The test with a room that warms up and cools down again, K."""
    swing = change * np.sin(np.linspace(0.0, np.pi, len(test.log.time)))
    log = replace(test.log, temperature=test.log.temperature + swing)
    return observe_test(replace(test.test, recording=log), BELIEVED)


def test_it_is_estimated_in_a_room_whose_temperature_moves(simulation: Simulation) -> None:
    """A thermometer that moved by 0.3 K made no row count as at rest."""
    tests = [warmed(recorded(simulation, "static", seed), 0.3) for seed in range(4)]
    gyro, _ = complete_stated_noise(simulation, BELIEVED, tests)
    assert gyro.angle_white_noise == pytest.approx(WHITE, rel=0.1)
    assert gyro.angle_random_walk == pytest.approx(WALK, rel=0.1)


def test_a_refusal_counts_the_rows_by_limit(simulation: Simulation) -> None:
    tests = [
        recorded(simulation, "rate", 1, 700.0),
        recorded(simulation, "static", 1, 300.0),
        warmed(recorded(simulation, "static", 1), 12.0),
    ]
    with pytest.raises(CampaignError) as refusal:
        complete_stated_noise(simulation, BELIEVED, tests)
    assert "have 300 rows at rest; expected angle_random_walk" in str(refusal.value)
    assert "3600 while the temperature changed by more than 3 K" in str(refusal.value)
    assert "700 on a table that turns at 0.0057 deg/s or faster" in str(refusal.value)
