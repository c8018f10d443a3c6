"""Sensitivities of a replay to the effects' parameters, and the residual of a linearized test."""

from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.replay.observations import CHANNELS, ObservedTest
from pyhrg.gap.replay.simulation import ChannelValues, Simulation

STEP_SHARE = 1e-4
"""Step of a sensitivity's finite difference, in scales of the effect. Chosen."""


def linearize_tests(
    simulation: Simulation,
    nominal: Device,
    device: Device,
    tests: Sequence[ObservedTest],
    effects: Collection[Effect] = (),
    last: Sequence[LinearTest] = (),
) -> list[LinearTest]:
    """Tests linearized around a device, with new sensitivities to effects, or with those of the
    last linear tests if there are any. A `GyroError` where the FMU refuses the device."""
    parts = []
    for index, test in enumerate(tests):
        answer = simulation.simulate(device, test)
        columns = (
            last[index].sensitivities
            if last
            else compute_sensitivities(simulation, device, test, effects)
        )
        parts.append(linearize_test(simulation, nominal, device, test, answer, columns))
    return parts


def linearize_test(
    simulation: Simulation,
    nominal: Device,
    device: Device,
    test: ObservedTest,
    simulated: ChannelValues,
    sensitivities: Mapping[Effect, Mapping[str, Array]],
) -> LinearTest:
    """One test linearized around a device, its residual referred to the nominal device.

    The residual is what record less simulation of the nominal device would be if effects were
    linear (docs/methods/effects.md, Eqs. 2 and 3). `simulated` are (n,) outputs of the device by
    field of a log, sensitivities (n, d) by channel.
    """
    residual = {name: getattr(test.log, name) - simulated[name] for name in CHANNELS}
    for effect, own in sensitivities.items():
        away = effect.vector(device) - effect.vector(nominal)
        for name in CHANNELS:
            residual[name] = residual[name] + own[name] @ away
    by_angle = simulation.differentiate_by_angle(device, test)
    where = compute_coordinates(test, simulated, nominal, by_angle.free_turns)
    turned = nominal.bryan_factor * (test.log.gyro_angle - simulated["gyro_angle"])
    for name in CHANNELS[1:]:
        residual[name] = residual[name] - by_angle.bend(name, turned)
    return LinearTest(test, device, simulated, residual, sensitivities, where, by_angle)


def compute_sensitivities(
    simulation: Simulation, device: Device, test: ObservedTest, effects: Iterable[Effect]
) -> dict[Effect, dict[str, Array]]:
    """Change of a replay per unit of the effects' vectors at a device (Eq. 1): (n, d) by channel
    for each effect of size d, channel's SI unit over the vector's. A `GyroError` of the FMU names
    the test."""
    effects = list(effects)
    moves = [_move(device, effect, unit) for effect in effects for unit in np.eye(effect.size)]
    try:
        changes = simulation.compute_differences(device, [other for other, _ in moves], test)
    except GyroError as error:
        raise GyroError(f"{test.test.id}: {error}") from error
    columns = iter(
        {name: change[name] / distance for name in CHANNELS}
        for change, (_, distance) in zip(changes, moves, strict=True)
    )
    sensitivities = {}
    for effect in effects:
        own = [next(columns) for _ in range(effect.size)]
        sensitivities[effect] = {
            name: np.column_stack([column[name] for column in own]) for name in CHANNELS
        }
    return sensitivities


def _move(device: Device, effect: Effect, unit: Array) -> tuple[Device, float]:
    """The device a little along a unit vector, and how far; backwards where the effect is at its
    upper bound."""
    here, step = effect.vector(device), STEP_SHARE * effect.scale
    candidates = (effect.put(device, here + sign * step * unit) for sign in (1, -1))
    moved = next(other for other in candidates if (effect.vector(other) - here) @ unit != 0)
    return moved, float((effect.vector(moved) - here) @ unit)
