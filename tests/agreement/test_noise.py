"""The generator's normal quantile and streams against SciPy, in the compiled kernel."""

import ctypes
import subprocess

import numpy as np
import pytest
from scipy import stats

from fmu_build import bundle
from fmu_build.binaries.platforms import COMPILER, FLAGS
from fmu_build.equations.translate import translate
from fmu_build.roots import ROOTS

SOURCE = """
#include "model.c"
#define API __attribute__((visibility("default")))
API double central(double q) { return f_HRG_Noise_centralQuantile(q); }
API double tail(double p) { return f_HRG_Noise_tailQuantile(p); }
API void seeded(double seed, double *memory) { f_seededState(seed, memory); }
API void advance(const double *memory, double *next) { f_deviates(memory, next); }
"""
DRAWS = 20_000


@pytest.fixture(scope="module")
def kernel(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    folder = tmp_path_factory.mktemp("noise")
    root = ROOTS["HRG"]
    bundle.write_sources(translate(bundle.find_modelica_library(), root.model), folder, 2, root)
    (folder / "noise.c").write_text(SOURCE)
    command = [
        *COMPILER,
        *FLAGS,
        "-Wno-unused-function",
        "-shared",
        "-fPIC",
        "-o",
        "noise.so",
        "noise.c",
    ]
    subprocess.run(command, cwd=folder, check=True)
    library = ctypes.CDLL(str(folder / "noise.so"))
    for name in ("central", "tail"):
        getattr(library, name).restype = ctypes.c_double
        getattr(library, name).argtypes = [ctypes.c_double]
    return library


def draws(kernel: ctypes.CDLL, seed: int) -> np.ndarray:
    """(DRAWS, 11) eight normal and three uniform deviates a step."""
    memory = np.zeros(84)
    kernel.seeded(ctypes.c_double(seed), ctypes.c_void_p(memory.ctypes.data))
    following = np.zeros(84)
    result = np.empty((DRAWS, 11))
    for row in result:
        kernel.advance(ctypes.c_void_p(memory.ctypes.data), ctypes.c_void_p(following.ctypes.data))
        memory[:] = following
        row[:] = memory[72:83]
    return result


def test_quantile_is_the_normal_one(kernel: ctypes.CDLL) -> None:
    """Relative error below 1e-9 in the centre; 1e-13 in the tails, down to one draw in 2^32."""
    q = np.concatenate([-np.logspace(-4, np.log10(0.49), 4000), np.logspace(-4, -0.31, 4000)])
    q = q[np.abs(q) <= 0.49]
    central = np.array([kernel.central(x) for x in q])
    assert np.max(np.abs(central / stats.norm.ppf(0.5 + q) - 1)) < 1e-9
    p = np.logspace(np.log10(1 / 2**32), -2, 4000)
    tail = np.array([kernel.tail(x) for x in p])
    assert np.max(np.abs(tail / stats.norm.ppf(p) - 1)) < 1e-13


@pytest.mark.parametrize("seed", [0, 1, 2**31 - 1])
def test_deviates_are_normal_and_independent(kernel: ctypes.CDLL, seed: int) -> None:
    """20,000 draws of 8: Kolmogorov-Smirnov at 1e-4, correlations within 5 sigma."""
    values = draws(kernel, seed)
    for column in values[:, :8].T:
        assert stats.kstest(column, "norm").pvalue > 1e-4
    assert np.all(np.abs(values.var(axis=0) - 1) < 5 * np.sqrt(2 / DRAWS))
    between = np.corrcoef(values.T) - np.eye(11)
    assert np.max(np.abs(between)) < 5 / np.sqrt(DRAWS)
    serial = np.mean(values[1:] * values[:-1], axis=0)
    assert np.max(np.abs(serial)) < 5 / np.sqrt(DRAWS)
