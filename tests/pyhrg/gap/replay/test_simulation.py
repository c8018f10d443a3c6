"""Replays of noise-free logs of the bench agree with the logs in every channel."""

import re
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Programme
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H, STANDARD_GRAVITY, ZERO_CELSIUS
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.sensitivities import compute_sensitivities, linearize_test
from pyhrg.gap.preparation import describe_preparation
from pyhrg.gap.replay.free_pattern import truncate_free_pattern
from pyhrg.gap.replay.inputs.inputs import estimate_start_angle
from pyhrg.gap.replay.loop_response import compute_loop_error, compute_loop_force
from pyhrg.gap.replay.observations import (
    CHANNELS,
    FINE_ROW,
    compute_settling_time,
    observe_test,
)
from pyhrg.gap.replay.sampled import replay_sampled
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import REPLAY_RESOLUTION
from pyhrg.records import COLUMNS
from pyhrg.records.campaign import Campaign, Test
from tests.pyhrg.gap.bench import stated
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.records.made_up import made_up_log

QUIET = replace(NOMINAL.without_noise(), phase_error=5e-3, pickoff_gain_mismatch=1e-3)
SAMPLED = {**REPLAY_RESOLUTION, "gyro_angle": 1e-8}
"""Largest residual with sampled loops, SI. It stems from the time of a command within a control
period, and from the table's rate within a row."""
FOLLOWING = {**REPLAY_RESOLUTION, "gyro_angle": 1e-7}
"""Largest residual where loops follow a slow change, SI."""


def record_log(simulation: Simulation, device: Device, programme: Programme, angle: float) -> Test:
    bench = Bench(simulation.sampled, device)
    (test,) = bench.run([PowerOn("test", "static", programme, start_angle=angle)])
    return test


def assert_agreement(
    simulation: Simulation,
    device: Device,
    test: Test,
    tolerance: dict[str, float],
    is_transient: bool,
) -> None:
    observed = observe_test(test, device)
    at_rest = test.log.time > compute_settling_time(device) + test.log.interval
    assert observed.transient[at_rest].any() == is_transient
    answers = simulation.simulate(device, observed)
    for name in CHANNELS:
        residual = np.abs(getattr(test.log, name) - answers[name])[observed.rows[name]]
        assert residual.max() < tolerance[name], name


def programme(interval: float = 1.0) -> Programme:
    return Bench.programme(Bench(None, QUIET), interval)  # type: ignore[arg-type]


COMMANDS = [
    {"drive_on": 0.0},
    {"virtual_rotation": 1 * DEG},
    {"amplitude_setpoint": 0.9},
    {"phase_offset": 0.05},
    {"phase_offset": 2e-3},
]


@pytest.mark.parametrize("command", COMMANDS, ids=str)
def test_commands(simulation: Simulation, command: dict[str, float]) -> None:
    given = programme().rest(30).command(**command).rest(40)
    test = record_log(simulation, QUIET, given, angle=0.3)
    assert estimate_start_angle(test.log, QUIET.bryan_factor) == pytest.approx(0.3, abs=1e-5)
    assert_agreement(simulation, QUIET, test, SAMPLED, is_transient=True)


@pytest.mark.parametrize("command", COMMANDS, ids=str)
def test_commands_after_a_long_rest(simulation: Simulation, command: dict[str, float]) -> None:
    given = programme().rest(100).command(**command).rest(40)
    test = record_log(simulation, QUIET, given, angle=0.3)
    assert_agreement(simulation, QUIET, test, SAMPLED, is_transient=True)


def test_a_table_that_turns_slowly_all_the_time(simulation: Simulation) -> None:
    """Lagging loops change the angle more and more."""
    given = programme().rest(30).spin(1 * DEG, 600).spin(0.2 * DEG, 600)
    test = record_log(simulation, QUIET, given, angle=0.3)
    assert_agreement(simulation, QUIET, test, FOLLOWING, is_transient=True)


