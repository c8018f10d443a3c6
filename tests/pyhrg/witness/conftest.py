"""Shared: sensitivities of one gyro, and estimates from flights of drifted ones."""

import numpy as np
import pytest

from pyhrg.fmu import GyroFmu
from pyhrg.witness.responses import Responses, measure_responses
from tests.pyhrg.witness.flights import GYRO


@pytest.fixture(scope="session")
def responses(slow_fmu: GyroFmu) -> Responses:
    return measure_responses(slow_fmu, GYRO)


@pytest.fixture
def generator() -> np.random.Generator:
    return np.random.default_rng(20261125)
