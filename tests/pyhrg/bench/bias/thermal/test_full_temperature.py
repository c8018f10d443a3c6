"""The temperature test recovers the known temperature coefficients of a gyro."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.intervals.full_temperature import SOAKS, scale_factor_error, truths, warm
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.thermal import full_temperature
from pyhrg.bench.bias.thermal.thermal_scale_factor import STABILITY, make_findings
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
        assert outcome.finding(name).si_value == pytest.approx(truth, abs=0.02 * size), name


def test_loop_frequency_tells_the_lag(outcome: Outcome, device: Device) -> None:
    assert outcome.finding("thermal lag").si_value == pytest.approx(device.thermal_lag, abs=1.0)
    expected = device.frequency * device.frequency_per_kelvin
    assert outcome.finding("frequency per kelvin").si_value == pytest.approx(expected, rel=1e-4)


def test_soaks_are_means_over_the_circumference(outcome: Outcome) -> None:
    assert "over the circumference" in outcome.finding("bias over temperature").note
    assert [row[0] for row in outcome.tables[0].rows] == ["0.0", "25.0", "50.0"]


def test_scale_factor_is_that_of_the_whole_circumference(outcome: Outcome, device: Device) -> None:
    """Pick-off errors g and d make -g cos 4th - d sin 4th of it, 40 ppm; its mean changes by less
    than one. Deviation (n - 1) of three phases at each of three soaks."""
    soaks = np.array(SOAKS) - 25.0
    mean = np.array([scale_factor_error(device, kelvin) for kelvin in soaks])
    gain = device.pickoff_gain_mismatch + device.pickoff_gain_per_kelvin * soaks
    wave = -(gain + 1j * device.pickoff_nonorthogonality)
    around = mean[:, None] + (wave[:, None] * np.exp(-2j * np.pi / 3 * np.arange(3))).real
    found = outcome.finding("scale factor stability over temperature")
    assert found.si_value == pytest.approx(np.std(around, ddof=1), rel=0.01)
    alone = outcome.finding("scale factor over temperature")
    assert alone.si_value == pytest.approx(np.std(mean, ddof=1), abs=1e-8)


@pytest.mark.parametrize("ratio", [3.0, 50.0])
def test_scale_factor_interval_holds_the_deviation(ratio: float) -> None:
    """Scatter of the harmonic over that of the mean; by a long test it is about 50. 400 repeats:
    the standard deviation of a coverage is 1.1 %."""
    generator, inside = np.random.default_rng(1), 0
    warmth = np.repeat(np.arange(6) * 20.0, 4)
    phases = np.exp(2j * np.pi / 3 * np.arange(3))
    for _ in range(400):
        mean, wave = 30 * generator.normal(size=6), 100 * np.exp(1j * generator.uniform(0, 6))
        noise = generator.normal(size=(3, 24)) * [[1.0], [ratio], [ratio]]
        found = make_findings(
            warmth, np.repeat(mean, 4) + noise[0], wave + noise[1] + 1j * noise[2]
        )
        true = np.var((mean[:, None] + (wave * phases).real), ddof=1) + (1 + ratio**2) / 4
        finding = next(each for each in found if each.name == STABILITY)
        inside += finding.si_low <= np.sqrt(true) <= finding.si_high
    assert inside > 0.93 * 400


def test_one_power_on_has_no_repeatability(outcome: Outcome) -> None:
    found = outcome.finding("bias repeatability over temperature")
    assert np.isnan(found.si_value)
    assert "one power-on" in found.note


def test_constant_temperature_is_an_error(slow_fmu: GyroFmu, device: Device) -> None:
    bench = Bench(slow_fmu, device, step=1.0)
    still = bench.run([PowerOn("cold", full_temperature.KIND, bench.programme().rest(600.0))])
    with pytest.raises(BenchError, match="cold: the resonator's temperature changes by 0 K"):
        full_temperature.evaluate(bench.campaign(still))


def test_recorded_ramp(recorded_campaign: Path) -> None:
    """dev-01: lag 600 s and 85 ppm/K of 7 kHz in its page, no temperature-rate bias in truth."""
    outcome = full_temperature.evaluate(campaign.read_campaign(recorded_campaign))
    assert outcome.finding("thermal lag").si_value == pytest.approx(600.0, abs=1.0)
    assert outcome.finding("frequency per kelvin").value == pytest.approx(0.595, abs=1e-4)
    for name in ("bias per kelvin", "temperature-rate bias"):
        found = outcome.finding(name)
        assert abs(found.si_value) < found.si_high - found.si_low
    assert np.isnan(outcome.finding("scale factor per kelvin").si_value)
