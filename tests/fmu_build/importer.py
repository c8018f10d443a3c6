"""One way to drive the FMU of either standard: FMPy's own calls, by name of scalar."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import accumulate
from pathlib import Path
from typing import Any

import fmpy
import pytest
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.fmi3 import FMU3Slave
from fmpy.model_description import ModelVariable


def list_elements(variable: ModelVariable) -> list[str]:
    """Names of a variable's scalars."""
    if not variable.dimensions:
        return [variable.name]
    return [f"{variable.name}[{e + 1}]" for e in range(variable.dimensions[0].start)]


class Importer:
    """An instance; `messages` are what it logged: (category, text).

    An element of an array of FMI 3 is a variable here, with the array's reference.
    """

    def __init__(self, folder: Path, logging: bool = False, **options: Any) -> None:
        """Instantiate the extracted FMU.

        Args:
            folder: the extracted FMU.
            logging: whether the instance starts with debug logging on.
            options: further arguments of FMPy's `FMU3Slave.instantiate`.
        """
        self.description = fmpy.read_model_description(str(folder))
        described = self.description.modelVariables
        self.variables = {name: v for v in described for name in list_elements(v)}
        self._counts = {v.valueReference: len(list_elements(v)) for v in described}
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
        """Set variables. The other elements of an array stay."""
        for name, value in values.items():
            (reference,) = self.references([name])
            given = [value]
            if self._counts[reference] > 1:
                given = self.slave.getFloat64([reference], self._counts[reference])
                given[self._find_element(name)] = value
            getattr(self.slave, f"set{self.variables[name].type}")([reference], given)

    def get(self, names: Iterable[str]) -> list[float]:
        """Values of real variables."""
        names = list(names)
        references = self.references(names)
        if self.fmi == 2:
            return list(self.slave.getReal(references))
        distinct = list(dict.fromkeys(references))
        values = self.slave.getFloat64(distinct, sum(self._counts[r] for r in distinct))
        begins = self._list_begins(distinct)
        return [
            values[begins[r] + self._find_element(n)]
            for r, n in zip(references, names, strict=True)
        ]

    def _list_begins(self, references: Sequence[int]) -> dict[int, int]:
        """Place of each variable's first value among the values of all."""
        ends = accumulate(self._counts[r] for r in references)
        return {r: end - self._counts[r] for r, end in zip(references, ends, strict=True)}

    def _find_element(self, name: str) -> int:
        return list_elements(self.variables[name]).index(name)

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
        distinct = list(dict.fromkeys(self.references(knowns := list(knowns))))
        begins = self._list_begins(distinct)
        seeds = [0.0] * sum(self._counts[r] for r in distinct)
        for name, value in zip(knowns, seed, strict=True):
            seeds[begins[self.references([name])[0]] + self._find_element(name)] = value
        arguments = self.references(unknowns), distinct, seeds
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
