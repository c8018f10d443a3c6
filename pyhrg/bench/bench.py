"""The virtual bench: runs a programme on the gyro's FMU and logs it as a real bench would."""

import threading
import zlib
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.programme import Programme
from pyhrg.bench.store import Store, key_of
from pyhrg.device.device import LOOPS, Device
from pyhrg.device.device_file import nominal
from pyhrg.fmu import CONTROL_PERIOD, Gyro, GyroFmu
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

Array = NDArray[np.float64]

INPUTS = {
    "acceleration_x": "accelerationX",
    "acceleration_y": "accelerationY",
    "acceleration_z": "accelerationZ",
    "virtual_rotation": "virtualRotation",
    "amplitude_setpoint": "amplitudeSetpoint",
    "phase_offset": "phaseOffset",
    "drive_on": "driveOn",
    "vibration": "vibration",
    "bias_voltage": "biasVoltage",
}
"""Inputs of the FMU that hold over a row, by their name in a programme."""
ENDS = {"gyro_angle": "gyroAngle", "wave_angle": "patternAngle", "amplitude": "amplitude"}
MEANS = {
    "amplitude_force": "amplitudeForce",
    "quadrature_force": "quadratureForce",
    "frequency_offset": "frequencyOffset",
    "valid": "valid",
}
"""Outputs of the FMU by their field of a log: at a row's end, and averaged over the row."""
FORCES = tuple(name for name in MEANS if name != "valid")
"""Means that say something of the gyro."""


@dataclass(frozen=True)
class PowerOn:
    """One power-on to be made: its identity within the campaign, and what is done.

    id: of the test; also decides the seed, so that a procedure gives the same alone and among all.
    kind: as in the campaign format.
    start_angle: of the pattern, rad; the device's own, with its scatter, if None.
    """

    id: str
    kind: str
    programme: Programme
    start_angle: float | None = None


@dataclass(frozen=True)
class Bench:
    """A gyro on a turntable.

    step: communication step, s; rows of a programme are multiples of it.
    store: where logs are kept to resume from; None keeps none.
    done: told the gyro time, s, of each power-on when it is over.
    """

    fmu: GyroFmu
    device: Device
    seed: int = 1
    step: float = 0.01
    workers: int = 1
    store: Store | None = None
    done: Callable[[float], None] = field(default=lambda seconds: None, compare=False)

    def programme(self, interval: float = 1.0) -> Programme:
        """A programme for this gyro and site, to be filled."""
        device = self.device
        course = Programme(interval, device.site.gravity, device.reference_temperature)
        return course.command(amplitude_setpoint=device.amplitude)

    def run(self, power_ons: Sequence[PowerOn]) -> list[Test]:
        """Make power-ons, in parallel where there are workers; same numbers on any number."""
        self.fmu.prepare()
        stop = threading.Event()
        self.fmu.stop = stop
        with ThreadPoolExecutor(self.workers) as pool:
            try:
                return list(pool.map(self.log, power_ons))
            except BaseException:
                stop.set()
                raise
            finally:
                self.fmu.stop = None

    def power_on(self, identity: str, start_angle: float | None = None) -> Gyro:
        """Switch the gyro on: new noise; power-on angle and parameters as well as they repeat.

        Args:
            identity: of the power-on; the same one has the same noise, angle and parameters.
            start_angle: of the pattern, rad, instead of the device's own.
        """
        key = zlib.crc32(identity.encode())
        generator = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(key,)))
        seed = int(generator.integers(2**31))
        own = generator.normal(self.device.power_on_angle, self.device.power_on_scatter)
        angle = own if start_angle is None else start_angle
        missing = LOOPS - self.fmu.references.keys()
        values = self.device.turned_on(generator).items()
        parameters = {name: value for name, value in values if name not in missing}
        return self.fmu.power_on(parameters, seed, angle)

    def log(self, power_on: PowerOn) -> Test:
        """Make one power-on and log it, or take the log that an earlier attempt kept."""
        key = key_of(
            power_on.programme,
            **{"id": power_on.id, "seed": self.seed, "step": self.step},
            **{"fmu": self.fmu.folder.name, "device": self.device},
            **{"start_angle": power_on.start_angle},
        )
        log = self.store.load(key) if self.store else None
        if log is None:
            log = self._recorded(power_on)
            if self.store:
                self.store.keep(key, log)
        self.done(power_on.programme.time)
        recording = replace(log, source=power_on.id)
        return Test(id=power_on.id, kind=power_on.kind, role="fit", recording=recording)

    def _recorded(self, power_on: PowerOn) -> Log:
        programme = power_on.programme
        with self.power_on(power_on.id, power_on.start_angle) as gyro:
            held = {name: programme.held(name) for name in INPUTS}
            outputs = recorded(gyro, self._moving(programme), held, self.step)
        columns: dict[str, Any] = {
            "time": np.arange(1, len(programme) + 1) * programme.interval,
            "table_angle": programme.table_angle,
            "temperature": programme.temperature[1:],
            **{name: programme.held(name) for name in LOGGED},
            **outputs,
        }
        return Log(source=power_on.id, interval=programme.interval, exclusions=(), **columns)

    def campaign(self, tests: Sequence[Test]) -> Campaign:
        """The tests with what is believed of the gyro, as a test engineer would bring them home."""
        return Campaign(self.device.name, self.device.site, nominal(self.device), tuple(tests))

    def _moving(self, programme: Programme) -> dict[str, Array]:
        """(n, m) inputs that change within a row, in each communication step, SI."""
        steps = round(programme.interval / self.step)
        if steps < 1 or abs(steps * self.step - programme.interval) > 1e-9:
            raise ValueError(
                f"rows of {programme.interval:g} s are no multiple of the step {self.step:g} s"
            )
        share = middles(steps)
        rate = between(programme.table_rate, share)
        begun = np.concatenate(([0.0], programme.table_angle[:-1]))[:, None]
        swept = programme.interval * share * between(programme.table_rate, share / 2)
        earth = earth_rate(self.device, programme.held("axis_up")[:, None], begun + swept)
        return {
            "angularRate": rate + earth,
            "caseTemperature": between(programme.temperature, share),
        }


