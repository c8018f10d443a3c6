"""Models of the library as FMUs of this machine: found by package, built, run."""

import hashlib
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from itertools import count
from pathlib import Path
from typing import Any

import fmpy
import pymoca.ast
import pymoca.parser
from fmpy.fmi2 import FMU2Slave

from fmu_build.binaries.platforms import (
    FLAGS,
    PLATFORMS,
    compile_library,
    find_compiler_version,
    find_host_platform,
)
from fmu_build.bundle import SHELLS, SOURCES, digest_sources, find_modelica_library, write_sources
from fmu_build.equations.translate import open_session, translate
from fmu_build.roots import ROOTS, Root
from pyhrg.common.caches.files import find_cache_folder
from pyhrg.common.files import make_aside

IDENTIFIER = "Model"
UNIT = "unit.c"
"""Includes all C sources: one call of the compiler reads the headers once."""
LONGEST_UNOPTIMIZED = {"runge_kutta_4": 150.0, "midpoint": 1500.0}
"""Stop time, by integrator, up to which optimizing a model takes longer than it saves, s."""


@dataclass(frozen=True)
class Model:
    """A model that can be run.

    name: in full.
    stop_time: of its experiment, s.
    info: its info page.
    text: of its file.
    is_own: whether that file is the library's.
    integrator: of the FMU (`fmu_build.roots`).
    """

    name: str
    stop_time: float
    info: str
    text: str
    is_own: bool = True
    integrator: str = ROOTS["HRG"].integrator

    def made_of(self, gyro: Root) -> "Model":
        """This model with its replaceable `Gyro` redeclared, under a name of its own."""
        name = f"{self.name.replace('.', '_')}_{gyro.identifier}"
        redeclaration = f"redeclare model Gyro = {gyro.model}"
        text = f'model {name} "{name}" extends {self.name}({redeclaration}); end {name};'
        return replace(self, name=name, text=text, is_own=False, integrator=gyro.integrator)


def defined(path: Path) -> pymoca.ast.Class:
    """The class that a file defines, found by the file's place in the library."""
    place = path.parent if path.name == "package.mo" else path.with_suffix("")
    found = pymoca.parser.parse(path.read_text())
    assert found is not None, "not Modelica"
    for name in place.relative_to(find_modelica_library().parent).parts:
        found = found.classes[name]
    return found


def models(package: str) -> list[Model]:
    """All models below a package of the library; its `BaseClasses` are none.

    Raises:
        ValueError: one states no experiment or has no info page.
    """
    files = sorted((find_modelica_library() / package).rglob("*.mo"))
    return [
        _model(path)
        for path in files
        if path.name != "package.mo" and path.parent.name != "BaseClasses"
    ]


def _model(path: Path) -> Model:
    annotation = modifiers(defined(path).annotation)
    if not annotation.keys() >= {"experiment", "Documentation"}:
        raise ValueError(f"{path.name}: expected annotation(experiment, Documentation)")
    return Model(
        name=".".join(path.with_suffix("").relative_to(find_modelica_library().parent).parts),
        stop_time=float(modifiers(annotation["experiment"])["StopTime"].value),
        info=str(modifiers(annotation["Documentation"])["info"].value),
        text=path.read_text(),
    )


def modifiers(clause: pymoca.ast.ClassModification | None) -> dict[str, pymoca.ast.Node]:
    """First modification of each name."""
    arguments = clause.arguments if clause else []
    return {a.value.component.name: a.value.modifications[0] for a in arguments}


class ModelFmu:
    """A model's FMU, to be powered on again and again."""

    def __init__(self, slave: FMU2Slave, description: fmpy.model_description.ModelDescription):
        self._slave = slave
        self._variables = {v.name: v for v in description.modelVariables}

    def outputs(self) -> list[str]:
        """Names of its outputs."""
        return [v.name for v in self._variables.values() if v.causality == "output"]

    def power_on(self, parameters: Mapping[str, float], start: float = 0.0) -> None:
        """Initialize at a time, after a reset."""
        self._slave.reset()
        self._slave.setupExperiment(startTime=start)
        self._slave.enterInitializationMode()
        for name, value in parameters.items():
            variable = self._variables[name]
            if variable.type == "Integer":
                self._slave.setInteger([variable.valueReference], [int(value)])
            else:
                self._slave.setReal([variable.valueReference], [value])
        self._slave.exitInitializationMode()

    def advance(self, time: float, step: float) -> None:
        """From a time on, s."""
        self._slave.doStep(time, step)

    def read(self, names: Sequence[str]) -> list[float]:
        """Present values."""
        return list(self._slave.getReal([self._variables[n].valueReference for n in names]))


@contextmanager
def built(model: Model) -> Iterator[ModelFmu]:
    """Translate, compile and load a model.

    Raises:
        HrgError, BuildError.
    """
    folder = str(_fetch(model))
    description = fmpy.read_model_description(folder, validate=False)
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=IDENTIFIER,
        instanceName=model.name,
    )
    slave.instantiate()
    try:
        yield ModelFmu(slave, description)
    finally:
        slave.freeInstance()


def _fetch(model: Model) -> Path:
    """Folder of an extracted FMU in the user's cache, made of the present sources."""
    made_of = f"{_digest_sources()} {find_compiler_version()} {model} {Path(__file__).read_text()}"
    digest = hashlib.sha256(made_of.encode()).hexdigest()[:16]
    folder = find_cache_folder() / "models" / f"{model.name}-{digest}"
    if folder.exists():
        return folder
    folder.parent.mkdir(exist_ok=True)
    with make_aside(folder) as aside:
        _write(model, aside)
        for old in folder.parent.glob(f"{model.name}-*"):
            shutil.rmtree(old, ignore_errors=True)
        with suppress(OSError):  # another process was faster
            aside.rename(folder)
    return folder


_digest_sources = cache(digest_sources)
_number = count()


@lru_cache(maxsize=1)
def _share_session(group: int) -> Any:
    """A session of the Modelica compiler for a group of models. It keeps 15 MB for each."""
    return open_session()


def _write(model: Model, folder: Path) -> None:
    """An FMU, extracted."""
    platform = PLATFORMS[find_host_platform()]
    root = Root(IDENTIFIER, model.name, model.name, model.integrator, "0.01")
    text = "" if model.is_own else model.text
    dae = translate(
        find_modelica_library(), model.name, text, session=_share_session(next(_number) // 8)
    )
    description = write_sources(dae, folder, 2, root)
    flags = [*FLAGS, "-O0"] if model.stop_time <= LONGEST_UNOPTIMIZED[model.integrator] else FLAGS
    (folder / UNIT).write_text("".join(f'#include "{file}"\n' for file in (*SOURCES, SHELLS[2])))
    library = compile_library(folder, [UNIT], IDENTIFIER, platform, flags)
    (folder / "modelDescription.xml").write_text(description)
    binaries = folder / "binaries" / str(platform.fmi2_folder)
    binaries.mkdir(parents=True)
    (binaries / f"{IDENTIFIER}{platform.suffix}").write_bytes(library)
