"""Tumble and centrifuge recover the known sensitivities of a gyro."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.intervals import centrifuge as centrifuge_coverage
from benchmarks.intervals import tumble as tumble_coverage
from pyhrg.bench.bench import PowerOn
from pyhrg.bench.bias.environment import centrifuge, tumble
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records import campaign
from tests.pyhrg.bench.cases import QUIET, slow_bench

PER_G = DEG_PER_H / STANDARD_GRAVITY
SENSITIVE = replace(
    QUIET,
    bias_per_acceleration=0.02 * PER_G,
    pickoff_gain_per_acceleration=1e-6,
    model={"pickOff.gainPerAccelerationSquared[3]": 2e-8},
)
QUARTER = 1 / (4 * QUIET.bryan_factor * QUIET.decay_time)
"""Bias by a gain mismatch, as sin 4th, per mismatch."""


def run_tumble(fmu: GyroFmu, device: Device, **plan: object) -> Outcome:
    bench = slow_bench(fmu, device)
    course = tumble.make_programme(bench, **plan)
    return tumble.evaluate(bench.campaign(bench.run([PowerOn("tumble", tumble.KIND, course)])))


def run_centrifuge(fmu: GyroFmu, device: Device) -> Outcome:
    bench = slow_bench(fmu, device)
    return centrifuge.evaluate(bench.campaign(centrifuge.record(bench)))


def test_tumble_recovers_linear_terms(slow_fmu: GyroFmu) -> None:
    outcome = run_tumble(slow_fmu, SENSITIVE, segments=1)
    within = 2e-5 * PER_G
    assert outcome.finding("g bias z").si_value == pytest.approx(0.02 * PER_G, abs=within)
    assert outcome.finding("g bias x").si_value == pytest.approx(0.0, abs=within)
    sine = outcome.finding("g bias x sin4")
    assert sine.si_value == pytest.approx(1e-6 * QUARTER, rel=0.005)


def test_centrifuge_recovers_quadratic_terms(slow_fmu: GyroFmu) -> None:
    outcome = run_centrifuge(slow_fmu, SENSITIVE)
    assert outcome.finding("g bias z").si_value == pytest.approx(0.02 * PER_G, rel=1e-3)
    assert outcome.finding("g squared zz sin4").si_value == pytest.approx(2e-8 * QUARTER, rel=0.02)


@pytest.mark.parametrize("name", ["g bias x", "g bias y", "g bias z", "g squared zz over mean"])
def test_insensitive_gyro_shows_none(slow_fmu: GyroFmu, name: str) -> None:
    """Negative control: 99.99 % of normal deviation, so that one seed decides."""
    found = run_tumble(slow_fmu, TYPICAL, segments=1).finding(name)
    assert abs(found.si_value) < 2 * (found.si_high - found.si_low) / 2


def test_one_pattern_angle_gives_the_sum_there_and_says_so(slow_fmu: GyroFmu) -> None:
    device = replace(SENSITIVE, power_on_angle=np.radians(22.5 / 2))
    outcome = run_tumble(slow_fmu, device, pattern_angles=1)
    angle = device.power_on_angle
    expected = 1e-6 * QUARTER * np.sin(4 * angle)
    assert outcome.finding("g bias x").si_value == pytest.approx(expected, rel=0.05)
    assert any("can't be separated" in text for text in outcome.warnings)


def test_six_positions_refuse_products(slow_fmu: GyroFmu) -> None:
    outcome = run_tumble(slow_fmu, SENSITIVE, positions=tumble.SIX)
    found = outcome.finding("g squared xz")
    assert np.isnan(found.si_value)
    assert "don't vary" in found.note


def test_one_attitude_is_an_error(slow_fmu: GyroFmu) -> None:
    with pytest.raises(BenchError, match="tumble: 1 different specific forces; at least 3"):
        run_tumble(slow_fmu, SENSITIVE, positions=tumble.SIX[:1])


def test_short_positions_are_an_error(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    course = bench.programme().rest(60.0)
    test = bench.run([PowerOn("hasty", tumble.KIND, course)])
    with pytest.raises(BenchError, match="hasty: nothing rests for 100 s after 20 s"):
        tumble.evaluate(bench.campaign(test))


@pytest.mark.parametrize("case", [tumble_coverage, centrifuge_coverage])
def test_intervals_hold_what_was_put_in(slow_fmu: GyroFmu, case: object) -> None:
    """Eight repeats: of n = 8 x terms intervals of 95 %, four sigma of the binomial fewer."""
    results = [case.repeat(slow_fmu, seed) for seed in range(8)]  # type: ignore[attr-defined]
    inside = [low <= truth <= high for found in results for truth, low, high in found.values()]
    n = len(inside)
    assert sum(inside) >= 0.95 * n - 4 * np.sqrt(0.95 * 0.05 * n)


def test_recorded_tumble_of_an_insensitive_gyro(recorded_campaign: Path) -> None:
    """Its truth has no sensitivity; three intervals, each twice as wide as 95 %."""
    outcome = tumble.evaluate(campaign.read_campaign(recorded_campaign))
    for axis in "xyz":
        found = outcome.finding(f"g bias {axis}")
        assert abs(found.si_value) < found.si_high - found.si_low
