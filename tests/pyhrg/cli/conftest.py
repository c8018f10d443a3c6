"""Short tests in the place of the real ones, and their results."""

from pathlib import Path

import pytest

from pyhrg.bench import catalogue
from tests.pyhrg.bench.quick import PROCEDURES
from tests.pyhrg.cli.bench_runs import hrg


@pytest.fixture
def short_tests(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalogue, "PROCEDURES", PROCEDURES)


@pytest.fixture(scope="session")
def done(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results of all tests."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(catalogue, "PROCEDURES", PROCEDURES)
        out = tmp_path_factory.mktemp("bench") / "all"
        assert hrg("all", "--out", out, "--seed", 7, "--workers", 1) == 0
    return out
