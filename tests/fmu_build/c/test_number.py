"""Numbers and ranges in messages."""

import ctypes
from pathlib import Path

import pytest

import fmu_build
from tests.fmu_build.c import native

pytestmark = pytest.mark.needs("gcc")

SOURCES = Path(fmu_build.__file__).parent / "c"


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    path = tmp_path_factory.mktemp("number") / "number.so"
    native.run([native.tool("gcc"), "-shared", "-fPIC", SOURCES / "number.c", "-lm", "-o", path])
    return ctypes.CDLL(str(path))


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.005, "0.005"), (2147483647.0, "2147483647"), (1e7, "10000000"), (1e300, "1e+300")],
)
def test_shortest_digits(library: ctypes.CDLL, value: float, text: str) -> None:
    buffer = ctypes.create_string_buffer(32)
    library.number_text(ctypes.c_double(value), buffer)
    assert buffer.value.decode() == text


@pytest.mark.parametrize(
    ("low", "high", "text"),
    [
        (0.0, 0.1, " from 0 to 0.1"),
        (0.0, 1e300, " from 0 up"),
        (-1e300, -2.5, " up to -2.5"),
        (-1e300, 1e300, ": any number"),
    ],
)
def test_ranges_in_words(library: ctypes.CDLL, low: float, high: float, text: str) -> None:
    buffer = ctypes.create_string_buffer(80)
    library.range_text(ctypes.c_double(low), ctypes.c_double(high), buffer)
    assert buffer.value.decode() == text
