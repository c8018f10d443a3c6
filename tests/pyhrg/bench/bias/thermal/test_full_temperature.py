"""The temperature test recovers the known temperature coefficients of a gyro."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.intervals.full_temperature import SOAKS, truths, warm
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.thermal import full_temperature
from pyhrg.bench.bias.thermal_programme import make_programme
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records import campaign

SCALE = {"bias per kelvin": 1e-4, "temperature-rate bias": 3e-3 * 60, "scale factor": 5e-7}


@pytest.fixture(scope="module")
def device() -> Device:
    noisy = warm(np.random.default_rng(5))
    return replace(noisy.without_noise(), power_on_scatter=0.0)


@pytest.fixture(scope="module")
def outcome(slow_fmu: GyroFmu, device: Device) -> Outcome:
    bench = Bench(slow_fmu, device, step=1.0)
    course = make_programme(bench, SOAKS)
    return full_temperature.evaluate(
        bench.campaign(bench.run([PowerOn("thermal", full_temperature.KIND, course)]))
    )


def test_recovers_slopes(outcome: Outcome, device: Device) -> None:
    for name, truth in truths(device).items():
        unit = 1.0 if name.startswith("scale") else DEG_PER_H
        size = next(size for start, size in SCALE.items() if name.startswith(start)) * unit
        assert outcome.finding(name).value == pytest.approx(truth, abs=0.02 * size), name


def test_loop_frequency_tells_the_lag(outcome: Outcome, device: Device) -> None:
    assert outcome.finding("thermal lag").value == pytest.approx(device.thermal_lag, abs=1.0)
    expected = device.frequency * device.frequency_per_kelvin
    assert outcome.finding("frequency per kelvin").value == pytest.approx(expected, rel=1e-4)


def test_soaks_are_means_over_the_circumference(outcome: Outcome) -> None:
    assert "over the circumference" in outcome.finding("bias over temperature").note
    assert [row[0] for row in outcome.tables[0].rows] == ["0.0", "25.0", "50.0"]


def test_one_power_on_has_no_repeatability(outcome: Outcome) -> None:
    found = outcome.finding("bias repeatability over temperature")
    assert np.isnan(found.value)
    assert "one power-on" in found.note


def test_constant_temperature_is_an_error(slow_fmu: GyroFmu, device: Device) -> None:
    bench = Bench(slow_fmu, device, step=1.0)
    still = bench.run([PowerOn("cold", full_temperature.KIND, bench.programme().rest(600.0))])
    with pytest.raises(BenchError, match="cold: the resonator's temperature changes by 0 K"):
        full_temperature.evaluate(bench.campaign(still))


def test_recorded_ramp(recorded_campaign: Path) -> None:
    """dev-01: lag 600 s and 85 ppm/K of 7 kHz in its page, no temperature-rate bias in truth."""
    outcome = full_temperature.evaluate(campaign.read_campaign(recorded_campaign))
    assert outcome.finding("thermal lag").value == pytest.approx(600.0, abs=1.0)
    assert outcome.finding("frequency per kelvin").value_in_unit == pytest.approx(0.595, abs=1e-4)
    for name in ("bias per kelvin", "temperature-rate bias"):
        found = outcome.finding(name)
        assert abs(found.value) < found.high - found.low
    assert np.isnan(outcome.finding("scale factor per kelvin").value)
