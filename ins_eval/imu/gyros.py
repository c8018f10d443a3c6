"""Three gyros as FMUs of the gyro's physics."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fmu_build.bundle import built_fmu
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.mounting import Mounting
from ins_eval.imu.stated_gyros import GyroReading
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.dynamic.start_up import START
from pyhrg.device import device_file
from pyhrg.device.device_file import DeviceError
from pyhrg.device.keys import KEYS
from pyhrg.device.ready_devices import TABLE2, TYPICAL, Device
from pyhrg.fmu import GyroError, GyroFmu
from pyhrg.theory import closed_forms as theory

Array = NDArray[np.float64]

__all__ = ["DeviceError", "FmuGyros", "GyroError", "device", "difference", "measured"]

AMPLITUDE_TOLERANCE = 1e-3
"""Of a gyro that is ready, relative to its set point: while the amplitude still grows, the output
is valid, but the force that raises it is misaimed and turns the pattern by degrees an hour."""


@dataclass(frozen=True)
class FmuGyros:
    """Gyros simulated by their FMU.

    device: what they are alike in;
    own_axes: whether each has its own axes of imperfection and power-on angle, drawn
    (`Device.another`);
    differences: fields of `Device` by gyro, what each has for certain;
    calibrated: whether the maker has measured each one's mean bias and takes it out;
    start_up: whether the record begins at power-on, with the gyros' start-up, instead of gyros
    that vibrate in full from the first moment on;
    fmu: the model; if None, the one of the present sources, built where it isn't there.
    """

    device: Device = TYPICAL
    own_axes: bool = True
    differences: tuple[Mapping[str, Any], ...] = field(default=({}, {}, {}), hash=False)
    calibrated: bool = True
    start_up: bool = False
    fmu: GyroFmu | None = None

    def devices(self, generator: np.random.Generator) -> list[Device]:
        """The three, drawn anew."""
        drawn = [self.device.another(generator) if self.own_axes else self.device for _ in "xyz"]
        return [replace(d, **own) for d, own in zip(drawn, self.differences, strict=True)]

    def measure(
        self, truth: Increments, mounting: Mounting, generator: np.random.Generator
    ) -> GyroReading:
        """See `Gyros`.

        Raises:
            ValueError: an interval that is no multiple of the electronics' control period.
            GyroError: a value that the FMU refuses.
            TranslationError, BuildError: the model can't be built.
        """
        periods = truth.interval / self.device.control_period
        if round(periods) < 1 or abs(periods - round(periods)) > 1e-6:
            raise ValueError(
                f"found an interval of {truth.interval:g} s, expected a multiple of the gyros' "
                f"control period, {self.device.control_period:g} s"
            )
        fmu = self.fmu or GyroFmu(built_fmu())
        devices = self.devices(generator)
        if self.start_up:
            devices = [starting_up(each) for each in devices]
        return measured(fmu, devices, truth, mounting, generator, self.calibrated)

    def from_power_on(self) -> "FmuGyros":
        """See `Gyros`."""
        return replace(self, start_up=True)

    @property
    def errors(self) -> SensorErrors:
        """See `Gyros`; the bias is that of the map at an unknown pattern angle."""
        devices = [replace(self.device, **own) for own in self.differences]
        return SensorErrors(
            gyro_bias=_rms([_bias(device, self.calibrated) for device in devices]),
            angle_random_walk=_rms([device.angle_random_walk for device in devices]),
            gyro_bias_instability=_rms([device.bias_instability for device in devices]),
            angle_quantum=_rms([_quantum(device) for device in devices]),
        )


def device(name_or_path: str, folder: Path) -> Device:
    """One that comes with the package, by its name, or the one in a file.

    Args:
        name_or_path: a path that is not absolute is from the folder.
        folder: see there.

    Raises:
        DeviceError: see `device_file.read`.
    """
    ready = {kind.name: kind for kind in (TYPICAL, TABLE2)}
    return ready.get(name_or_path) or device_file.read(folder / name_or_path)


def difference(document: Mapping[str, Any], source: str) -> dict[str, Any]:
    """Fields of `Device` that the keys of a device file state.

    Raises:
        DeviceError: see `device_file.from_table`.
    """
    stated = device_file.from_table(document, source)
    fields_by_key = {key.name: key.field for key in KEYS}
    return {
        name: getattr(stated, name) for name in (fields_by_key.get(key, key) for key in document)
    }


def measured(
    fmu: GyroFmu,
    devices: Sequence[Device],
    truth: Increments,
    mounting: Mounting,
    generator: np.random.Generator,
    calibrated: bool = True,
) -> GyroReading:
    """What three given gyros make of the true motion.

    Args:
        fmu: their model.
        devices: their parameters.
        truth: true increments.
        mounting: of the input axes.
        generator: of power-on angles and noise seeds.
        calibrated: see `FmuGyros`.
    """
    benches = [Bench(fmu, device, seed=int(generator.integers(2**63))) for device in devices]
    sensed = mounting.sensed(truth.rotation)
    rotation, pattern = np.empty_like(sensed), np.empty_like(sensed)
    ready = np.ones(len(truth), dtype=bool)
    for axis, bench in enumerate(benches):
        force = case_force(truth, mounting.axes[axis])
        bias = mean_bias(bench) if calibrated else 0.0
        flight = flown(bench, sensed[:, axis], force, truth.interval)
        rotation[:, axis] = flight.rotation - bias * truth.interval
        pattern[:, axis] = flight.pattern_angle
        ready &= flight.ready
    return GyroReading(rotation, pattern, ready)


def mean_bias(bench: Bench) -> float:
    """The maker's calibration, rad/s: eight positions of the circumference, 100 s each, a power-on
    of its own; the mean of the fitted map."""
    power_ons = full_circumference.power_ons(bench, full_circumference.SHORTEST, 1, segments=1)
    calibration = bench.campaign([bench.log(power_on) for power_on in power_ons])
    return full_circumference.mean_bias(calibration)


def starting_up(device: Device) -> Device:
    """The gyro as it vibrates at power-on: as in the bench's start-up test, unless it says how."""
    return replace(device, model={**START, **device.model})


