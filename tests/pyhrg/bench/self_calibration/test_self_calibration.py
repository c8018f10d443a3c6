"""Self-calibration: what virtual rotation averages, what it costs, and what can't show it."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.intervals.self_calibration import repeat
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.self_calibration.cycles import find_sweeps
from pyhrg.bench.self_calibration.self_calibration import ROTATION, evaluate, record
from pyhrg.common.site import Site
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H, PPM
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign
from pyhrg.theory import closed_forms as theory
from tests.pyhrg.bench.cases import QUIET, slow_bench

NOISE = {"noise.virtualRotation": 1e-3 * DEG_PER_SQRT_H / ROTATION}
"""Of the rotation: an angle random walk of 1e-3 deg/sqrt(h), ten times the typical gyro's."""


def campaign_of(fmu: GyroFmu, device: Device, runs: int = 2) -> Campaign:
    bench = slow_bench(fmu, device)
    return bench.campaign(record(bench, runs, count=2))


@pytest.fixture(scope="module")
def campaign(slow_fmu: GyroFmu) -> Campaign:
    return campaign_of(slow_fmu, replace(TYPICAL, model=NOISE), runs=4)


@pytest.fixture(scope="module")
def outcome(campaign: Campaign) -> Outcome:
    return evaluate(campaign)


def test_cycle_is_the_mean_over_the_circumference(slow_fmu: GyroFmu) -> None:
    """Without noise: harmonics and the gain error of the rotation average out, at any angle; what
    is held for a control period lags the rotation as it lags the scale factor."""
    device = replace(
        QUIET, demodulation_offset=3e-5, virtual_rotation_error=2e-4, bryan_factor_error=5e-6
    )
    outcome = evaluate(campaign_of(slow_fmu, device))
    hold = theory.hold_scale_factor_error(1e-3, 0.0, device.decay_time)
    expected = theory.mean_bias(device)
    assert outcome.finding("bias on").si_value == pytest.approx(expected, abs=1e-4 * DEG_PER_H)
    for name, value in (
        ("virtual rotation gain error", 2e-4 + hold),
        ("scale factor error on", 5e-6 + hold),
        ("scale factor error off", 5e-6 + hold),
    ):
        assert outcome.finding(name).si_value == pytest.approx(value, abs=0.05 * PPM)


def test_repeatability_over_angles_is_gained(outcome: Outcome) -> None:
    on, off = (outcome.finding(f"bias repeatability {x}") for x in ("on", "off"))
    assert off.si_low > 5 * on.si_high


def test_random_walk_is_lost(outcome: Outcome) -> None:
    """The paper's order of magnitude, for a rotation with that noise."""
    ratio = outcome.finding("random walk on over off")
    assert ratio.si_low < np.hypot(10, 1) < ratio.si_high
    assert ratio.si_high / ratio.si_low < 1.2


def test_rotation_without_noise_costs_nothing(slow_fmu: GyroFmu) -> None:
    """Negative control: 1 within twice the interval, 3.9 standard deviations."""
    plain = replace(TYPICAL, model={})
    ratio = evaluate(campaign_of(slow_fmu, plain)).finding("random walk on over off")
    assert abs(ratio.si_value - 1) < ratio.si_high - ratio.si_low


def test_one_way_alone_is_refused(campaign: Campaign) -> None:
    """A log cut before the rotation is reversed."""
    test = next(t for t in campaign.tests if np.any(t.log.virtual_rotation))
    kept = int(np.argmax(test.log.virtual_rotation < 0))
    cut = {
        name: value[:kept] if isinstance(value, np.ndarray) else value
        for name, value in vars(test.log).items()
    }
    log = replace(test.log, **cut)
    with pytest.raises(BenchError, match="one way and back"):
        evaluate(replace(campaign, tests=(replace(test, recording=log),)))


def test_nothing_to_compare_with_is_refused(campaign: Campaign) -> None:
    on = tuple(t for t in campaign.tests if np.any(t.log.virtual_rotation))
    with pytest.raises(BenchError, match="without virtual rotation"):
        evaluate(replace(campaign, tests=on))


def test_no_rotation_is_refused(campaign: Campaign) -> None:
    off = tuple(t for t in campaign.tests if not np.any(t.log.virtual_rotation))
    with pytest.raises(BenchError, match="no virtual rotation"):
        evaluate(replace(campaign, tests=off))


def test_invalid_rows_are_in_no_sweep(campaign: Campaign) -> None:
    log = next(t.log for t in campaign.tests if np.any(t.log.virtual_rotation))
    valid = log.valid.copy()
    valid[500:510] = 0.0
    whole, broken = (len(find_sweeps(x, campaign.site)) for x in (log, replace(log, valid=valid)))
    assert broken == whole + 1
    spans = [(s.time[0], s.time[-1]) for s in find_sweeps(replace(log, valid=valid), Site())]
    assert not any(begin < 505 < end for begin, end in spans)


def test_intervals_hold_what_was_put_in(slow_fmu: GyroFmu) -> None:
    """Of 90 intervals 85.5 on average, some of them of one noise: 5 binomial deviations below."""
    inside = [
        low <= value <= high for s in range(10) for value, low, high in repeat(slow_fmu, s).values()
    ]
    assert len(inside) == 90
    assert sum(inside) >= 75
