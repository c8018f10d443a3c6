"""The kernel's own transcendental functions against the C library's."""

import ctypes
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from fmu_build import bundle
from fmu_build.binaries import platforms

SOURCE = """
#include "arithmetic.h"
#define API __attribute__((visibility("default")))
API double sine(double x) { return m_sin(x); }
API double cosine(double x) { return m_cos(x); }
API double arctangent(double y, double x) { return m_atan2(y, x); }
API double logarithm(double x) { return m_log(x); }
API double exponential(double x) { return m_exp(x); }
API double floored(double x) { return m_floor(x); }
"""
ULP = np.finfo(float).eps


@pytest.fixture(scope="module")
def kernel(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    return compile_kernel(tmp_path_factory.mktemp("arithmetic"), "a", SOURCE)


def compile_kernel(folder: Path, name: str, source: str) -> ctypes.CDLL:
    (folder / f"{name}.c").write_text(source)
    headers = Path(bundle.__file__).parent / "c"
    command = [*platforms.COMPILER, *platforms.FLAGS, "-shared", "-fPIC", f"-I{headers}"]
    command += ["-o", f"{name}.so", f"{name}.c"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return ctypes.CDLL(str(folder / f"{name}.so"))


def evaluate(kernel: ctypes.CDLL, name: str, *arguments: np.ndarray) -> np.ndarray:
    function = getattr(kernel, name)
    function.restype = ctypes.c_double
    function.argtypes = [ctypes.c_double] * len(arguments)
    return np.array([function(*map(float, row)) for row in zip(*arguments, strict=True)])


@pytest.mark.parametrize(
    ("name", "reference", "sample"),
    [
        ("sine", np.sin, lambda r: (r.uniform(-1e5, 1e5, 20_000),)),
        ("cosine", np.cos, lambda r: (r.uniform(-1e5, 1e5, 20_000),)),
        ("arctangent", np.arctan2, lambda r: (r.normal(size=20_000), r.normal(size=20_000))),
        ("exponential", np.exp, lambda r: (r.uniform(-600, 600, 20_000),)),
        ("logarithm", np.log, lambda r: (np.exp(r.uniform(-30, 30, 20_000)),)),
    ],
)
def test_function_is_accurate(
    kernel: ctypes.CDLL,
    name: str,
    reference: Callable[..., np.ndarray],
    sample: Callable[[np.random.Generator], tuple[np.ndarray, ...]],
) -> None:
    arguments = sample(np.random.default_rng(1))
    expected = reference(*arguments)
    error = np.abs(evaluate(kernel, name, *arguments) - expected)
    floor = 0.0 if name == "exponential" else 0.1
    assert np.max(error / np.maximum(np.abs(expected), floor)) < 2 * ULP


def test_arctangent_on_the_axes(kernel: ctypes.CDLL) -> None:
    y, x = np.array([0.0, 1.0, 0.0, -1.0, 0.0]), np.array([1.0, 0.0, -1.0, 0.0, 0.0])
    assert np.array_equal(evaluate(kernel, "arctangent", y, x), np.arctan2(y, x))


def test_exponential_beyond_a_double(kernel: ctypes.CDLL) -> None:
    x = np.array([-1e9, -1500.0, 1500.0, 1e9, np.nan])
    ends = np.array([0.0, 0.0, np.inf, np.inf, np.nan])
    np.testing.assert_array_equal(evaluate(kernel, "exponential", x), ends)


def test_floor_at_and_beside_whole_numbers(kernel: ctypes.CDLL) -> None:
    whole = np.array([-3.0, -1.0, 0.0, 1.0, 2.0, 1e9])
    x = np.concatenate([np.nextafter(whole, -np.inf), whole, np.nextafter(whole, np.inf), [0.5]])
    assert np.array_equal(evaluate(kernel, "floored", x), np.floor(x))


LANES_SOURCE = """
#define LANES 4
#include "arithmetic.h"
#define API __attribute__((visibility("default")))
#define EACH(name, expression)                                  \\
  API void name(const double *a, const double *b, double *to) { \\
    real x, y, value;                                           \\
    memcpy(&x, a, sizeof x), memcpy(&y, b, sizeof y);           \\
    value = (expression);                                       \\
    memcpy(to, &value, sizeof value);                           \\
  }
EACH(sine, m_sin(x))
EACH(cosine, m_cos(x))
EACH(arctangent, m_atan2(x, y))
EACH(logarithm, m_log(m_abs(x) + 1e-300))
EACH(exponential, m_exp(x / 2000.0))
EACH(floored, m_floor(x))
"""
SINGLE_SOURCE = LANES_SOURCE.replace("#define LANES 4\n", "")


@pytest.mark.parametrize(
    "name", ["sine", "cosine", "arctangent", "logarithm", "exponential", "floored"]
)
def test_lanes_compute_the_same_bits(tmp_path: Path, name: str) -> None:
    generator = np.random.default_rng(2)
    scale = 10.0 ** generator.integers(-20, 6, size=20_000)
    x, y = generator.uniform(-1, 1, size=(2, 20_000)) * scale
    x[::97], y[::89] = 0.0, -0.0
    x[5::101], y[7::103] = 1e9, np.inf
    lanes, single = (
        compile_kernel(tmp_path, each, text)
        for each, text in (("lanes", LANES_SOURCE), ("single", SINGLE_SOURCE))
    )
    found = np.array([call(lanes, name, x[i : i + 4], y[i : i + 4]) for i in range(0, len(x), 4)])
    expected = np.array([call(single, name, x[i:], y[i:])[0] for i in range(len(x))])
    if name == "exponential":
        expected[np.abs(x) > 1e6] = found.ravel()[np.abs(x) > 1e6] = 0.0  # beyond its range
    assert np.array_equal(found.ravel(), expected, equal_nan=True)


def call(library: ctypes.CDLL, name: str, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    x, y, to = np.ascontiguousarray(x), np.ascontiguousarray(y), np.empty(4)
    getattr(library, name)(*(ctypes.c_void_p(each.ctypes.data) for each in (x, y, to)))
    return to
