"""Sizes of plans are computed before memory is taken."""

import pytest

from pyhrg.bench.bench import MAX_TEST_ROWS, Bench, PowerOn
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.programme import MAX_ROWS, Programme
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu


@pytest.mark.parametrize("duration", [MAX_ROWS + 1, 2.0**63, 1e300])
def test_a_long_rest_is_refused(duration: float) -> None:
    with pytest.raises(BenchError, match=f"expected at most {MAX_ROWS} rows of 1 s"):
        Programme(1.0, 9.8).rest(duration)


def test_many_rests_are_refused() -> None:
    programme = Programme(1.0, 9.8).rest(MAX_ROWS - 1)
    with pytest.raises(BenchError, match="expected at most"):
        programme.rest(2)


def test_many_power_ons_are_refused(fmu: GyroFmu) -> None:
    course = Programme(1.0, 9.8).rest(1000)
    power_ons = [PowerOn(str(i), "static", course) for i in range(MAX_TEST_ROWS // 1000 + 1)]
    with pytest.raises(BenchError, match="2001 power-ons with 2001000 rows: expected at most"):
        Bench(fmu, TYPICAL).run(power_ons)


@pytest.mark.parametrize(
    "plan", [{"positions": 8 * 10**9}, {"runs": 8 * 10**9}, {"dwell_s": 9.2e18}, {"runs": 0}]
)
def test_a_large_plan_is_refused(plan: dict[str, float], fmu: GyroFmu) -> None:
    with pytest.raises(BenchError, match="expected"):
        full_circumference.record(Bench(fmu, TYPICAL), **plan)