@dataclass(frozen=True)
class GyroFlight:
    """What one gyro makes of a motion from power-on on.

    rotation: (n,) increments, rad; pattern_angle: (n,) at the end of each interval, rad; valid:
    (n,) whether the output then is, as the gyro itself says; ready: (n,) whether it is and the
    amplitude is within `AMPLITUDE_TOLERANCE`.
    """

    rotation: Array
    pattern_angle: Array
    valid: NDArray[np.bool_]
    ready: NDArray[np.bool_]


def flown(bench: Bench, rotation: Array, force: Array, interval: float) -> GyroFlight:
    """Switch a gyro on and move it; the same bench gives the same noise.

    Args:
        bench: the gyro.
        rotation: (n,) true rotation about the input axis in each interval, rad.
        force: (n, 3) mean specific force along the case's axes, the third the input axis, m/s^2.
        interval: s.
    """
    inputs = {"angularRate": rotation / interval}
    inputs |= {f"acceleration{axis}": force[:, i] for i, axis in enumerate("XYZ")}
    moving = {name: values[:, None] for name, values in inputs.items()}
    with bench.power_on("flight") as gyro:
        outputs = ["gyroAngle", "patternAngle", "valid", "amplitude"]
        ends, _ = gyro.record(moving, {}, interval, outputs)
    angle, pattern, valid, amplitude = ends.T
    grown = np.abs(amplitude / bench.device.amplitude - 1) <= AMPLITUDE_TOLERANCE
    says = valid == 1
    return GyroFlight(np.diff(angle, prepend=0.0), pattern.copy(), says, says & grown)


def case_force(truth: Increments, input_axis: Array) -> Array:
    """(n, 3) mean specific force along the axes of a gyro's case, m/s^2; see `case_axes`."""
    return np.asarray(truth.velocity @ case_axes(input_axis).T / truth.interval)


def case_axes(input_axis: Array) -> Array:
    """(3, 3) axes of a gyro's case, a row each, in body axes: x, where the pattern angle is zero,
    from the first of forward, right, down that is farthest from the input axis; z the latter."""
    nearest = np.eye(3)[np.argmin(np.abs(input_axis))]
    across = nearest - (nearest @ input_axis) * input_axis
    x = across / np.linalg.norm(across)
    return np.stack([x, np.cross(input_axis, x), input_axis])


def _bias(device: Device, calibrated: bool) -> float:
    spread = theory.circumferential_bias_stability(device)
    return spread if calibrated else float(np.hypot(spread, theory.mean_bias(device)))


def _quantum(device: Device) -> float:
    """Of the variance that the detected angle's white noise and the output's quantum have."""
    return float(np.hypot(device.angle_quantum, np.sqrt(12) * device.pickoff_noise))


def _rms(values: Sequence[float]) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
