"""Binaries of the other platforms give the same bits: under wine and qemu.

Nothing here can run the binaries for macOS; `test_binaries.py` looks at what is in them.
"""

import os
import zipfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import fmpy
import pytest

from fmu_build.binaries.platforms import COMPILER, FLAGS, PLATFORMS
from fmu_build.bundle import build_fmu
from fmu_build.roots import ROOTS
from tests.fmu_build.c import native

SETTINGS = {
    "n": {"seed": 5},
    "p": {
        "startAngle": 0.4,
        "noise.angleRandomWalk": 3e-5,
        "noise.pickOff": 1e-6,
        "resonator.material.dampingAnisotropy": 1e-6,
        "pickOff.gainMismatch": 1e-3,
    },
    "i": {"angularRate": 2.0, "accelerationX": 50.0, "phaseOffset": 1e-3},
    "x": {"biasVoltage": -1.25e6},
    "o": dict.fromkeys(("gyroAngle", "gyroRate", "patternAngle", "amplitude", "quadrature"), 0),
}
SETTINGS["o"] |= dict.fromkeys(("amplitudeForce", "quadratureForce", "frequencyOffset", "valid"), 0)
STEPS = 300
"""Lines that the host prints before what was refused: 100, and twice 100 from the middle on."""


RUNNABLE = ["x86_64-linux", "x86_64-windows", "aarch64-linux"]
NEEDS = {
    "x86_64-windows": pytest.mark.needs("wine"),
    "aarch64-linux": pytest.mark.needs("qemu-aarch64-static", "libc6-arm64-cross"),
}
CASES = [("x86_64-windows", 2, "HRG")]
CASES += [(name, 3, root) for root in ROOTS for name in RUNNABLE[1:]]


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Wine's own folder, made by the first program that runs."""
    return tmp_path_factory.mktemp("wine")


@pytest.fixture(scope="module")
def models(
    folders: dict[int, Path], tmp_path_factory: pytest.TempPathFactory
) -> dict[tuple[int, str], Path]:
    """By FMI version and model: the FMU for all that can be run here, extracted."""
    result = {(fmi, "HRG"): folder for fmi, folder in folders.items()}
    for root in ROOTS.values():
        if root.identifier != "HRG":
            path = build_fmu(root.identifier, fmi=3, platforms=RUNNABLE)
            result[3, root.identifier] = tmp_path_factory.mktemp(root.identifier)
            with zipfile.ZipFile(path) as archive:
                archive.extractall(result[3, root.identifier])
    return result


@pytest.fixture(scope="module")
def hosts(tmp_path_factory: pytest.TempPathFactory) -> Callable[[int, str], Path]:
    """Gives the host program for an FMI version and a platform; each is compiled once."""
    folder = tmp_path_factory.mktemp("hosts")
    return cache(lambda fmi, name: _compile_host(folder, fmi, name))


def _compile_host(folder: Path, fmi: int, name: str) -> Path:
    platform = PLATFORMS[name]
    program = folder / f"host-{name}-{fmi}.exe"
    flags = ["-target", platform.target, *FLAGS, "-s", f"-DFMI={fmi}", f"-I{native.HEADERS}"]
    sources = [native.HERE / "host.c"]
    if platform.suffix == ".dll":
        sources.append(native.HERE / "windows_start.c")
        flags += ["-Wl,-e,mainCRTStartup", *platform.runtime]
        flags += ["-lapi-ms-win-crt-runtime-l1-1-0", "-lkernel32"]
    else:
        flags += ["-ldl", *platform.runtime]
    native.run([*COMPILER, *sources, *flags, "-o", program])
    return program


def _arguments(folder: Path, fmi: int, name: str) -> list[str]:
    """Of the host: library, token, settings by reference."""
    description = fmpy.read_model_description(str(folder))
    platform = PLATFORMS[name]
    inner = str(platform.fmi2_folder if fmi == 2 else name)
    library = folder / "binaries" / inner / f"{description.modelName}{platform.suffix}"
    variables = {v.name: v for v in description.modelVariables}
    settings = [
        f"{'b' if variables[variable].type == 'Boolean' else kind}"
        f":{variables[variable].valueReference}:{value!r}"
        for kind, values in SETTINGS.items()
        for variable, value in values.items()
    ]
    drive = "Z:" if platform.suffix == ".dll" else ""
    return [f"{drive}{library}", description.guid or description.instantiationToken, *settings]


def _emulator(name: str) -> list[str]:
    if name == "x86_64-windows":
        return [native.tool("wine")]
    if name == "aarch64-linux":
        return [native.tool("qemu-aarch64-static"), "-L", "/usr/aarch64-linux-gnu"]
    return []


def _environment(prefix: Path) -> dict[str, str]:
    """Wine without a display, its messages, and its questions about Mono and Gecko."""
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    wine = {"WINEPREFIX": str(prefix), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml="}
    return environment | wine


@pytest.mark.parametrize(
    ("name", "fmi", "root"), [pytest.param(*case, marks=NEEDS[case[0]]) for case in CASES]
)
def test_other_platforms_give_the_same_bits(
    models: dict[tuple[int, str], Path],
    hosts: Callable[[int, str], Path],
    prefix: Path,
    name: str,
    fmi: int,
    root: str,
) -> None:
    def lines(platform: str) -> list[str]:
        arguments = _arguments(models[fmi, root], fmi, platform)
        command = [*_emulator(platform), hosts(fmi, platform), *arguments]
        return native.run(command, seconds=240, env=_environment(prefix)).splitlines()

    expected = lines("x86_64-linux")
    assert len(expected) == STEPS + 1
    assert expected[-1].startswith("# ")
    assert "-1250000" in expected[-1]
    assert lines(name) == expected


def test_what_follows_a_restored_state_is_the_same_again(
    folders: dict[int, Path], hosts: Callable[[int, str], Path]
) -> None:
    results = []
    for fmi, folder in folders.items():
        text = native.run([hosts(fmi, "x86_64-linux"), *_arguments(folder, fmi, "x86_64-linux")])
        results.append(text.splitlines())
    lines = results[0]
    assert lines[100:200] == lines[200:STEPS]
    assert len({line.split(" ", 1)[1] for line in lines[:STEPS]}) == 200
    assert results[1] == lines


@pytest.mark.needs("valgrind")
def test_memory_checker_finds_nothing(
    folders: dict[int, Path], hosts: Callable[[int, str], Path]
) -> None:
    """No invalid access, no value that was never set, no leak."""
    checker = [native.tool("valgrind"), "--quiet", "--error-exitcode=9", "--leak-check=full"]
    for fmi, folder in folders.items():
        arguments = _arguments(folder, fmi, "x86_64-linux")
        said = native.run([*checker, hosts(fmi, "x86_64-linux"), *arguments], seconds=300)
        assert len(said.splitlines()) == STEPS + 1
