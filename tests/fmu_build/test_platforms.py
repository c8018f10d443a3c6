"""Binaries of the other platforms give the same bits: under wine and qemu.

Nothing here can run the binaries for macOS; `test_binaries.py` looks at what is in them.
"""

import os
from pathlib import Path

import fmpy
import pytest

from fmu_build.platforms import COMPILER, PLATFORMS
from tests.fmu_build import native

SETTINGS = {
    "n": {"seed": 5},
    "p": {
        "startAngle": 0.4,
        "noise.angleRandomWalk": 1e-9,
        "noise.pickOff": 1e-12,
        "resonator.material.dampingAnisotropy": 1e-6,
        "pickOff.gainMismatch": 1e-3,
    },
    "i": {"angularRate": 2.0, "accelerationX": 50.0, "phaseOffset": 1e-3},
    "o": dict.fromkeys(("gyroAngle", "gyroRate", "patternAngle", "amplitude", "quadrature"), 0),
}
SETTINGS["o"] |= dict.fromkeys(("amplitudeForce", "quadratureForce", "frequencyOffset", "valid"), 0)
STEPS = 300
"""Lines that the host prints: 100, and twice 100 from the middle on."""


def _library(folders: dict[int, Path], fmi: int, name: str) -> Path:
    platform = PLATFORMS[name]
    inner = platform.fmi2_folder if fmi == 2 else name
    return folders[fmi] / "binaries" / str(inner) / f"HRG{platform.suffix}"


def _host(folder: Path, fmi: int, name: str) -> Path:
    """The host program for a platform."""
    platform = PLATFORMS[name]
    program = folder / ("host.exe" if platform.suffix == ".dll" else "host")
    flags = ["-target", platform.target, "-std=c99", "-O1", f"-DFMI={fmi}", f"-I{native.HEADERS}"]
    libraries = [] if platform.suffix == ".dll" else ["-ldl"]
    source = native.HERE / "host.c"
    native.run([*COMPILER, *flags, source, *libraries, "-o", program], seconds=300)
    return program


def _arguments(folder: Path) -> list[str]:
    description = fmpy.read_model_description(str(folder))
    references = {v.name: v.valueReference for v in description.modelVariables}
    settings = [
        f"{kind}:{references[name]}:{value!r}"
        for kind, values in SETTINGS.items()
        for name, value in values.items()
    ]
    return [description.guid or description.instantiationToken, *settings]


def _native(folders: dict[int, Path], tmp_path: Path, fmi: int, *wrapper: str) -> list[str]:
    program = _host(tmp_path, fmi, "x86_64-linux")
    library = _library(folders, fmi, "x86_64-linux")
    command = [*wrapper, program, library, *_arguments(folders[fmi])]
    return native.run(command, seconds=300).splitlines()


def test_what_follows_a_restored_state_is_the_same_again(
    folders: dict[int, Path], tmp_path: Path
) -> None:
    lines = _native(folders, tmp_path, 3)
    assert len(lines) == STEPS
    assert lines[100:200] == lines[200:]
    assert len(set(lines)) == 200
    assert lines == _native(folders, tmp_path, 2)


@pytest.mark.parametrize("fmi", [2, 3])
def test_windows_gives_the_same_bits(folders: dict[int, Path], tmp_path: Path, fmi: int) -> None:
    program = _host(tmp_path, fmi, "x86_64-windows")
    library = _library(folders, fmi, "x86_64-windows")
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    environment |= {"WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all"}
    environment["WINEDLLOVERRIDES"] = "mscoree,mshtml="  # no questions about Mono and Gecko
    command = [native.tool("wine"), program, f"Z:{library}", *_arguments(folders[fmi])]
    lines = native.run(command, seconds=180, env=environment).splitlines()
    assert lines == _native(folders, tmp_path, fmi)


def test_arm_gives_the_same_bits(folders: dict[int, Path], tmp_path: Path) -> None:
    emulator = [native.tool("qemu-aarch64-static"), "-L", "/usr/aarch64-linux-gnu"]
    program = _host(tmp_path, 3, "aarch64-linux")
    library = _library(folders, 3, "aarch64-linux")
    lines = native.run([*emulator, program, library, *_arguments(folders[3])]).splitlines()
    assert lines == _native(folders, tmp_path, 3)


def test_memory_checker_finds_nothing(folders: dict[int, Path], tmp_path: Path) -> None:
    """No invalid access, no value that was never set, no leak."""
    checker = [native.tool("valgrind"), "--quiet", "--error-exitcode=9", "--leak-check=full"]
    assert len(_native(folders, tmp_path, 3, *checker)) == STEPS
