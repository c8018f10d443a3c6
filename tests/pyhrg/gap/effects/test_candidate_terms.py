"""Candidate terms explain what effects of the catalogue do, should those be missing."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.effects.form import build_reading_columns
from pyhrg.gap.effects.sensitivities import compute_sensitivities
from pyhrg.gap.effects.term_columns import build_term_columns
from pyhrg.gap.replay.observations import observe_test
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import build_angle_noise
from pyhrg.gap.whitening.whitening import whiten
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.records.made_up import made_up_log

ROWS = 600
STARTED = 30.0
"""Time after which loops have forgotten their start, s."""
MAX_UNEXPLAINED = 0.15
"""Share of an effect's power that one term may leave: part of it are biases by the same effect."""
MAX_LEFT = 0.05
"""Share of what an effect makes in a channel that a term of one size in all may leave."""


@pytest.mark.parametrize(
    ("name", "channel", "function"),
    [
        (
            "g_sensitive_gain",
            "gyro_angle",
            "pick-off: harmonic 4 of the pattern angle, times acceleration x",
        ),
        (
            "pickoff_gain_temperature",
            "gyro_angle",
            "pick-off: harmonic 4 of the pattern angle, times the temperature",
        ),
        ("residual_quadrature", "quadrature_force", "mean over the pattern angle"),
    ],
)
def test_a_term_explains_an_effect(
    simulation: Simulation, name: str, channel: str, function: str
) -> None:
    turns = np.arange(ROWS) / ROWS
    log = replace(
        made_up_log(ROWS, noise=0.0),
        acceleration_x=5 * np.sin(4 * np.pi * turns),
        temperature=298.15 + 10 * np.sin(2 * np.pi * turns),
    )
    device = NOMINAL.without_noise()
    observed = observe_test(Test("test", "static", "fit", log), device)
    simulated = simulation.simulate(device, observed)
    where = compute_coordinates(observed, simulated, device)
    effect = EFFECTS[name]
    response = compute_sensitivities(simulation, device, observed, [effect])[effect][channel][:, 0]
    block = next(b for term, b in build_term_columns(where, channel) if term.function == function)
    rows = observed.rows[channel]
    series = np.column_stack([block, response])[rows]
    white = whiten(series, np.diff(log.time[rows], prepend=0.0), build_angle_noise(NOMINAL)).series
    term, effect_itself = white[:, :-1], white[:, -1]
    unexplained = effect_itself - term @ np.linalg.lstsq(term, effect_itself, rcond=None)[0]
    assert unexplained @ unexplained < MAX_UNEXPLAINED * (effect_itself @ effect_itself)


@pytest.mark.parametrize(
    ("name", "channel", "second"),
    [
        ("frequency_split", "quadrature_force", "the time"),
        ("frequency_split", "quadrature_force", "acceleration x"),
        ("frequency_split", "frequency_offset", "the time"),
        ("damping_anisotropy", "amplitude_force", "acceleration x"),
    ],
)
def test_one_term_explains_an_anisotropy_that_follows_a_coordinate(
    simulation: Simulation, name: str, channel: str, second: str
) -> None:
    """To loops that follow at once, a slow change of an anisotropy is its effect times the
    coordinate."""
    turns = np.arange(ROWS) / ROWS
    swing = 5 * np.sin(4 * np.pi * turns)
    log = replace(made_up_log(ROWS, noise=0.0), acceleration_x=swing, table_angle=6 * turns)
    device = NOMINAL.without_noise()
    observed = observe_test(Test("test", "static", "fit", log), device)
    where = compute_coordinates(observed, simulation.simulate(device, observed), device)
    effect = EFFECTS[name]
    constant = compute_sensitivities(simulation, device, observed, [effect])[effect][channel]
    changing = constant[:, :1] * where.factors[second]
    columns = {term.function: block for term, block in build_term_columns(where, channel)}
    term = columns[f"harmonic 4 of the pattern angle, times {second}"]
    unexplained = changing - term @ np.linalg.lstsq(term, changing, rcond=None)[0]
    assert np.ptp(where.pattern_angle) > 1
    assert np.linalg.norm(unexplained) < 0.01 * np.linalg.norm(changing)


