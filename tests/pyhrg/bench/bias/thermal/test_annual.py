"""A year of a gyro that loses its decay time."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.intervals._environment import FAST
from benchmarks.intervals.annual import truths
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.thermal import annual
from pyhrg.bench.bias.thermal.annual import AGEING, MONTH, age_device
from pyhrg.bench.outcome import BenchError
from pyhrg.common.units import YEAR
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from tests.pyhrg.bench.cases import QUIET


def test_drift_is_that_of_the_decay_time(slow_fmu: GyroFmu) -> None:
    device = replace(QUIET, model={**FAST, AGEING: 0.1 / YEAR})
    bench = Bench(slow_fmu, device, step=1.0)
    outcome = annual.evaluate(bench.campaign(annual.record(bench)))
    expected = truths(device)
    for name in ("bias drift", "scale factor drift"):
        assert outcome.finding(name).si_value == pytest.approx(expected[name], rel=0.01)


def test_no_ageing_no_drift(slow_fmu: GyroFmu) -> None:
    """Negative control; 2 x the 95 % interval."""
    bench = Bench(slow_fmu, replace(TYPICAL, model=FAST), step=1.0)
    outcome = annual.evaluate(bench.campaign(annual.record(bench)))
    for name in ("bias drift", "scale factor drift"):
        found = outcome.finding(name)
        assert abs(found.si_value) < found.si_high - found.si_low


def test_three_months_are_an_error(slow_fmu: GyroFmu) -> None:
    bench = Bench(slow_fmu, replace(QUIET, model=FAST), step=1.0)
    tests = annual.record(bench)[:3]
    with pytest.raises(BenchError, match="3 monthly tests; a year needs at least 4"):
        annual.evaluate(bench.campaign(tests))


def test_aged_gyro_keeps_the_share_of_its_decay_time() -> None:
    device = replace(QUIET, model={AGEING: 0.03 / YEAR})
    expected = device.decay_time * np.exp(-0.03)
    assert age_device(device, 12 * MONTH).decay_time == pytest.approx(expected)
