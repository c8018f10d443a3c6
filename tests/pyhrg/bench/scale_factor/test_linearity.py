"""Nonlinearity, symmetry, repeatability."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure

from benchmarks.intervals.linearity import RATES, repeat
from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.scale_factor import linearity
from pyhrg.bench.scale_factor.linearity import Line
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.ready_devices import TYPICAL, Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

INPUT = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])


def test_a_line_is_exact() -> None:
    line = Line(INPUT, 1.001 * INPUT + 0.5)
    assert line.fit() == pytest.approx((1.001, 0.5))
    assert line.residual == pytest.approx(np.zeros(6), abs=1e-15)
    assert line.asymmetry == pytest.approx(0.0, abs=1e-15)


def test_asymmetry_and_nonlinearity_are_the_standards() -> None:
    bent = Line(INPUT, INPUT + 0.01 * np.abs(INPUT))
    assert bent.asymmetry == pytest.approx(0.02)
    cubic = Line(INPUT, INPUT + 0.001 * INPUT**3)
    left = 0.001 * INPUT**3 - np.polyval(np.polyfit(INPUT, 0.001 * INPUT**3, 1), INPUT)
    assert cubic.residual == pytest.approx(left / (3 + 0.027))


def test_recovers_without_noise(slow_fmu: GyroFmu) -> None:
    """The pattern lingers where damping anisotropy slows it: W - sqrt(W^2 - W_L^2) at each rate."""
    device = Device(damping_anisotropy=3e-4)
    bench = Bench(slow_fmu, device, step=0.1)
    campaign = bench.campaign(linearity.record(bench, 1, RATES))
    line = linearity.read_lines(campaign)[0]
    lock = 3e-4 / (4 * 0.277)
    hold = 1 + theory.hold_scale_factor_error(1e-3, 0.0, 450.0)
    expected = Line(line.input, hold * np.sign(line.input) * np.sqrt(line.input**2 - lock**2))
    assert line.residual == pytest.approx(expected.residual, abs=1e-9)
    found = linearity.evaluate(campaign).finding("scale factor nonlinearity")
    assert found.si_value == pytest.approx(np.max(np.abs(expected.residual)), rel=0.01)
    assert np.isnan(found.si_low)


def test_a_linear_gyro_is_linear(slow_fmu: GyroFmu) -> None:
    """Control: noise alone, zero in the intervals of nonlinearity and asymmetry; scale factor and
    bias those of theory."""
    bench = Bench(slow_fmu, replace(TYPICAL, frequency_split=0.0), step=0.1)
    found = linearity.evaluate(bench.campaign(linearity.record(bench, 4, RATES)))
    assert found.finding("scale factor nonlinearity").si_low == 0.0
    assert found.finding("scale factor nonlinearity").si_high < 0.05e-6
    assert found.finding("scale factor asymmetry").si_low == 0.0
    error = theory.hold_scale_factor_error(1e-3, 0.0, 450.0)
    assert found.finding("scale factor error").si_value == pytest.approx(error, abs=0.01e-6)
    bias = theory.mean_bias(TYPICAL)
    assert found.finding("bias").si_value == pytest.approx(bias, abs=0.002 * DEG_PER_H)


def test_intervals_hold_the_truth(slow_fmu: GyroFmu) -> None:
    """20 repeats, 19 +- 1 expected: 15 are 4 sigma less."""
    results = [repeat(slow_fmu, seed) for seed in range(20)]
    for name in results[0]:
        inside = sum(low <= truth <= high for truth, low, high in (r[name] for r in results))
        assert inside >= 15, name


def test_too_few_rates_are_refused(slow_fmu: GyroFmu) -> None:
    bench = Bench(slow_fmu, TYPICAL, step=0.1)
    campaign = bench.campaign(linearity.record(bench, 1, RATES[3:]))
    with pytest.raises(BenchError, match=r"linearity_1: 8 positive rates .* needs 11 each way"):
        linearity.evaluate(campaign)


def test_power_ons_at_other_rates_are_refused(slow_fmu: GyroFmu) -> None:
    bench = Bench(slow_fmu, TYPICAL, step=0.1)
    faster = tuple(rate * 1.5 for rate in RATES)
    tests = [*linearity.record(bench, 1, RATES), *linearity.record(bench, 1, faster)]
    with pytest.raises(BenchError, match="not at the rates of"):
        linearity.evaluate(bench.campaign(tests))


def test_one_power_on_has_no_repeatability(slow_fmu: GyroFmu) -> None:
    bench = Bench(slow_fmu, TYPICAL, step=0.1)
    found = linearity.evaluate(bench.campaign(linearity.record(bench, 1, RATES)))
    assert np.isnan(found.finding("scale factor repeatability").si_value)
    assert "of at least 2" in found.finding("scale factor repeatability").note
    figure = Figure()
    assert found.draw is not None
    found.draw(figure)
    assert "ppm" in figure.axes[0].get_ylabel()
