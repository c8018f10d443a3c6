"""What the two bias tests report of a gyro whose map is known."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg import theory
from pyhrg.bench import fixed_position, full_circumference
from pyhrg.bench.bias_test import BiasRun, BiasTest
from pyhrg.bench.comparison import bias_table
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL
from pyhrg.units import DEG, DEG_PER_H

QUIET = replace(TYPICAL, angle_random_walk=0.0, pickoff_noise=0.0, power_on_scatter=0.0)


@pytest.mark.parametrize("start", [0.0, 5.0, 11.25, 17.0])
def test_full_circumference_does_not_alias(fmu: GyroFmu, start: float) -> None:
    """Its deviation is the map's, whatever the power-on angle: A/sqrt 2, with n - 1 of 8."""
    device = replace(QUIET, power_on_angle=start * DEG)
    run = full_circumference.run(fmu, device, np.random.default_rng(0), segments=1)
    expected = theory.circumferential_bias_stability(device) * np.sqrt(8 / 7)
    assert run.deviation == pytest.approx(expected, rel=0.02)
    assert run.mean == pytest.approx(theory.mean_bias(device), abs=0.002 * DEG_PER_H)


def test_positions_45_degrees_apart_alias(fmu: GyroFmu, monkeypatch: pytest.MonkeyPatch) -> None:
    """The trap that the procedure avoids: anything between 0 and A, by the start angle."""
    monkeypatch.setattr(full_circumference, "PATTERN_STEP", 45 * DEG)
    deviations = []
    for start in (0.0, 5.625, 11.25, 16.875):
        device = replace(QUIET, power_on_angle=start * DEG)
        run = full_circumference.run(fmu, device, np.random.default_rng(0), segments=1)
        deviations.append(run.deviation)
    assert max(deviations) > 2 * min(deviations)


def test_fixed_position_sees_one_point_of_the_map(fmu: GyroFmu) -> None:
    run = fixed_position.run(fmu, QUIET, np.random.default_rng(0))
    assert run.mean == pytest.approx(
        float(theory.static_bias(QUIET, QUIET.power_on_angle)), abs=0.001 * DEG_PER_H
    )
    assert run.deviation < 0.01 * theory.circumferential_bias_stability(QUIET)


def test_power_ons_differ_in_noise_and_angle(fmu: GyroFmu) -> None:
    runs = [fixed_position.run(fmu, TYPICAL, np.random.default_rng(seed)).points for seed in (1, 2)]
    assert not np.any(np.isclose(runs[0], runs[1], rtol=1e-9, atol=0.0))


def test_stability_and_repeatability_are_the_papers() -> None:
    """Stability: mean of the runs' deviations; repeatability: deviation of the runs' means."""
    test = BiasTest((BiasRun(np.array([1.0, 3.0])), BiasRun(np.array([2.0, 6.0]))))
    assert test.stability == pytest.approx((np.sqrt(2) + np.sqrt(8)) / 2)
    assert test.repeatability == pytest.approx(np.sqrt(2))
    assert test.bias == pytest.approx(3.0)


def test_table_holds_every_run() -> None:
    test = BiasTest((BiasRun(np.array([1.0, 3.0]) * DEG_PER_H),) * 2)
    lines = bias_table(test, test).splitlines()
    assert len(lines) == 6
    assert lines[2].split() == ["1", "2.00000", "1.41421", "2.00000", "1.41421"]
    assert lines[4].split() == ["bias", "stability", "1.41421", "1.41421"]
