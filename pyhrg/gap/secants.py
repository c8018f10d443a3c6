"""What a campaign's residuals are, and what effects do to them, through the FMU."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pyhrg.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.catalogue import Effect
from pyhrg.gap.design import Evidence
from pyhrg.gap.observations import CHANNELS, Observed
from pyhrg.gap.simulation import Answers, Simulation
from pyhrg.gap.unknown import coordinates

Array = NDArray[np.float64]

TOLERANCE = 0.1
"""Of an effect's scale, by which its secants are taken."""


def evidence(
    simulation: Simulation,
    believed: Device,
    device: Device,
    test: Observed,
    answers: Answers,
    columns: Mapping[Effect, Mapping[str, Array]],
) -> Evidence:
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
    where = coordinates(test, answers["wave_angle"], believed)
    slopes = simulation.slope_over_angle(device, test)
    return Evidence(test, device, answers, residual, columns, where, slopes, believed.bryan_factor)


def secants(
    simulation: Simulation, device: Device, test: Observed, effect: Effect
) -> Mapping[str, Array]:
    """(n, d) by channel: change of the answer per unit of an effect's vector around a device.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    here = effect.vector(device)
    columns: dict[str, list[Array]] = {name: [] for name in CHANNELS}
    for i in range(effect.size):
        step = np.zeros(effect.size)
        step[i] = TOLERANCE * effect.scale
        low, high = (effect.put(device, here + sign * step) for sign in (-1, 1))
        apart = (effect.vector(high) - effect.vector(low))[i]
        try:
            change = simulation.difference(low, high, test)
        except GyroError as error:
            raise GyroError(f"{test.test.id}, with {effect.name}: {error}") from error
        for name in CHANNELS:
            columns[name].append(change[name] / apart)
    return {name: np.column_stack(found) for name, found in columns.items()}
