"""What is in the binaries: the FMI functions and no others, for systems as old as promised."""

import re
from collections.abc import Iterator
from pathlib import Path

import lief

from tests.fmu_build.c import native

NEWEST_GLIBC = (2, 17)
OLDEST_MACOS = [11, 0, 0]
WINDOWS = re.compile(r"(api-ms-win-crt-[a-z0-9-]+|kernel32)\.dll")
LINKER_SYMBOLS = {"__mh_dylib_header", "___dso_handle"}
"""Of every Mach-O library."""


def _functions(fmi: int) -> set[str]:
    """What the standard's header declares, less what FMI 2.0 has for model exchange only."""
    text = (native.HEADERS / f"fmi{fmi}Functions.h").read_text()
    if fmi == 2:
        first, last = (
            text.rindex(f"for FMI2 for {x}") for x in ("Model Exchange", "Co-Simulation")
        )
        text = text[:first] + text[last:]
    return set(re.findall(rf"FMI{fmi}_Export\s+fmi\w+TYPE\s+(fmi\w+);", text))


def _binaries(folders: dict[int, Path], suffix: str) -> Iterator[tuple[int, Path]]:
    found = [(f, p) for f in (2, 3) for p in sorted(folders[f].glob(f"binaries/*/*{suffix}"))]
    assert found
    yield from found


def test_header_declares_what_is_looked_for() -> None:
    assert {"fmi2DoStep", "fmi2GetTypesPlatform"} < _functions(2)
    assert {"fmi3DoStep", "fmi3SetTime", "fmi3GetClock"} < _functions(3)


def test_linux(folders: dict[int, Path]) -> None:
    kinds = set()
    for fmi, path in _binaries(folders, ".so"):
        binary = lief.ELF.parse(str(path))
        assert {str(s.name) for s in binary.exported_symbols} == _functions(fmi), path
        assert set(binary.libraries) <= {"libc.so.6", "libm.so.6"}, path
        for needed in binary.symbols_version_requirement:
            for version in needed.get_auxiliary_symbols():
                number = re.fullmatch(r"GLIBC_(\d+)\.(\d+)(\.\d+)?", str(version.name))
                assert number, version.name
                assert (int(number[1]), int(number[2])) <= NEWEST_GLIBC, (path, version.name)
        kinds.add((fmi, binary.header.machine_type.name))
    assert kinds == {(2, "X86_64"), (3, "X86_64"), (3, "AARCH64")}


def test_windows(folders: dict[int, Path]) -> None:
    for fmi, path in _binaries(folders, ".dll"):
        binary = lief.PE.parse(str(path))
        assert {e.name for e in binary.get_export().entries} == _functions(fmi), path
        imports = [i.name.lower() for i in binary.imports]
        assert all(WINDOWS.fullmatch(name) for name in imports), (path, imports)
        assert binary.header.machine.name == "AMD64"


def test_macos(folders: dict[int, Path]) -> None:
    kinds = []
    for fmi, path in _binaries(folders, ".dylib"):
        archive = lief.MachO.parse(str(path))
        for index in range(archive.size):
            binary = archive.at(index)
            names = {str(s.name) for s in binary.exported_symbols} - LINKER_SYMBOLS
            assert names == {f"_{name}" for name in _functions(fmi)}, path
            libraries = [x.name for x in binary.libraries]
            assert libraries == ["@rpath/HRG.dylib", "/usr/lib/libSystem.B.dylib"], path
            assert binary.header.file_type.name == "DYLIB"
            assert binary.build_version.minos == OLDEST_MACOS
            kinds.append((fmi, binary.header.cpu_type.name))
    assert sorted(kinds) == [(2, "ARM64"), (2, "X86_64"), (3, "ARM64"), (3, "X86_64")]