@pytest.mark.parametrize("interval", [0.25, 0.35, 2.5])
def test_rows_of_any_length(simulation: Simulation, interval: float) -> None:
    given = programme(interval).rest(100 * interval).turn(60 * DEG, 10 * DEG).rest(100 * interval)
    device = replace(QUIET, frequency_split=5e-3)
    test = record_log(simulation, device, given, angle=-0.2)
    assert_agreement(
        simulation, device, test, {**FOLLOWING, "amplitude_force": 1e-7}, is_transient=True
    )


@pytest.mark.parametrize("interval", [0.1, 1.0])
def test_turns_of_the_table(simulation: Simulation, interval: float) -> None:
    given = programme(interval).rest(30).turn(60 * DEG, 10 * DEG).rest(30)
    test = record_log(simulation, QUIET, given, angle=-0.2)
    bend = {"amplitude_force": 1e-7, "quadrature_force": 3e-8}  # the rate bends within a row
    tolerance = {**SAMPLED, **bend}
    assert_agreement(simulation, QUIET, test, tolerance, is_transient=True)


@pytest.mark.parametrize("loop", [2.0, 6.0, 20.0])
def test_power_on_and_rest(simulation: Simulation, loop: float) -> None:
    device = replace(QUIET, amplitude_loop=loop, quadrature_loop=loop, phase_loop=100.0)
    test = record_log(simulation, device, programme().rest(60).attitude(-1.0).rest(60), angle=0.5)
    assert_agreement(simulation, device, test, FOLLOWING, is_transient=False)


def test_forces_are_those_at_the_angle_after_power_on(simulation: Simulation) -> None:
    """While slow loops settle, a split of 0.6 mHz turns the pattern by about 0.1 urad. Its
    quadrature force then differs by 1e-9 /s for the rest of the test."""
    device = replace(NOMINAL.without_noise(), quadrature_loop=3.0, frequency_split=4e-3)
    test = record_log(simulation, device, programme().rest(120), angle=0.5)
    observed = observe_test(test, device)
    rows = observed.rows["quadrature_force"]
    residual = test.log.quadrature_force - simulation.simulate(device, observed)["quadrature_force"]
    assert np.abs(residual[rows]).max() < 1e-10


@pytest.mark.parametrize("loop", [2.0, 6.0])
def test_warming(simulation: Simulation, loop: float) -> None:
    """Loops lag a drifting frequency and decay time; the temperature itself is 10 ms late."""
    device = replace(QUIET, amplitude_loop=loop, phase_loop=100.0)
    given = programme(2.0).rest(20).heat(QUIET.reference_temperature + 20, 200).rest(60)
    test = record_log(simulation, device, given, angle=0.5)
    assert_agreement(
        simulation, device, test, FOLLOWING | {"frequency_offset": 1e-3}, is_transient=False
    )


def test_a_log_may_begin_with_a_settled_resonator(simulation: Simulation) -> None:
    """Ten thermal lags at 10 K above the reference, of which the log has the last: 10 K times e^-9
    are left to settle. The log from power-on begins at the reference."""
    device = replace(QUIET, frequency_per_kelvin=8.5e-5, decay_time_per_kelvin=-3e-3)
    warm = device.reference_temperature + 10
    given = programme(10.0).heat(warm, 100).rest(10 * device.thermal_lag)
    bench = Bench(simulation.quasi_steady, device)
    (test,) = bench.run([PowerOn("test", "static", given, start_angle=0.3)])
    cut = {c.field: getattr(test.log, c.field)[-60:] for c in COLUMNS}
    cut["time"] = test.log.time[:60]
    cut["gyro_angle"] = cut["gyro_angle"] - test.log.gyro_angle[-61]
    cut["table_angle"] = cut["table_angle"] - test.log.table_angle[-61]
    later = Test("later", "static", "fit", replace(test.log, **cut))
    assert not observe_test(test, device).inputs.is_soaked
    observed = observe_test(later, device)
    assert observed.inputs.is_soaked
    answer = simulation.simulate(device, observed)["frequency_offset"]
    error = np.abs(later.log.frequency_offset - answer)[observed.rows["frequency_offset"]]
    assert error.max() < 10 * np.exp(-9) * device.frequency * device.frequency_per_kelvin
    campaign = Campaign("made up", device.site, stated(device), (test, later))
    (sentence,) = re.findall(r"\w+: the resonator had settled.*", describe_preparation(campaign))
    assert sentence.startswith(f"later: the resonator had settled to {warm - ZERO_CELSIUS:.1f}")
    unknown = replace(later.log, frequency_offset=np.full(60, np.nan))
    assert not observe_test(Test("", "static", "fit", unknown), device).inputs.is_soaked


