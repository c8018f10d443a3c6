"""Nameless elements reach what effects of the catalogue do, should they lack a name."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.gap.effects.candidate_terms import columns, coordinates
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.sensitivities import secants
from pyhrg.gap.replay.observations import observed
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.channel_noise import angle_noise
from pyhrg.gap.whitening.whitening import whitened
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.soundness.conftest import BELIEVED
from tests.pyhrg.records.made_up import made_up_log

ROWS = 600
LEFT = 0.15
"""Share of an effect's power that one element may leave: of the biases that it brings as well."""


@pytest.mark.parametrize(
    ("name", "channel", "of"),
    [
        (
            "g_sensitive_gain",
            "gyro_angle",
            "angle: 2nd harmonic of the pattern angle, times acceleration x",
        ),
        (
            "pickoff_gain_temperature",
            "gyro_angle",
            "angle: 2nd harmonic of the pattern angle, times the temperature",
        ),
        ("residual_quadrature", "quadrature_force", "mean over the pattern angle"),
    ],
)
def test_an_element_does_what_an_effect_does(
    simulation: Simulation, name: str, channel: str, of: str
) -> None:
    turns = np.arange(ROWS) / ROWS
    log = replace(
        made_up_log(ROWS, noise=0.0),
        acceleration_x=5 * np.sin(4 * np.pi * turns),
        temperature=298.15 + 10 * np.sin(2 * np.pi * turns),
    )
    device = BELIEVED.without_noise()
    seen = observed(Test("test", "static", "fit", log), device)
    answer = simulation.answers(device, seen)
    where = coordinates(seen, answer["wave_angle"], answer["amplitude"], device)
    effect = EFFECTS[name]
    does = secants(simulation, device, seen, [effect])[effect][channel][:, 0]
    block = next(b for element, b in columns(where, channel) if element.of == of)
    rows = seen.rows[channel]
    series = np.column_stack([block, does])[rows]
    white = whitened(series, np.diff(log.time[rows], prepend=0.0), angle_noise(BELIEVED)).series
    element, effect_itself = white[:, :-1], white[:, -1]
    left = effect_itself - element @ np.linalg.lstsq(element, effect_itself, rcond=None)[0]
    assert left @ left < LEFT * (effect_itself @ effect_itself)


def test_the_amplitude_of_a_free_pattern_is_its_own() -> None:
    """With the drive on it is what is commanded; by simulation, whatever is read."""
    amplitude = np.exp(-np.clip(np.arange(100) - 50, 0, None) / 400) + 1e-6
    log = replace(made_up_log(100), drive_on=(np.arange(100) < 50) * 1.0)
    seen = observed(Test("test", "ring_down", "fit", log), BELIEVED)
    where = coordinates(seen, np.zeros(100), amplitude, BELIEVED)
    found = {element.of: block for element, block in columns(where, "quadrature_force")}
    expected = np.where(np.arange(100) < 50, 0.0, amplitude - 1)
    np.testing.assert_array_equal(found["amplitude"][:, 0], expected)
