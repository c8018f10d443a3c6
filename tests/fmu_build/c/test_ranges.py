"""A value out of range is discarded, not an error; one that is so by a rounding is taken."""

import math
from collections.abc import Iterator
from pathlib import Path

import pytest
from fmpy.fmi1 import FMICallException

from tests.fmu_build.importer import Importer

DISCARD = 2
"""Status of a discarded call in both standards."""


@pytest.fixture
def gyro(folder: Path) -> Iterator[Importer]:
    importer = Importer(folder).begin({})
    yield importer
    importer.free()


@pytest.mark.parametrize("value", [1000.0, 100.0 * (1 + 1e-12), math.nan])
def test_a_value_out_of_range_leaves_the_simulation_as_it_was(gyro: Importer, value: float) -> None:
    gyro.set({"angularRate": 0.5})
    before = gyro.save()
    with pytest.raises(FMICallException) as raised:
        gyro.set({"angularRate": value})
    assert raised.value.status == DISCARD
    category, text = gyro.messages[-1]
    assert category == "logStatusDiscard"
    assert text.endswith("is outside its range from -100 to 100")
    assert gyro.save() == before
    gyro.slave.doStep(0.0, 0.1)
    assert gyro.get(["gyroAngle"])[0] == pytest.approx(0.05, rel=1e-3)


def test_what_can_not_be_set_at_all_is_an_error(gyro: Importer) -> None:
    gyro.refused(lambda: gyro.set({"gyroAngle": 0.0}))
    assert gyro.messages[-1][0] == "logStatusError"


@pytest.mark.parametrize(
    ("name", "value", "taken"),
    [
        ("angularRate", 100.0 * (1 + 2**-51), 100.0),
        ("biasVoltage", 0.3 - 0.1 * 3, 0.0),
        ("biasVoltage", 10.000000000000004, 10.0),
    ],
)
def test_a_rounding_beyond_the_range_is_its_end(
    gyro: Importer, name: str, value: float, taken: float
) -> None:
    gyro.set({name: value})
    assert gyro.get([name]) == [taken]
    gyro.restore(gyro.save())
