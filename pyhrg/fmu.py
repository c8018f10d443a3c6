"""The only FMI importer: gyros as instances of the FMU, driven by a compiled loop."""

import contextlib
import ctypes
import hashlib
import shutil
import tempfile
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

import fmpy
import numba
import numpy as np
from fmpy.fmi2 import (
    FMU2Slave,
    fmi2CallbackFunctions,
    fmi2CallbackLoggerTYPE,
    fmi2OK,
)
from numpy.typing import NDArray

from pyhrg.common.errors import HrgError

Array = NDArray[np.float64]
Loop = Callable[..., int]


class Loops(NamedTuple):
    """Compiled loops over one library's functions."""

    drive: Loop
    record: Loop


class GyroError(HrgError):
    """The FMU refused a call; the message is its own."""


_LOADING = threading.Lock()
"""FMPy changes the working directory while it loads a library."""
CONTROL_PERIOD = 1e-3
"""Of the gyro's electronics, s."""
COMMANDS = frozenset({"virtualRotation", "amplitudeSetpoint", "phaseOffset", "driveOn"})
"""Inputs that the electronics take; all others act on the gyro itself, at once."""
CHUNK = 20_000
"""Steps of a drive between looks at `GyroFmu.stop`: a second or two at 10 ms."""


class GyroFmu:
    """An FMU of the gyro, extracted and ready to be instantiated, from any thread."""

    def __init__(self, path: Path) -> None:
        """Read the description and extract the archive beside it, once.

        Args:
            path: the FMU.
        """
        self.description = fmpy.read_model_description(str(path))
        self.folder = _extracted(path)
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}
        self.kinds = {v.name: v.type for v in self.description.modelVariables}
        self._prepared = False
        self._idle: list[_Instance] = []
        self.stop: threading.Event | None = None
        """Set from another thread, it ends every drive under way with `GyroError`."""

    def power_on(self, parameters: Mapping[str, float], seed: int, start_angle: float) -> "Gyro":
        """Start a gyro.

        Args:
            parameters: values by name, SI (`Device.fmu_parameters`).
            seed: of all its noise, 0 to 2^31 - 1.
            start_angle: pattern angle at power-on, rad.

        Raises:
            GyroError: a value that the FMU refuses.
        """
        return Gyro(self, self._instance(), {**parameters, "startAngle": start_angle}, seed)

    def _instance(self) -> "_Instance":
        """One that was switched off, as new, or a new one: FMPy takes long to look up functions."""
        with _LOADING:
            return self._idle.pop() if self._idle else _Instance(self)

    def give_back(self, instance: "_Instance") -> None:
        """Keep an instance that was reset for the next power-on."""
        with _LOADING:
            self._idle.append(instance)

    @property
    def is_sampled(self) -> bool:
        """Whether loops run once in a control period; else they are at rest at any time."""
        return "controller.amplitudeLoop.naturalFrequency" in self.references

    def prepare(self) -> None:
        """Compile the loops now: in the main thread, that an interruption ends at once."""
        if not self._prepared:
            with self.power_on({}, seed=0, start_angle=0.0) as gyro:
                rest, on = np.zeros((1, 1)), np.ones(1)
                gyro.record({"angularRate": rest}, {"driveOn": on}, 0.01, ["gyroAngle"], ["valid"])
            self._prepared = True

    def set_value(self, slave: FMU2Slave, name: str, value: float) -> None:
        """Set one variable by name."""
        if name not in self.references:
            raise GyroError(f"the FMU has no variable {name}")
        if self.kinds[name] == "Integer":
            if value != int(value):
                raise GyroError(f"{name}: {value:g} is no integer")
            slave.setInteger([self.references[name]], [int(value)])
        else:
            slave.setReal([self.references[name]], [value])


