"""Bias under vibration and after shock, of gyros whose imbalance is known."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.intervals import vibration_shock as coverage
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.environment import vibration_shock
from pyhrg.bench.bias.environment.shock import find_pulses, read_quiet_changes
from pyhrg.bench.bias.environment.vibration_shock import (
    BEFORE,
    SHOCK,
    make_power_ons,
    make_shock_programme,
)
from pyhrg.bench.outcome import BenchError
from pyhrg.common.units import ARCSEC
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from tests.pyhrg.bench.cases import QUIET, slow_bench


def test_intervals_hold_what_was_put_in(slow_fmu: GyroFmu) -> None:
    """Four sigma of the binomial below 95 %, as if terms were independent."""
    results = [coverage.repeat(slow_fmu, seed) for seed in range(6)]
    inside = [low <= truth <= high for found in results for truth, low, high in found.values()]
    assert sum(inside) >= 0.95 * len(inside) - 4 * np.sqrt(0.0475 * len(inside))


def test_nothing_changes_of_itself(slow_fmu: GyroFmu) -> None:
    """Negative control: same device after vibration; 2 x the 95 % interval."""
    bench = Bench(slow_fmu, replace(TYPICAL, model=coverage.FAST), seed=3, step=1.0)
    courses = [*make_power_ons(bench, BEFORE, 3), *make_power_ons(bench, "after_vibration", 3)]
    outcome = vibration_shock.evaluate(bench.campaign(bench.run(courses)))
    found = outcome.finding("bias change after vibration")
    assert abs(found.si_value) < found.si_high - found.si_low
    assert any("no record after shock" in text for text in outcome.warnings)


def test_pulses_are_found_and_leave_nothing(fmu: GyroFmu) -> None:
    device = replace(QUIET, pickoff_gain_per_acceleration=1e-7)
    bench = Bench(fmu, device, step=1e-3)
    log = bench.run([PowerOn(SHOCK, SHOCK, make_shock_programme(bench))])[0].log
    pulses = find_pulses(log, device.site)
    assert [p.axis for p in pulses] == [s + a for a in "xyz" for s in "+-" for _ in range(3)]
    assert all(pulse.valid for pulse in pulses)
    assert max(abs(pulse.kept) for pulse in pulses) < 0.05 * ARCSEC
    readings = read_quiet_changes(log, device.site)
    assert len(readings) == 13
    assert max(map(abs, readings)) < 0.05 * ARCSEC
    assert max(p.swing for p in pulses[:6]) > 10 * max(p.swing for p in pulses[6:])


def test_one_position_is_an_error(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    course = bench.programme().rest(900.0)
    tests = bench.run([PowerOn("fixed", BEFORE, course), PowerOn("other", "after_shock", course)])
    with pytest.raises(BenchError, match=r"fixed: \d+ data points at pattern angles"):
        vibration_shock.evaluate(bench.campaign(tests))


def test_nothing_to_compare_is_an_error(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    with pytest.raises(BenchError, match="no test of kind before_vibration"):
        vibration_shock.evaluate(bench.campaign([]))