def test_a_thermometer_offset_is_no_temperature_rate(simulation: Simulation) -> None:
    """At power-on the case is at the logged temperature; it does not start at the reference."""
    given = programme(0.1).command(amplitude_setpoint=0.6).rest(30)
    test = record_log(simulation, QUIET, given, angle=0.3)
    warm = replace(test.log, temperature=test.log.temperature + 0.1)
    observed = observe_test(replace(test, recording=warm), QUIET)
    effect = EFFECTS["temperature_rate_bias"]
    moved = compute_sensitivities(simulation, QUIET, observed, [effect])[effect]["gyro_angle"]
    np.testing.assert_allclose(moved, 0.0, atol=1e-12)


def test_sensitivities_hold_for_small_effects(simulation: Simulation) -> None:
    """A phase error turns the pattern, and with it the forces, more and more with time. The
    sensitivity still gives the change by a small error, to a percent."""
    device = replace(QUIET, phase_error=0.0)
    observed = observe_test(Test("test", "static", "fit", made_up_log(20000, noise=0.0)), device)
    effect, size = EFFECTS["demodulation_phase_error"], 1e-5
    other = effect.put(device, np.array([size]))
    (change,) = simulation.compute_differences(device, [other], observed)
    predicted = compute_sensitivities(simulation, device, observed, [effect])[effect]
    for name in ("gyro_angle", "quadrature_force"):
        largest = np.abs(change[name]).max()
        np.testing.assert_allclose(predicted[name][:, 0] * size, change[name], atol=0.01 * largest)


def test_a_resonator_warms_the_same_in_steps_of_any_length(simulation: Simulation) -> None:
    """Sensitivities run in steps of 1 s. While the resonator led by one, a search followed that."""
    device = replace(QUIET, frequency_per_kelvin=8.5e-5, decay_time_per_kelvin=-3e-3)
    test = record_log(simulation, QUIET, programme().rest(600), angle=0.3)
    observed = observe_test(test, device)
    effect, size = EFFECTS["thermometer_offset"], 0.05
    (predicted,) = compute_sensitivities(simulation, device, observed, [effect]).values()
    warm, cold = (
        simulation.simulate(effect.put(device, np.array([offset])), observed)
        for offset in (size, 0.0)
    )
    for name in ("frequency_offset", "amplitude_force"):
        change, rows = warm[name] - cold[name], observed.rows[name]
        error = np.abs(predicted[name][:, 0] * size - change)[rows]
        assert error.max() < 1e-4 * np.abs(change).max(), name


def test_a_free_pattern_is_simulated_only_where_it_is_compared(
    simulation: Simulation,
) -> None:
    """This split with a hardening spring leads to circular motion, whose pattern has no angle."""
    device = replace(QUIET, phase_error=0.0, pickoff_gain_mismatch=0.0, frequency_split=3.9e-3)
    circling = replace(device, decay_time=422.0, stiffness_axis=1.1466813185602747)
    given = programme().rest(20).command(drive_on=0.0).rest(420)
    observed = observe_test(record_log(simulation, circling, given, angle=0.0284), circling)
    kept = truncate_free_pattern(simulation, circling, observed)
    assert 20 < len(kept.log.time) < 440
    assert all(len(rows) == len(kept.log.time) for rows in kept.rows.values())
    effect = EFFECTS["duffing_stiffness"]
    moved = compute_sensitivities(simulation, circling, kept, [effect])[effect]
    assert all(np.isfinite(values).all() for values in moved.values())


