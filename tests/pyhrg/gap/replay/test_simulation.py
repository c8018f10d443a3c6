"""Replays of logs that the bench made without noise: nothing is left, in any channel."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Programme
from pyhrg.common.units import DEG, DEG_PER_H, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.sensitivities import linear_test, secants
from pyhrg.gap.replay.free_pattern import steady
from pyhrg.gap.replay.loop_response import followed, let_go
from pyhrg.gap.replay.observations import CHANNELS, observed, settling
from pyhrg.gap.replay.replay import start_angle
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import RESOLVED
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.soundness.conftest import BELIEVED
from tests.pyhrg.records.made_up import made_up_log

QUIET = replace(BELIEVED.without_noise(), phase_error=5e-3, pickoff_gain_mismatch=1e-3)
SAMPLED = {**RESOLVED, "gyro_angle": 1e-8}
"""What sampled loops leave, SI: a command within a period, the table's rate within a row."""
FOLLOWING = {**RESOLVED, "gyro_angle": 1e-7}


def logged(simulation: Simulation, device: Device, programme: Programme, angle: float) -> Test:
    bench = Bench(simulation.sampled, device)
    (test,) = bench.run([PowerOn("test", "static", programme, start_angle=angle)])
    return test


def check(
    simulation: Simulation, device: Device, test: Test, most: dict[str, float], moves: bool
) -> None:
    seen = observed(test, device)
    at_rest = test.log.time > settling(device) + test.log.interval
    assert seen.moving[at_rest].any() == moves
    answers = simulation.answers(device, seen)
    for name in CHANNELS:
        left = np.abs(getattr(test.log, name) - answers[name])[seen.rows[name]]
        assert left.max() < most[name], name


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
    test = logged(simulation, QUIET, given, angle=0.3)
    assert start_angle(test.log, QUIET.bryan_factor) == pytest.approx(0.3, abs=1e-5)
    check(simulation, QUIET, test, SAMPLED, moves=True)


@pytest.mark.parametrize("command", COMMANDS, ids=str)
def test_commands_after_a_long_rest(simulation: Simulation, command: dict[str, float]) -> None:
    given = programme().rest(100).command(**command).rest(40)
    test = logged(simulation, QUIET, given, angle=0.3)
    check(simulation, QUIET, test, SAMPLED, moves=True)


def test_a_table_that_turns_slowly_all_the_time(simulation: Simulation) -> None:
    """Loops that lag lose more and more of the angle."""
    given = programme().rest(30).spin(1 * DEG, 600).spin(0.2 * DEG, 600)
    test = logged(simulation, QUIET, given, angle=0.3)
    check(simulation, QUIET, test, FOLLOWING, moves=True)


@pytest.mark.parametrize("interval", [0.25, 0.35, 2.5])
def test_rows_of_any_length(simulation: Simulation, interval: float) -> None:
    given = programme(interval).rest(100 * interval).turn(60 * DEG, 10 * DEG).rest(100 * interval)
    device = replace(QUIET, frequency_split=5e-3)
    test = logged(simulation, device, given, angle=-0.2)
    check(simulation, device, test, {**FOLLOWING, "amplitude_force": 1e-7}, moves=True)


@pytest.mark.parametrize("interval", [0.1, 1.0])
def test_turns_of_the_table(simulation: Simulation, interval: float) -> None:
    given = programme(interval).rest(30).turn(60 * DEG, 10 * DEG).rest(30)
    test = logged(simulation, QUIET, given, angle=-0.2)
    bent = {"amplitude_force": 1e-7, "quadrature_force": 3e-8}  # by a rate that bends within a row
    seen = {**SAMPLED, **bent}
    check(simulation, QUIET, test, seen, moves=True)


@pytest.mark.parametrize("loop", [2.0, 6.0, 20.0])
def test_power_on_and_rest(simulation: Simulation, loop: float) -> None:
    device = replace(QUIET, amplitude_loop=loop, quadrature_loop=loop, phase_loop=100.0)
    test = logged(simulation, device, programme().rest(60).attitude(-1.0).rest(60), angle=0.5)
    check(simulation, device, test, FOLLOWING, moves=False)


def test_forces_are_those_of_the_pattern_that_power_on_left_turned(simulation: Simulation) -> None:
    """While slow loops come to rest, a split of 0.6 mHz turns the pattern by some 0.1 urad: its
    quadrature force is another by 1e-9 /s ever after."""
    device = replace(BELIEVED.without_noise(), quadrature_loop=3.0, frequency_split=4e-3)
    test = logged(simulation, device, programme().rest(120), angle=0.5)
    seen = observed(test, device)
    rows = seen.rows["quadrature_force"]
    left = test.log.quadrature_force - simulation.answers(device, seen)["quadrature_force"]
    assert np.abs(left[rows]).max() < 1e-10


@pytest.mark.parametrize("loop", [2.0, 6.0])
def test_warming(simulation: Simulation, loop: float) -> None:
    """Loops lag a frequency and a decay time that drift; temperature itself comes 10 ms late."""
    device = replace(QUIET, amplitude_loop=loop, phase_loop=100.0)
    given = programme(2.0).rest(20).heat(QUIET.reference_temperature + 20, 200).rest(60)
    test = logged(simulation, device, given, angle=0.5)
    check(simulation, device, test, FOLLOWING | {"frequency_offset": 3e-3}, moves=False)


