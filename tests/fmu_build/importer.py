"""One way to drive the FMU of either standard: FMPy's own calls, by variable name."""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import fmpy
import pytest
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.fmi3 import FMU3Slave


class Importer:
    """An instance; `messages` are what it logged: (category, text)."""

    def __init__(self, folder: Path, logging: bool = False, **options: Any) -> None:
        """Instantiate the extracted FMU.

        Args:
            folder: the extracted FMU.
            logging: whether the instance starts with debug logging on.
            options: further arguments of FMPy's `FMU3Slave.instantiate`.
        """
        self.description = fmpy.read_model_description(str(folder))
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.messages: list[tuple[str, str]] = []
        self.fmi = int(self.description.fmiVersion[0])
        self.slave = {2: FMU2Slave, 3: FMU3Slave}[self.fmi](
            guid=self.description.guid or self.description.instantiationToken,
            unzipDirectory=str(folder),
            modelIdentifier=self.description.modelName,
            instanceName="tested",
        )
        if self.fmi == 2:
            self._callbacks = fmi2CallbackFunctions()
            self._callbacks.logger = fmi2CallbackLoggerTYPE(self._log2)
            self.slave.instantiate(callbacks=self._callbacks, loggingOn=logging)
        else:
            self.slave.instantiate(logMessage=self._log3, loggingOn=logging, **options)

    def _log2(self, env: Any, name: bytes, status: int, category: bytes, text: bytes) -> None:
        self.messages.append((category.decode(), text.decode()))

    def _log3(self, env: Any, status: int, category: bytes, text: bytes) -> None:
        self.messages.append((category.decode(), text.decode()))

    def references(self, names: Iterable[str]) -> list[int]:
        """Value references of variables."""
        return [self.variables[name].valueReference for name in names]

    def enter(self, start: float = 0.0) -> None:
        """Enter initialization."""
        if self.fmi == 2:
            self.slave.setupExperiment(startTime=start)
            self.slave.enterInitializationMode()
        else:
            self.slave.enterInitializationMode(startTime=start)

    def set(self, values: Mapping[str, float]) -> None:
        """Set variables."""
        for name, value in values.items():
            kind = self.variables[name].type
            getattr(self.slave, f"set{kind}")(self.references([name]), [value])

    def get(self, names: Iterable[str]) -> list[float]:
        """Values of real variables."""
        get = self.slave.getReal if self.fmi == 2 else self.slave.getFloat64
        return list(get(self.references(names)))

    def every(self) -> list[float]:
        """Values of all real variables."""
        return self.get(n for n, v in self.variables.items() if v.type in ("Real", "Float64"))

    def begin(self, parameters: Mapping[str, float], start: float = 0.0) -> "Importer":
        """Initialize with these values."""
        self.enter(start)
        self.set(parameters)
        self.slave.exitInitializationMode()
        return self

    def save(self) -> bytes:
        """The state as bytes."""
        letter = {2: "s", 3: "S"}[self.fmi]
        state = getattr(self.slave, f"getFMU{letter}tate")()
        serialized = getattr(self.slave, f"serializeFMU{letter}tate")(state)
        getattr(self.slave, f"freeFMU{letter}tate")(state)
        return bytes(serialized)

    def restore(self, serialized: bytes) -> None:
        """Take a saved state."""
        read = {2: "deSerializeFMUstate", 3: "deserializeFMUState"}[self.fmi]
        letter = {2: "s", 3: "S"}[self.fmi]
        state = getattr(self.slave, read)(serialized)
        try:
            getattr(self.slave, f"setFMU{letter}tate")(state)
        finally:
            getattr(self.slave, f"freeFMU{letter}tate")(state)

    def derivative(
        self, unknowns: Iterable[str], knowns: Iterable[str], seed: Iterable[float]
    ) -> list[float]:
        """Directional derivatives of the unknowns."""
        arguments = self.references(unknowns), self.references(knowns), list(seed)
        return list(self.slave.getDirectionalDerivative(*arguments))

    def refused(self, call: Callable[[], object]) -> str:
        """What was logged about a call that must fail.

        Raises:
            pytest.fail.Exception: it did not.
        """
        self.messages.clear()
        with pytest.raises(Exception, match="fmi"):  # FMPy's own, for a status that is not OK
            call()
        assert self.messages
        return self.messages[-1][1]

    def free(self) -> None:
        """End the instance."""
        self.slave.freeInstance()