def test_the_loop_response_to_a_step_and_a_ramp() -> None:
    """Against the closed forms of (2 w s + w^2)/(s + w)^2 and s/(s + w)^2."""
    w, time = 2.0, np.arange(0, 20, 0.1)
    np.testing.assert_allclose(compute_loop_force(np.full(50, 3.0), w, 0.1), 3.0)
    ramp = compute_loop_force(time, w, 0.1)
    np.testing.assert_allclose(ramp, time - time * np.exp(-w * time), atol=1e-9)
    let = (1 - np.exp(-w * time) * (1 + w * time)) / w**2
    np.testing.assert_allclose(compute_loop_error(time, w, 0.1), let, atol=1e-9)


def compare_walked_force(simulation: Simulation, interval: float) -> tuple[Array, Array]:
    """(m,) residuals of the quadrature force, to first order and in full, in rows of `interval`
    seconds, of a pattern that walks half a degree away."""
    nominal = replace(QUIET, frequency_split=1e-3)
    walks = replace(nominal, bias_per_acceleration=20 * DEG_PER_H / STANDARD_GRAVITY)
    log = record_log(simulation, walks, programme(interval).rest(400), angle=0.3)
    test = observe_test(log, nominal)
    answers = simulation.simulate(nominal, test)
    part = linearize_test(simulation, nominal, nominal, test, answers, {})
    name, rows = "quadrature_force", test.rows["quadrature_force"]
    turned, force = (
        (getattr(test.log, n) - answers[n])[:, None] for n in ("gyro_angle", "quadrature_force")
    )
    in_full = part.residual[name][:, None]
    first, full = (part.at_measured_angle(f, turned, name)[rows, 0] for f in (force, in_full))
    return first, full


def test_forces_of_a_pattern_that_walked_far_away(simulation: Simulation) -> None:
    """The quadrature force depends on the angle to second order."""
    first_order, second_order = compare_walked_force(simulation, 1.0)
    assert np.ptp(first_order) > 10 * REPLAY_RESOLUTION["quadrature_force"]
    assert np.ptp(second_order) < 0.1 * np.ptp(first_order)


def test_means_over_rows_belong_to_the_mean_angle(simulation: Simulation) -> None:
    """While the pattern walks, long rows show the same force as short ones."""
    short, long = (np.mean(compare_walked_force(simulation, t)[1]) for t in (1.0, 10.0))
    assert long == pytest.approx(short, abs=REPLAY_RESOLUTION["quadrature_force"])


TURNS = {
    "a fast table": (programme(0.1).rest(5).spin(100 * DEG, 20).rest(5), 0.01),
    "a slow table": (programme(0.5).rest(30).spin(5 * DEG, 60), 0.15),
    "a commanded rotation": (programme().rest(30).command(virtual_rotation=5 * DEG).rest(90), 0.2),
}


@pytest.mark.parametrize(("given", "tolerance"), TURNS.values(), ids=TURNS.keys())
def test_a_small_difference_includes_the_loops_of_a_turned_pattern(
    simulation: Simulation, given: Programme, tolerance: float
) -> None:
    """A gain mismatch ripples the true amplitude as the pattern turns, while the loops hold the
    detected one. Forces and amplitude are those of sampled loops. The quasi-steady loops' own lag
    of three steps would leave up to 10,000 times their amplitude."""
    observed = observe_test(record_log(simulation, QUIET, given, angle=0.3), QUIET)
    effect = EFFECTS["pickoff_gain_mismatch"]
    other = effect.put(QUIET, effect.vector(QUIET) + 1e-5)
    small = simulation.compute_difference(QUIET, other, observed)
    whole = [replay_sampled(simulation.sampled, d, observed.inputs) for d in (QUIET, other)]
    rows = (
        observed.log.time > 60 if observed.log.interval >= FINE_ROW else observed.rows["amplitude"]
    )
    for name in ("amplitude", "amplitude_force", "quadrature_force"):
        expected = (whole[1][name] - whole[0][name])[rows]
        largest = np.abs(expected).max()
        np.testing.assert_allclose(
            small[name][rows], expected, atol=tolerance * largest, err_msg=name
        )
