"""What parking buys: reproducible, against closed form, and with a negative control."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.mission_model.missions import STILL
from ins_eval.parking.gyro import ANGLES, CASES, Known, Start, fly_together, measure_maps
from ins_eval.parking.mission import INTERVAL
from ins_eval.parking.study import Comparison, compare, compare_with_first_case
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.full_circumference import SHORTEST
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records.imu.log import Increments
from pyhrg.theory import closed_forms as theory
from tests.ins_eval.cases import short_mission

NAMES = [case.name for case in CASES]


@pytest.fixture(scope="module")
def typical(fmu_path: Path) -> Comparison:
    """Three triads, 0.1 h, seed 2."""
    return compare(fmu_path, short_mission(0.1), 3, 2, plan=SHORTEST)


def test_same_seed_same_result_on_any_number_of_workers(
    fmu_path: Path, typical: Comparison
) -> None:
    """The first triad of the three, by itself."""
    again = compare(fmu_path, short_mission(0.1), 1, 2, plan=SHORTEST, workers=1)
    for name in ("radial", "heading", "ready", "start_up"):
        assert np.array_equal(getattr(again, name), getattr(typical, name)[:, :1]), name


def test_knowing_more_buys_more(typical: Comparison) -> None:
    """Every case's interval lies below the first case's, and whole maps are best."""
    found = dict(zip(NAMES, compare_with_first_case(typical.final), strict=True))
    assert found["random_mean"].value == 1
    for name in ("random_at_start", "flat_at_start", "map"):
        assert found[name].high < 1, name
    assert found["flat_at_start"].value < found["zero_mean"].value
    assert found["map"].value == min(ratio.value for ratio in found.values())


def test_without_anisotropy_parking_buys_nothing(fmu_path: Path) -> None:
    """Negative control, seed 2: the map is the calibration's noise."""
    device = TYPICAL.without_anisotropy()
    result = compare(fmu_path, short_mission(0.1), 3, 2, device=device, plan=SHORTEST)
    parked = compare_with_first_case(result.final)[NAMES.index("zero_mean")]
    assert parked.low <= 1 <= parked.high


def test_alignment_waits_for_the_gyros(typical: Comparison) -> None:
    """While the amplitude grows, output counts as valid and is wrong; before, more so."""
    running, ready, valid, power_on = (np.sqrt(np.mean(e**2)) for e in typical.start_up)
    assert ready < 3 * running
    assert valid > 30 * ready
    assert power_on > valid
    assert np.all((typical.ready > 10.0) & (typical.ready < 12.0))


@pytest.mark.parametrize("start", [Start.ZERO, Start.FLAT])
def test_gyro_is_parked_where_its_true_map_says_so(fmu: GyroFmu, start: Start) -> None:
    """Bias at rest against theory, though the map was measured and the angle scatters by 0.5 deg.

    Bound: three deviations of that scatter, on the steepest slope, and of the mean over 280 s.
    """
    gyro = measure_maps(Bench(fmu, TYPICAL, seed=8))
    rest = np.zeros((round(STILL / INTERVAL), 3))
    angle = ANGLES[start](gyro.bias)
    truth = Increments(INTERVAL, rest, rest, -STILL)
    (flight,) = fly_together([gyro.set_up(angle, with_maps=False)], [0], truth)
    parked = float(flight.pattern_angle[-1])
    amplitude = theory.lock_rate(TYPICAL)
    away = float(theory.static_bias(TYPICAL, parked)) - theory.mean_bias(TYPICAL)
    scatter = 3 * 4 * TYPICAL.power_on_scatter
    expected = 0.0 if start is Start.ZERO else amplitude
    assert abs(away) == pytest.approx(expected, abs=amplitude * scatter)
    measured = flight.rotation[2000:].sum() / (len(flight.rotation) - 2000) / INTERVAL
    known = gyro.compute_known_bias(Known.AT_START, parked)
    assert measured == pytest.approx(known, abs=0.002 * DEG_PER_H)