def test_a_harmonic_of_a_turning_pattern_is_averaged_over_the_rows(
    simulation: Simulation,
) -> None:
    """The mean over each row, beside that of a thousand values in it."""
    log = replace(made_up_log(ROWS, noise=0.0), table_angle=0.3 * np.arange(1, ROWS + 1))
    device = NOMINAL.without_noise()
    observed = observe_test(Test("test", "rate", "fit", log), device)
    where = compute_coordinates(observed, simulation.simulate(device, observed), device)
    angle = where.pattern_angle
    middles = (np.arange(1000) + 0.5) / 1000
    inside = angle[9:19, None] + np.diff(angle)[9:19, None] * middles
    assert abs(np.diff(angle)[9:19]).min() > 0.05
    for harmonic in (1, 6, 18):
        expected = [np.cos(harmonic * inside).mean(axis=1), np.sin(harmonic * inside).mean(axis=1)]
        shown = where.means.harmonics[harmonic][10:20]
        np.testing.assert_allclose(shown, np.transpose(expected), atol=1e-6)


def test_one_size_of_a_term_explains_a_phase_that_settles(simulation: Simulation) -> None:
    """To loops that follow at once, a slow change of the phase is its effect times the coordinate:
    the rate that it makes of the quadrature force, and what forces show at the angle."""
    turns = np.arange(ROWS) / ROWS
    log = made_up_log(ROWS, noise=0.0)
    log = replace(log, table_angle=6 * turns, virtual_rotation=np.full(ROWS, 1 * DEG))
    device = replace(NOMINAL.without_noise(), frequency_split=0.01, stiffness_axis=0.7)
    observed = observe_test(Test("test", "static", "fit", log), device)
    where = compute_coordinates(observed, simulation.simulate(device, observed), device)
    effect = EFFECTS["demodulation_phase_error"]
    constant = compute_sensitivities(simulation, device, observed, [effect])[effect]
    slopes = simulation.differentiate_by_angle(device, observed).slopes
    settling = np.exp(-log.time / 150)[:, None]
    for channel in ("gyro_angle", "quadrature_force", "frequency_offset"):
        columns = {term.function: block for term, block in build_term_columns(where, channel)}
        term = columns["phase: settling in 150 s"]
        if channel == "gyro_angle":
            steps = np.diff(constant[channel], axis=0, prepend=0.0)
            changing = np.cumsum(settling * steps, axis=0)
        else:
            turned = device.bryan_factor * constant["gyro_angle"]
            changing = settling * (constant[channel] + slopes[channel][:, None] * turned)
        rows = observed.rows[channel] & (log.time > STARTED)
        apart = (term - changing)[rows]
        assert np.abs(apart).max() < 0.02 * np.abs(changing[rows]).max(), channel


@pytest.mark.parametrize(
    ("name", "function"),
    [
        (
            "pickoff_gain_temperature",
            "pick-off: harmonic 4 of the pattern angle, times the temperature",
        ),
        ("g_sensitive_gain", "pick-off: harmonic 4 of the pattern angle, times acceleration x"),
        (
            "damping_anisotropy_temperature",
            "harmonic 4 of the pattern angle, times the temperature",
        ),
        ("g_sensitive_bias", "drive: settling in 150 s"),
    ],
)
@pytest.mark.parametrize("commanded", [0.0, 1 * DEG])
def test_one_size_of_a_term_explains_an_effect_in_all_channels(
    simulation: Simulation, name: str, function: str, commanded: float
) -> None:
    """Pick-offs that misread the angle also misread the amplitude; an anisotropy of damping also
    turns the pattern; forces that point beside the pattern also change the frequency. Each channel
    counts in units of what the effect makes there."""
    turns = np.arange(ROWS) / ROWS
    still = made_up_log(ROWS, noise=0.0)
    log = replace(
        still,
        acceleration_x=5 * np.sin(4 * np.pi * turns),
        acceleration_z=5 * np.exp(-still.time / 150),
        temperature=298.15 + 10 * np.sin(2 * np.pi * turns),
        table_angle=6 * turns,
        virtual_rotation=np.full(ROWS, commanded),
    )
    device = replace(NOMINAL.without_noise(), damping_anisotropy=1e-5, damping_axis=0.3)
    device = replace(device, frequency_split=0.01, stiffness_axis=0.7)
    observed = observe_test(Test("test", "static", "fit", log), device)
    effect = EFFECTS[name]
    where = compute_coordinates(observed, simulation.simulate(device, observed), device)
    effects = compute_sensitivities(simulation, device, observed, [effect])[effect]
    slopes = simulation.differentiate_by_angle(device, observed).slopes
    reading = {t.function: values for t, values in build_reading_columns(where)}
    own_channel = "amplitude_force" if name.startswith("damping") else "gyro_angle"
    shown, expected = [], []
    for channel in ("gyro_angle", "amplitude_force", "quadrature_force", "frequency_offset"):
        terms = build_term_columns(where, channel)
        columns = {t.function: block for t, block in terms if t.channel == own_channel}
        is_misread = channel != "gyro_angle" and function in reading
        if not np.any(columns.get(function, 0.0)):
            continue
        own, response = columns[function], effects[channel][:, 0]
        if channel != "gyro_angle":
            at_angle = device.bryan_factor * slopes[channel]
            response = response + at_angle * effects["gyro_angle"][:, 0]
            own = own + at_angle[:, None] * reading[function] if is_misread else own
        rows = observed.rows[channel]
        shown.append(own[rows] / np.linalg.norm(response[rows]))
        expected.append(response[rows] / np.linalg.norm(response[rows]))
    term, whole = np.vstack(shown), np.concatenate(expected)
    left = whole - term @ np.linalg.lstsq(term, whole, rcond=None)[0]
    assert np.linalg.norm(left) < MAX_LEFT


