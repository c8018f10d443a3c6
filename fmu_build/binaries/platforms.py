"""Platforms that an FMU can hold, and the C compiler that serves them all."""

import platform
import struct
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import fmpy

from pyhrg.common.errors import HrgError
from pyhrg.common.extras import import_extra

COMPILER = [sys.executable, "-m", "ziglang", "cc"]
PORTABLE_FLAGS = ["-O2", "-ffp-contract=off", "-fno-math-errno", "-fvisibility=hidden"]
FLAGS = ["-std=c99", *PORTABLE_FLAGS, "-fno-sanitize=all", "-Wall", "-Wextra"]
UCRT = ("stdio", "heap", "string", "math", "convert", "private")
"""Parts of Windows' own C runtime that are used."""
WINDOWS_RUNTIME = Path(__file__).parent / "windows" / "runtime.c"
WINDOWS_HEADERS = "lib/libc/include/any-windows-any"
"""Folder within the C compiler's."""


@dataclass(frozen=True)
class Platform:
    """A target: its names for the compiler and in the two standards' archives."""

    name: str
    target: str
    fmi2_folder: str | None
    suffix: str

    @property
    def runtime(self) -> list[str]:
        """Arguments of the compiler for the C runtime. The compiler's own, which the sources don't
        need, would be compiled before the first library."""
        if self.suffix != ".dll":
            return ["-lm", "-rtlib=none"]
        parts = [f"-lapi-ms-win-crt-{part}-l1-1-0" for part in UCRT]
        headers = Path(import_extra("ziglang").__file__).parent / WINDOWS_HEADERS
        return ["-nostdlib", "-isystem", str(headers), str(WINDOWS_RUNTIME), *parts]


PLATFORMS = {
    p.name: p
    for p in (
        Platform("x86_64-linux", "x86_64-linux-gnu.2.17", "linux64", ".so"),
        Platform("aarch64-linux", "aarch64-linux-gnu.2.17", None, ".so"),
        Platform("x86_64-windows", "x86_64-windows-gnu", "win64", ".dll"),
        Platform("x86_64-darwin", "x86_64-macos.11.0", "darwin64", ".dylib"),
        Platform("aarch64-darwin", "aarch64-macos.11.0", "darwin64", ".dylib"),
    )
}


class BuildError(HrgError):
    """The C compiler refused the generated sources, or there is nothing to build for."""


def find_compiler_version() -> str:
    """Version of the C compiler.

    Raises:
        HrgError: it is not installed.
    """
    import_extra("ziglang")
    return version("ziglang")


def find_host_platform() -> str:
    """Name of the platform that this process runs on."""
    machine = {"AMD64": "x86_64", "arm64": "aarch64"}.get(platform.machine(), platform.machine())
    name = f"{machine}-{platform.system().lower()}"
    if name not in PLATFORMS:
        raise BuildError(f"no FMU can be built for {name}; known are {', '.join(PLATFORMS)}")
    return name


def list_platforms(fmi: int) -> list[str]:
    """Platforms that archives of a version of the standard have a folder for."""
    return [p.name for p in PLATFORMS.values() if fmi == 3 or p.fmi2_folder]


def choose_platforms(names: Sequence[str], fmi: int) -> list[str]:
    """Platforms to build for: this machine's if none is named."""
    platforms = sorted(set(names)) or [find_host_platform()]
    for name in platforms:
        if name not in list_platforms(fmi):
            raise BuildError(f"FMI {fmi}.0 has no folder for {name}; use --fmi 3")
    return platforms


def compile_library(
    folder: Path,
    sources: Sequence[str],
    identifier: str,
    target: Platform,
    flags: Sequence[str] = FLAGS,
) -> bytes:
    headers = Path(fmpy.__file__).parent / "c-code"
    library = folder / target.name / f"{identifier}{target.suffix}"
    library.parent.mkdir()
    link = ["-shared", "-s", *(["-fPIC"] if target.suffix != ".dll" else [])]
    if target.suffix == ".dylib":
        link.append(f"-Wl,-install_name,@rpath/{library.name}")
    output = f"{target.name}/{library.name}"
    command = [*COMPILER, "-target", target.target, *flags, *link, f"-I{headers}", "-o", output]
    command += [*sources, *target.runtime]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise BuildError(f"the C compiler failed for {target.name}:\n{run.stderr}")
    return library.read_bytes()


def join_universal(libraries: list[bytes]) -> bytes:
    """One fat Mach-O of several thin ones, as `lipo -create` makes it."""
    alignment = 14
    offset = 1 << alignment
    header = struct.pack(">II", 0xCAFEBABE, len(libraries))
    body = b""
    for library in libraries:
        cpu, subtype = struct.unpack("<II", library[4:12])
        header += struct.pack(">IIIII", cpu, subtype, offset + len(body), len(library), alignment)
        body += library + b"\0" * (-len(library) % (1 << alignment))
    return header.ljust(offset, b"\0") + body


def place_binaries(libraries: Mapping[str, bytes], identifier: str, fmi: int) -> dict[str, bytes]:
    """Paths in an archive of the libraries of platforms, by name; FMI 2.0 has one folder for both
    kinds of Mac, and none for Linux on ARM."""
    folders: dict[str, list[bytes]] = {}
    for name, library in libraries.items():
        platform = PLATFORMS[name]
        folder = platform.fmi2_folder if fmi == 2 else name
        path = f"binaries/{folder}/{identifier}{platform.suffix}"
        folders.setdefault(path, []).append(library)
    return {path: x[0] if len(x) == 1 else join_universal(x) for path, x in folders.items()}
