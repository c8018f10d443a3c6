"""What a campaign's residuals are, and what effects do to them, through the FMU."""

from collections.abc import Callable, Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.candidate_terms import coordinates
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import LinearTest
from pyhrg.gap.replay.observations import CHANNELS, Observed
from pyhrg.gap.replay.simulation import Answers, Simulation

Array = NDArray[np.float64]

TOLERANCE = 0.01
"""Of an effect's scale, by which its secants are taken."""


def linear_test(
    simulation: Simulation,
    believed: Device,
    device: Device,
    test: Observed,
    answers: Answers,
    columns: Mapping[Effect, Mapping[str, Array]],
) -> LinearTest:
    """Residual of a test around a device, as it would be around the believed one if effects were
    linear.

    Args:
        simulation: both fidelities.
        believed: the gyro before the diagnosis.
        device: the gyro that is simulated.
        test: observed.
        answers: (n,) by field of a log, of the device.
        columns: (n, d) by channel, secants of each effect.
    """
    residual = {name: getattr(test.log, name) - answers[name] for name in CHANNELS}
    for effect, own in columns.items():
        away = effect.vector(device) - effect.vector(believed)
        for name in CHANNELS:
            residual[name] = residual[name] + own[name] @ away
    where = coordinates(test, answers["wave_angle"], answers["amplitude"], believed)
    around, factor = simulation.over_angle(device, test), believed.bryan_factor
    turned = factor * (test.log.gyro_angle - answers["gyro_angle"])
    for name in CHANNELS[1:]:
        residual[name] = residual[name] - around.bent(name, turned)
    return LinearTest(test, device, answers, residual, columns, where, around.slopes, factor)


def secants(
    simulation: Simulation, device: Device, test: Observed, effects: Iterable[Effect]
) -> dict[Effect, dict[str, Array]]:
    """Change of the answer per unit of the effects' vectors from a device on.

    Returns:
        (n, d) by channel for each effect, of size d.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    change_to = simulation.changes(device, test)
    found = {}
    for effect in effects:
        try:
            columns = [_secant(change_to, device, effect, unit) for unit in np.eye(effect.size)]
        except GyroError as error:
            raise GyroError(f"{test.test.id}, with {effect.name}: {error}") from error
        found[effect] = {
            name: np.column_stack([column[name] for column in columns]) for name in CHANNELS
        }
    return found


def _secant(
    change_to: Callable[[Device], Answers], device: Device, effect: Effect, unit: Array
) -> dict[str, Array]:
    """(n,) by channel, along one direction; backwards where there is no way on."""
    here, step = effect.vector(device), TOLERANCE * effect.scale
    ways = (effect.put(device, here + sign * step * unit) for sign in (1, -1))
    moved = next(way for way in ways if (effect.vector(way) - here) @ unit != 0)
    apart = (effect.vector(moved) - here) @ unit
    change = change_to(moved)
    return {name: change[name] / apart for name in CHANNELS}