class Gyro:
    """One gyro that is switched on; a context manager that switches it off."""

    def __init__(
        self, fmu: GyroFmu, instance: "_Instance", parameters: Mapping[str, float], seed: int
    ) -> None:
        self._fmu = fmu
        self._instance = instance
        self._slave = instance.slave
        self._loops = instance.loops
        self._messages = instance.messages
        self.time = 0.0
        """Time since power-on, s."""
        slave = instance.slave
        try:
            self._call(slave.setupExperiment, startTime=0.0)
            self._call(slave.enterInitializationMode)
            for name, value in {**parameters, "seed": seed}.items():
                self._call(fmu.set_value, slave, name, value)
            self._call(slave.exitInitializationMode)
        except GyroError:
            slave.freeInstance()
            raise

    def __enter__(self) -> "Gyro":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if error is not None:
            self._slave.freeInstance()
            return
        try:
            self._call(self._slave.terminate)
            self._call(self._slave.reset)
        except GyroError:
            self._slave.freeInstance()
            raise
        self._fmu.give_back(self._instance)

    def advance(self, rate: float, duration: float) -> float:
        """Turn the case at a constant inertial rate.

        Args:
            rate: about the input axis, rad/s.
            duration: s.

        Returns:
            The gyro's angle at the end, rad.
        """
        return float(self.drive(np.array([rate]), duration)[0])

    def drive(self, rates: NDArray[np.float64], step: float) -> NDArray[np.float64]:
        """Turn the case at rates that each hold for one step.

        Args:
            rates: (n,) inertial rate about the input axis, rad/s.
            step: communication step, s.

        Returns:
            (n,) the gyro's angle at the end of each step, rad.
        """
        rates = np.ascontiguousarray(rates, dtype=np.float64)
        angles = np.empty_like(rates)
        references = self._references(["angularRate", "gyroAngle"])
        for first in range(0, len(rates), CHUNK):
            self._check_stop()
            part = slice(first, first + CHUNK)
            begin = self.time + first * step
            done = self._loops.drive(
                self._slave.component, begin, step, references, rates[part], angles[part]
            )
            if done != len(rates[part]):
                raise GyroError(self._explain(f"step {first + done} of {len(rates)} failed"))
        self.time += step * len(rates)
        return angles

    def record(
        self,
        moving: Mapping[str, Array],
        held: Mapping[str, Array],
        step: float,
        ends: Sequence[str] = (),
        means: Sequence[str] = (),
    ) -> tuple[Array, Array]:
        """Read outputs row by row, each row several communication steps.

        Args:
            moving: (n, m) values of inputs by name, SI, in each of a row's m steps.
            held: (n,) values of other inputs by name, SI, each held for a row: `COMMANDS` from
                its first tick on, so that a sampled gyro's electronics are told a control period
                before.
            step: communication step, s.
            ends: outputs to be read at the end of each row.
            means: outputs to be averaged over each row. What the electronics of a sampled gyro
                command holds from one tick to the next, so that a row's mean is that of the ticks
                from its start on. A row whose commands are new is stepped tick by tick; elsewhere
                steps of several ticks count as if it changed evenly.

        Returns:
            (n, len(ends)) and (n, len(means)), SI.

        Raises:
            GyroError: an unknown name, a value that the FMU refuses, or `GyroFmu.stop`.
        """
        moved = np.ascontiguousarray(np.stack(list(moving.values()), axis=-1))
        rows, steps, _ = moved.shape
        names = sorted(held, key=lambda name: name not in COMMANDS)
        told = sum(name in COMMANDS for name in names)
        values = [np.append(held[name], held[name][-1:]) for name in names]
        fixed = np.column_stack([*values, np.empty((rows + 1, 0))])
        fresh = np.append(True, (np.diff(fixed, axis=0) != 0).any(axis=1))
        at_end, averaged = (np.zeros((rows, len(each))) for each in (ends, means))
        references = [self._references(each) for each in (moving, names, ends, means)]
        chunk = max(1, CHUNK // steps)
        tick = CONTROL_PERIOD if self._fmu.is_sampled else 0.0
        for first in range(0, rows, chunk):
            self._check_stop()
            part = slice(first, first + chunk)
            begin = self.time + first * steps * step
            commands = fixed[first : first + chunk + 1]
            arrays = (moved[part], commands, fresh[part], at_end[part], averaged[part])
            done = self._loops.record(
                self._slave.component, begin, step, tick, told, *references, *arrays
            )
            if done != len(moved[part]):
                raise GyroError(self._explain(f"row {first + done} of {rows} failed"))
        self.time += step * steps * rows
        return at_end, averaged

    def read(self, name: str) -> float:
        """Present value of a variable, SI."""
        return float(self._slave.getReal([self._fmu.references[name]])[0])

    def command(self, name: str, value: float) -> None:
        """Set an input, SI."""
        self._call(self._fmu.set_value, self._slave, name, value)

    def _references(self, names: Iterable[str]) -> NDArray[np.uint32]:
        for name in names:
            if name not in self._fmu.references:
                raise GyroError(f"the FMU has no variable {name}")
        return np.array([self._fmu.references[name] for name in names], dtype=np.uint32)

    def _check_stop(self) -> None:
        if self._fmu.stop is not None and self._fmu.stop.is_set():
            raise GyroError("the drive was stopped")

    def _call(self, function: Callable[..., Any], *args: Any, **kwargs: Any) -> None:
        try:
            function(*args, **kwargs)
        except GyroError:
            raise
        except Exception as error:  # FMPy raises a bare Exception for a status that is not OK
            raise GyroError(self._explain(str(error))) from error

    def _explain(self, otherwise: str) -> str:
        text = "; ".join(self._messages) or otherwise
        self._messages.clear()
        return text


class _Instance:
    """An instance of the FMU that is not yet set up, and what it logs."""

    def __init__(self, fmu: GyroFmu) -> None:
        self.slave = FMU2Slave(
            guid=fmu.description.guid,
            unzipDirectory=str(fmu.folder),
            modelIdentifier=fmu.description.coSimulation.modelIdentifier,
            instanceName="gyro",
        )
        self.loops = _compiled(self.slave.dll._name)
        self.messages: list[str] = []
        self._callbacks = self._logging()
        self.slave.instantiate(callbacks=self._callbacks)

    def _logging(self) -> fmi2CallbackFunctions:
        messages = self.messages

        def log(env: Any, name: bytes, status: int, category: bytes, message: bytes) -> None:
            messages.append(message.decode())

        callbacks = fmi2CallbackFunctions()
        callbacks.logger = fmi2CallbackLoggerTYPE(log)
        return callbacks


def _extracted(path: Path) -> Path:
    """Folder with the content of an FMU, beside it, named by its digest; made aside and renamed, so
    that it is never half there nor another FMU's."""
    digest = hashlib.sha256(path.read_bytes()).hexdigest()[:16]
    folder = path.with_name(f"{path.stem}-{digest}")
    if not folder.is_dir():
        aside = Path(tempfile.mkdtemp(prefix=".partial-", dir=path.parent))
        try:
            fmpy.extract(str(path), str(aside))
            with contextlib.suppress(OSError):  # another process was faster
                aside.rename(folder)
        finally:
            shutil.rmtree(aside, ignore_errors=True)
    return folder


@lru_cache(maxsize=4)
def _compiled(library: str) -> Loops:
    """Loops over the FMU's own functions; all instances of a library share them."""
    dll = ctypes.CDLL(library)
    status, handle, real = ctypes.c_int, ctypes.c_void_p, ctypes.c_double

    def function(name: str, *arguments: type) -> Any:
        pointer = ctypes.cast(getattr(dll, name), ctypes.c_void_p)
        return ctypes.CFUNCTYPE(status, *arguments)(pointer.value or 0)

    set_real = function("fmi2SetReal", handle, handle, ctypes.c_size_t, handle)
    get_real = function("fmi2GetReal", handle, handle, ctypes.c_size_t, handle)
    do_step = function("fmi2DoStep", handle, real, real, status)
    ok = fmi2OK

    @numba.njit(nogil=True)
    def drive(
        component: Any, start: Any, step: Any, references: Any, rates: Any, angles: Any
    ) -> int:
        for i in range(len(rates)):
            if (
                set_real(component, references[0:].ctypes, 1, rates[i:].ctypes) != ok
                or do_step(component, start + i * step, step, 1) != ok
                or get_real(component, references[1:].ctypes, 1, angles[i:].ctypes) != ok
            ):
                return i
        return len(rates)

    @numba.njit(nogil=True)
    def summed(
        component: Any, time: Any, step: Any, tick: Any, mean: Any, now: Any, sums: Any
    ) -> bool:
        """A step, its integrals added: what a tick commands holds from its start."""
        for k in range(len(mean)):
            sums[k] += now[k] * (step + tick) / 2
        if (
            do_step(component, time, step, 1) != ok
            or get_real(component, mean.ctypes, len(mean), now.ctypes) != ok
        ):
            return False
        for k in range(len(mean)):
            sums[k] += now[k] * (step - tick) / 2
        return True

    @numba.njit(nogil=True)
    def record(
        component: Any,
        start: Any,
        step: Any,
        tick: Any,
        told: Any,
        moving: Any,
        held: Any,
        end: Any,
        mean: Any,
        moved: Any,
        fixed: Any,
        fresh: Any,
        ends: Any,
        means: Any,
    ) -> int:
        rows, steps = moved.shape[:2]
        now = np.empty(len(mean))
        if get_real(component, mean.ctypes, len(mean), now.ctypes) != ok:
            return 0
        for i in range(rows):
            if set_real(component, held.ctypes, len(held), fixed[i].ctypes) != ok:
                return i
            for j in range(steps):
                time, rest = start + (i * steps + j) * step, step
                if set_real(component, moving.ctypes, len(moving), moved[i, j].ctypes) != ok:
                    return i
                last = tick > 0.0 and j == steps - 1
                while rest > 1.5 * tick > 0.0 and (last or fresh[i]):
                    part = tick if fresh[i] else rest - tick
                    if not summed(component, time, part, tick, mean, now, means[i]):
                        return i
                    time, rest = time + part, rest - part
                coming = fixed[i + 1]
                if last and set_real(component, held.ctypes, told, coming.ctypes) != ok:
                    return i
                if not summed(component, time, rest, tick, mean, now, means[i]):
                    return i
            for k in range(len(mean)):
                means[i, k] /= steps * step
            if get_real(component, end.ctypes, len(end), ends[i].ctypes) != ok:
                return i
        return rows

    return Loops(drive, record)