def recorded(
    gyro: Gyro,
    moving: Mapping[str, Array],
    held: Mapping[str, Array],
    step: float,
    means: Sequence[str] = tuple(MEANS),
) -> dict[str, Array]:
    """(n,) what a log shows of a gyro, by field, SI; of the amplitude, that of one control period
    before each row's end.

    Args:
        gyro: that is switched on.
        moving: (n, m) inputs in each of a row's m steps, by the FMU's names, SI.
        held: (n,) inputs that hold over a row, by their names in a programme, SI.
        step: communication step, s.
        means: fields that are averaged over a row.
    """
    commands = {INPUTS[name]: values for name, values in held.items()}
    averaged = [MEANS[name] for name in means]
    ends, rows = gyro.record(moving, commands, step, list(ENDS.values()), averaged)
    fields = dict(zip((*ENDS, *means), [*ends.T, *rows.T], strict=True))
    change = np.diff(fields["amplitude"], prepend=fields["amplitude"][0])
    interval = step * next(iter(moving.values())).shape[1]
    fields["amplitude"] = np.asarray(fields["amplitude"] - change * CONTROL_PERIOD / interval)
    return fields


def earth_rate(device: Device, axis_up: Array, table_angle: Array) -> Array:
    """Earth's rate on the input axis, rad/s; a misaligned axis leans north once a turn.

    Args:
        device: its misalignment, and where it is tested.
        axis_up: projection of the table's axis on local up.
        table_angle: rad.
    """
    north = np.cos(table_angle + device.misalignment_direction)
    up = axis_up * np.cos(device.misalignment)
    lean = np.sin(device.misalignment) * north
    return np.asarray(device.site.vertical_rate * up + device.site.horizontal_rate * lean)


LOGGED = tuple(name for name in ("axis_up", *INPUTS) if name not in ("vibration", "bias_voltage"))
"""What a programme holds and a log shows."""


def middles(steps: int) -> Array:
    """(m,) of equal steps of a row, as shares of it."""
    return np.asarray((np.arange(steps) + 0.5) / steps)


def between(bounds: Array, share: Array) -> Array:
    """(n, m) values at shares (m,) of the way between neighbours of (n + 1,)."""
    return np.asarray(bounds[:-1, None] + np.diff(bounds)[:, None] * share)
