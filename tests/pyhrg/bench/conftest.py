"""Fixtures of bench tests."""

from tests.pyhrg.bench.cases import slow_fmu

__all__ = ["slow_fmu"]
