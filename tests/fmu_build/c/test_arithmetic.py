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
    folder = tmp_path_factory.mktemp("arithmetic")
    (folder / "a.c").write_text(SOURCE)
    headers = Path(bundle.__file__).parent / "c"
    command = [*platforms.COMPILER, *platforms.FLAGS, "-shared", "-fPIC", f"-I{headers}"]
    command += ["-o", "a.so", "a.c"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return ctypes.CDLL(str(folder / "a.so"))


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


def test_floor_at_and_beside_whole_numbers(kernel: ctypes.CDLL) -> None:
    whole = np.array([-3.0, -1.0, 0.0, 1.0, 2.0, 1e9])
    x = np.concatenate([np.nextafter(whole, -np.inf), whole, np.nextafter(whole, np.inf), [0.5]])
    assert np.array_equal(evaluate(kernel, "floored", x), np.floor(x))
