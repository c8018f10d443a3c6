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
API void seed_flickers(double seed, double *memory) { f_seededFlickers(seed, memory); }
API void flicker(const double *memory, const double *decays, double *next) {
  f_flickers(memory, decays, next);
}
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


@pytest.mark.parametrize("seed", [0, 2**31 - 1])
def test_flickers_have_generators_of_their_own(kernel: ctypes.CDLL, seed: int) -> None:
    """Lags that forget at once, one of each noise, hand over the deviates: uniform, of variance 1,
    independent of each other and of the electronics' noise; correlations within 5 sigma."""
    decays = np.zeros(16)
    decays[8] = 1.0
    memory, following = np.zeros(45), np.zeros(45)
    at, then, by = (ctypes.c_void_p(a.ctypes.data) for a in (memory, following, decays))
    kernel.seed_flickers(ctypes.c_double(seed), at)
    values = np.empty((DRAWS, 3))
    for row in values:
        kernel.flicker(at, by, then)
        memory[:] = following
        row[:] = memory[42:]
    for column in values.T:
        assert stats.kstest(column, "uniform", (-np.sqrt(3), 2 * np.sqrt(3))).pvalue > 1e-4
    between = np.corrcoef(np.hstack([values, draws(kernel, seed)]).T) - np.eye(14)
    assert np.max(np.abs(between)) < 5 / np.sqrt(DRAWS)
