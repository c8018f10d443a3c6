"""Compile the generated C and pack it into an FMU."""

import hashlib
import os
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable
from importlib import resources
from importlib.metadata import version
from pathlib import Path

import fmpy
import platformdirs

from fmu_build.dae import Dae
from fmu_build.description import fmi_causality, model_description
from fmu_build.generate import generate, header
from fmu_build.translate import COMPILER_VERSION, translate

IDENTIFIER = "HRG"
MODEL = "HRG.Gyroscopes.HRG"
DESCRIPTION = "Whole-angle hemispherical resonator gyro with its control electronics"
COMPILER = [sys.executable, "-m", "ziglang", "cc"]
FLAGS = ["-target", "x86_64-linux-gnu.2.17", "-std=c99", "-O2", "-ffp-contract=off"]
FLAGS += ["-fno-math-errno", "-fno-sanitize=all", "-fPIC", "-shared", "-s", "-Wall", "-Wextra"]
SOURCES = ("model.c", "core.c", "limits.c", "fmi2.c")

Progress = Callable[[str], None]


class BuildError(Exception):
    """The C compiler refused the generated sources."""


def modelica_library() -> Path:
    """Folder of the Modelica library that this distribution holds."""
    return Path(str(resources.files("modelica").joinpath("HRG")))


def built_fmu(progress: Progress = lambda text: None) -> Path:
    """Path of an FMU of the present sources: from the user's cache, built if it isn't there."""
    path = platformdirs.user_cache_path("hrg") / sources_digest()[:16] / f"{IDENTIFIER}.fmu"
    if not path.exists():
        build(path, progress)
    return path


def build(path: Path, progress: Progress = lambda text: None) -> None:
    """Translate, compile and pack the gyro; `path` appears only when all is done.

    Raises:
        TranslationError, BuildError, OSError.
    """
    progress(f"translating {MODEL}")
    dae = translate(modelica_library(), MODEL)
    files = generated_files(dae)
    with tempfile.TemporaryDirectory(prefix="hrg-build-") as folder:
        progress("compiling")
        library = compile_library(files, Path(folder))
        content = {f"binaries/linux64/{IDENTIFIER}.so": library.read_bytes()}
        content["modelDescription.xml"] = files["modelDescription.xml"].encode()
        for name in SOURCES:
            content[f"sources/{name}"] = (library.parent / name).read_bytes()
        path.parent.mkdir(parents=True, exist_ok=True)
        aside = path.with_name(f".{path.name}.{os.getpid()}")
        _zip(aside, content)
        aside.replace(path)
    progress(f"built {path}")


def sources_digest() -> str:
    """Digest of all that determines the FMU: Modelica, generator, C, tools."""
    digest = hashlib.sha256(f"{COMPILER_VERSION} {version('ziglang')} {FLAGS}".encode())
    package = Path(__file__).parent
    for root, pattern in ((modelica_library(), "**/*.mo"), (package, "*.py"), (package, "c/*")):
        for file in sorted(root.glob(pattern)):
            digest.update(file.relative_to(root).as_posix().encode())
            digest.update(file.read_bytes())
    return digest.hexdigest()


def generated_files(dae: Dae) -> dict[str, str]:
    """Text of every generated file, by name."""
    equations = generate(dae)
    guid = hashlib.sha256((equations + _limits(dae, "")).encode()).hexdigest()[:32]
    return {
        "model.c": equations,
        "model_constants.h": header(dae),
        "limits.c": _limits(dae, guid),
        "modelDescription.xml": model_description(
            dae, IDENTIFIER, DESCRIPTION, guid, version("hrg")
        ),
    }


def compile_library(files: dict[str, str], folder: Path) -> Path:
    """Shared library of the generated files and the FMI shell, in an empty folder.

    Raises:
        BuildError: with the compiler's words.
    """
    for name, text in files.items():
        (folder / name).write_text(text)
    for source in (Path(__file__).parent / "c").iterdir():
        (folder / source.name).write_bytes(source.read_bytes())
    headers = Path(fmpy.__file__).parent / "c-code"
    library = folder / f"{IDENTIFIER}.so"
    command = [*COMPILER, *FLAGS, f"-I{headers}", "-o", library.name, *SOURCES, "-lm"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise BuildError(f"the C compiler failed:\n{run.stderr}")
    return library


def _limits(dae: Dae, guid: str) -> str:
    lines = [
        '#include "limits.h"',
        "#include <math.h>",
        f'const char *const model_guid = "{guid}";',
    ]
    lines.append("const Limits limits[] = {")
    kinds = {"parameter": "SET_PARAMETER", "input": "SET_INPUT"}
    for variable in dae.variables:
        kind = kinds.get(fmi_causality(dae, variable), "SET_NEVER")
        low, high = dae.literal(variable.minimum), dae.literal(variable.maximum)
        bounds = f"{-1e300 if low is None else low!r}, {1e300 if high is None else high!r}"
        whole = int(variable.scalar == "integer")
        for element in range(variable.count):
            name = variable.element_name(element)
            lines.append(f'  {{"{name}", {kind}, {whole}, {bounds}}},')
    return "\n".join([*lines, "};", ""])


def _zip(path: Path, content: dict[str, bytes]) -> None:
    """Sorted names and fixed times: the same content gives the same bytes."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(content):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content[name])
