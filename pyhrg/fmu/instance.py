"""An instance of the FMU: its FMI 2.0 calls, with the FMU's own message when one fails."""

from collections.abc import Callable, Mapping
from typing import Any

from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE

from pyhrg.fmu.archive import Archive, GyroError
from pyhrg.fmu.loops import find_functions


class Instance:
    """An instance that is not yet set up, and what it logs."""

    def __init__(self, archive: Archive) -> None:
        self.archive = archive
        self.slave = FMU2Slave(
            guid=archive.description.guid,
            unzipDirectory=str(archive.folder),
            modelIdentifier=archive.description.coSimulation.modelIdentifier,
            instanceName="gyro",
        )
        self.functions = find_functions(self.slave.dll._name)
        self._messages: list[str] = []
        messages = self._messages  # not self: the slave holds what it calls

        def log(env: Any, name: bytes, status: int, category: bytes, message: bytes) -> None:
            messages.append(message.decode())

        self._callbacks = fmi2CallbackFunctions()
        self._callbacks.logger = fmi2CallbackLoggerTYPE(log)
        self.slave.instantiate(callbacks=self._callbacks)

    def set_up(self, parameters: Mapping[str, float]) -> None:
        """Set parameters by name, SI, and start the simulation; where the FMU refuses one, the
        instance is freed."""
        try:
            self._call(self.slave.setupExperiment, startTime=0.0)
            self._call(self.slave.enterInitializationMode)
            self.set_values(parameters)
            self._call(self.slave.exitInitializationMode)
        except GyroError:
            self.slave.freeInstance()
            raise

    def reset(self) -> None:
        """End the simulation; the instance can be set up again, unless the FMU refuses."""
        try:
            self._call(self.slave.terminate)
            self._call(self.slave.reset)
        except GyroError:
            self.slave.freeInstance()
            raise

    def set_values(self, values: Mapping[str, float]) -> None:
        """Set variables by name, SI, those of one type in one call."""
        kinds = self.archive.kinds
        references = dict(zip(values, self.archive.find_references(values).tolist(), strict=True))
        integers = {name: value for name, value in values.items() if kinds[name] == "Integer"}
        for name, value in integers.items():
            if value != int(value):
                raise GyroError(f"{name}: {value:g} is no integer")
        reals = {name: value for name, value in values.items() if name not in integers}
        if reals:
            numbers = [references[name] for name in reals]
            self._call(self.slave.setReal, numbers, [*reals.values()])
        if integers:
            numbers = [references[name] for name in integers]
            self._call(self.slave.setInteger, numbers, [int(each) for each in integers.values()])

    def explain(self, otherwise: str) -> str:
        """What the FMU logged since it was last asked; another text if it logged nothing."""
        text = "; ".join(self._messages) or otherwise
        self._messages.clear()
        return text

    def _call(self, function: Callable[..., Any], *args: Any, **kwargs: Any) -> None:
        try:
            function(*args, **kwargs)
        except Exception as error:  # FMPy raises a bare Exception for a status that is not OK
            raise GyroError(self.explain(str(error))) from error
