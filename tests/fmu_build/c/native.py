"""The tests' own C programs: found, compiled, run. A test that calls a tool is marked `needs`."""

import shutil
import subprocess
import tempfile
from functools import lru_cache
from pathlib import Path

import fmpy

from fmu_build.bundle import SHELLS, SOURCES, find_modelica_library, write_sources
from fmu_build.equations.dae import Dae
from fmu_build.equations.translate import translate
from fmu_build.roots import ROOTS

HERE = Path(__file__).parent
HEADERS = Path(fmpy.__file__).parent / "c-code"
SANITIZERS = "address,undefined,float-cast-overflow"


def tool(name: str) -> str:
    """Path of a program.

    Raises:
        AssertionError: it is not installed.
    """
    path = shutil.which(name)
    assert path, f"{name} is not installed; the tests need it (see CONTRIBUTING.md)"
    return path


@lru_cache
def flat(root: str = "HRG") -> Dae:
    """The flat model of an FMU."""
    return translate(find_modelica_library(), ROOTS[root].model)


def run(command: list[str | Path], seconds: float = 120, **options: object) -> str:
    """Standard output of a program that must succeed.

    Raises:
        AssertionError: it failed; with what it said.
        subprocess.TimeoutExpired: it hangs.
    """
    # Into files: a server that outlives the program would hold a pipe open.
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        done = subprocess.run(
            command, stdout=out, stderr=err, timeout=seconds, check=False, **options
        )  # type: ignore[call-overload]
        out.seek(0)
        err.seek(0)
        assert done.returncode == 0, err.read().decode()[-4000:]
        return str(out.read().decode())


def fuzzer(folder: Path, fmi: int, root: str = "HRG", optimization: str = "-O0") -> Path:
    """The fuzzer, linked with an FMU's sources under the sanitizers. For some thousand calls,
    optimizing takes longer than it saves."""
    write_sources(flat(root), folder, fmi, ROOTS[root])
    flags = ["-std=c99", optimization, "-g"]
    flags += [f"-fsanitize={SANITIZERS}", "-fno-sanitize-recover=all"]
    flags += [f"-DFMI={fmi}", "-I.", f"-I{HEADERS}", f"-I{HERE}"]
    sources = [HERE / "fuzz.c", SHELLS[fmi], *SOURCES]
    run([tool("gcc"), *flags, *sources, "-lm", "-o", "fuzz"], seconds=600, cwd=folder)
    return folder / "fuzz"