def test_a_free_pattern_shows_what_its_pickoffs_misread(simulation: Simulation) -> None:
    """While the drive is off nothing holds the amplitude that they read."""
    turns = np.arange(200)
    log = replace(
        made_up_log(200, noise=0.0),
        acceleration_x=np.full(200, 9.8),
        drive_on=(turns < 60) * 1.0,
        table_angle=0.2 * DEG * turns,
    )
    device = NOMINAL.without_noise()
    observed = observe_test(Test("test", "ring_down", "fit", log), device)
    where = compute_coordinates(observed, simulation.simulate(device, observed), device)
    effect = EFFECTS["g_sensitive_gain"]
    function = "pick-off: harmonic 4 of the pattern angle, times acceleration x"
    response = compute_sensitivities(simulation, device, observed, [effect])[effect]
    by_output = (
        device.bryan_factor
        * simulation.differentiate_by_angle(device, observed).slopes["amplitude"]
    )
    expected = response["amplitude"][:, 0] + by_output * response["gyro_angle"][:, 0]
    columns = {term.function: block for term, block in build_term_columns(where, "amplitude")}
    reading = {term.function: values for term, values in build_reading_columns(where)}
    shown = columns[function] + by_output[:, None] * reading[function]
    size = np.array([0.0, 10 / (4 * device.bryan_factor)])  # of a gain per m/s^2
    is_free = log.drive_on == 0
    apart = (shown @ size - expected)[is_free]
    assert np.abs(apart).max() < 0.02 * np.abs(expected[is_free]).max()
    assert np.abs(expected[is_free]).max() > 1


def test_the_amplitude_coordinate_of_a_free_pattern_is_simulated() -> None:
    """With the drive on it is the commanded amplitude. The logged one is not used. A free pattern
    becomes an ellipse by its frequency split: its energy counts."""
    amplitude = np.exp(-np.clip(np.arange(100) - 50, 0, None) / 400) + 1e-6
    quadrature = np.linspace(0.0, 0.3, 100)
    log = replace(made_up_log(100), drive_on=(np.arange(100) < 50) * 1.0)
    observed = observe_test(Test("test", "ring_down", "fit", log), NOMINAL)
    nothing = np.zeros(100)
    replay = {"wave_angle": nothing, "amplitude_force": nothing, "quadrature_force": nothing}
    orbit = {"amplitude": amplitude, "quadrature": quadrature}
    where = compute_coordinates(observed, {**replay, **orbit}, NOMINAL)
    columns = {
        term.function: block for term, block in build_term_columns(where, "quadrature_force")
    }
    expected = np.where(np.arange(100) < 50, 1.0, np.hypot(amplitude, quadrature))
    np.testing.assert_allclose(columns["amplitude"][:, 0], expected - 1, atol=1e-15)
    np.testing.assert_allclose(columns["amplitude squared"][:, 0], expected**2 - 1, atol=1e-15)
