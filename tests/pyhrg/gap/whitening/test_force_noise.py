"""Noise of the loops' forces in short rows: closed form and estimate against the FMU."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.units import ARCSEC, DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.loop_response import FORCES
from pyhrg.gap.replay.observations import observe_test
from pyhrg.gap.whitening.channel_noise import compute_visible_share, estimate_campaign_noise
from pyhrg.records import Log
from pyhrg.records.campaign import Test

GYRO = Device(angle_random_walk=5e-4 * DEG_PER_SQRT_H)
BOTH_NOISES = replace(GYRO, angle_white_noise=0.1 * ARCSEC)
DENSITY = (2 * GYRO.bryan_factor * GYRO.angle_random_walk) ** 2


def record_rest(fmu: GyroFmu, device: Device, interval: float) -> Log:
    """12,000 rows at rest."""
    bench = Bench(fmu, device, seed=3)
    course = bench.programme(interval).rest(12_000 * interval)
    return bench.run([PowerOn("rest", "static", course)])[0].log


@pytest.mark.parametrize("interval", [0.02, 0.1])
def test_second_differences_see_the_share_of_the_closed_form(fmu: GyroFmu, interval: float) -> None:
    """To four standard errors of a variance of 12,000 rows, correlated over some."""
    log = record_rest(fmu, GYRO, interval)
    share = compute_visible_share(interval, GYRO.amplitude_loop)
    for name in FORCES:
        measured = np.var(np.diff(getattr(log, name)[log.time > 10], 2)) / 6
        assert measured == pytest.approx(share * DENSITY / interval, rel=0.1), name


@pytest.mark.parametrize("device", [GYRO, BOTH_NOISES])
def test_means_of_forces_have_the_noise_that_their_short_rows_are_given(
    fmu: GyroFmu, device: Device
) -> None:
    """Rows of 0.1 s. Second differences of force noise alone see 44 % of its standard deviation, so
    that means of 10 s were 2.3 times noisier than they were believed to be."""
    log = record_rest(fmu, device, 0.1)
    observed = observe_test(Test("rest", "static", "fit", log), device)
    residual = {name: getattr(log, name) for name in observed.rows}
    noise = estimate_campaign_noise(device, [observed], [residual])
    for name in FORCES:
        means = getattr(log, name)[500:].reshape(-1, 100).mean(axis=1)
        believed = noise.get_model(name, observed).angle_white_noise / 10
        assert means.std() == pytest.approx(believed, rel=0.25), name


def test_a_recorders_white_noise_is_not_taken_for_force_noise(fmu: GyroFmu) -> None:
    """Rows of 0.1 s. Second differences alone would allow 2.3 times as much; means of rows do
    not. The standard error of 12,000 rows' means is 2 %."""
    observed = observe_test(Test("rest", "static", "fit", record_rest(fmu, GYRO, 0.1)), GYRO)
    white = 1e-8 * np.random.default_rng(5).standard_normal(12_000)
    noise = estimate_campaign_noise(GYRO, [observed], [dict.fromkeys(observed.rows, white)])
    for name in FORCES:
        assert noise.get_model(name, observed).angle_white_noise == pytest.approx(1e-8, rel=0.1)
