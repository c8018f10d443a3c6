"""Figures of the paper, computed once."""

import pytest

from pyhrg.paper import document


@pytest.fixture(scope="session")
def values() -> dict[str, float]:
    return document.figures()