def test_a_thermometer_off_by_little_is_no_rate_of_temperature(simulation: Simulation) -> None:
    """At power-on the case is where it is: it doesn't come from the reference temperature."""
    given = programme(0.1).command(amplitude_setpoint=0.6).rest(30)
    test = logged(simulation, QUIET, given, angle=0.3)
    warm = replace(test.log, temperature=test.log.temperature + 0.1)
    seen = observed(replace(test, recording=warm), QUIET)
    effect = EFFECTS["temperature_rate_bias"]
    moved = secants(simulation, QUIET, seen, [effect])[effect]["gyro_angle"]
    np.testing.assert_allclose(moved, 0.0, atol=1e-12)


def test_secants_hold_for_effects_of_few_deviations(simulation: Simulation) -> None:
    """A phase error turns the pattern, and with it the forces, the longer the further; the change
    by secants is the change of so small an effect all the same, to a percent."""
    device = replace(QUIET, phase_error=0.0)
    seen = observed(Test("test", "static", "fit", made_up_log(20000, noise=0.0)), device)
    effect, size = EFFECTS["demodulation_phase_error"], 1e-5
    change = simulation.changes(device, seen)(effect.put(device, np.array([size])))
    told = secants(simulation, device, seen, [effect])[effect]
    for name in ("gyro_angle", "quadrature_force"):
        largest = np.abs(change[name]).max()
        np.testing.assert_allclose(told[name][:, 0] * size, change[name], atol=0.01 * largest)


def test_a_free_pattern_is_simulated_no_further_than_it_is_compared(
    simulation: Simulation,
) -> None:
    """With this split and a hard spring its ellipse becomes a circle: the pattern has no angle."""
    device = replace(QUIET, phase_error=0.0, pickoff_gain_mismatch=0.0, frequency_split=3.9e-3)
    circling = replace(device, decay_time=422.0, stiffness_axis=1.1466813185602747)
    given = programme().rest(20).command(drive_on=0.0).rest(420)
    seen = observed(logged(simulation, circling, given, angle=0.0284), circling)
    kept = steady(simulation, circling, seen)
    assert 20 < len(kept.log.time) < 440
    assert all(len(rows) == len(kept.log.time) for rows in kept.rows.values())
    effect = EFFECTS["duffing_stiffness"]
    moved = secants(simulation, circling, kept, [effect])[effect]
    assert all(np.isfinite(values).all() for values in moved.values())


def test_loops_follow_a_step_and_a_ramp() -> None:
    """(2 w s + w^2)/(s + w)^2 and s/(s + w)^2 of a ramp in closed form."""
    w, time = 2.0, np.arange(0, 20, 0.1)
    np.testing.assert_allclose(followed(np.full(50, 3.0), w, 0.1), 3.0)
    ramp = followed(time, w, 0.1)
    np.testing.assert_allclose(ramp, time - time * np.exp(-w * time), atol=1e-9)
    let = (1 - np.exp(-w * time) * (1 + w * time)) / w**2
    np.testing.assert_allclose(let_go(time, w, 0.1), let, atol=1e-9)


def test_forces_of_a_pattern_that_walked_far_away(simulation: Simulation) -> None:
    """Half a degree from where the simulation has it, the quadrature force bends with the angle."""
    believed = replace(QUIET, frequency_split=1e-3)
    walks = replace(believed, bias_per_acceleration=20 * DEG_PER_H / STANDARD_GRAVITY)
    test = observed(logged(simulation, walks, programme().rest(400), angle=0.3), believed)
    answers = simulation.answers(believed, test)
    part = linear_test(simulation, believed, believed, test, answers, {})
    turned, force = (
        (getattr(test.log, name) - answers[name])[:, None]
        for name in ("gyro_angle", "quadrature_force")
    )
    rows = test.rows["quadrature_force"]
    straight = part.at_measured_angle(force, turned, "quadrature_force")[rows]
    bent = part.at_measured_angle(
        part.residual["quadrature_force"][:, None], turned, "quadrature_force"
    )[rows]
    assert np.ptp(straight) > 10 * RESOLVED["quadrature_force"]
    assert np.ptp(bent) < 0.1 * np.ptp(straight)


def test_small_differences_show_how_loops_follow_a_fast_table(simulation: Simulation) -> None:
    """A gain mismatch ripples the amplitude as the pattern turns; at 100 deg/s loop forces are
    those of running loops, to a percent: a lag of 60 ms was an eighth of them."""
    given = programme(0.1).rest(5).spin(100 * DEG, 20).rest(5)
    seen = observed(logged(simulation, QUIET, given, angle=0.3), QUIET)
    effect = EFFECTS["pickoff_gain_mismatch"]
    other = effect.put(QUIET, effect.vector(QUIET) + 1e-5)
    small = simulation.difference(QUIET, other, seen)
    whole = [simulation.answers(device, seen) for device in (QUIET, other)]
    for name in ("amplitude", "amplitude_force", "quadrature_force"):
        rows = seen.rows[name]
        expected = (whole[1][name] - whole[0][name])[rows]
        np.testing.assert_allclose(
            small[name][rows], expected, atol=0.01 * np.abs(expected).max(), err_msg=name
        )
