"""Every model of `HRG.Examples` runs as it is."""

import math

import pytest

from tests.modelica.models import Model, built, models

EXAMPLES = models("Examples")


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 3


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda e: e.name)
def test_example_runs_and_all_its_outputs_move(example: Model) -> None:
    with built(example) as fmu:
        fmu.power_on({})
        begin = fmu.read(fmu.outputs())
        fmu.advance(0.0, example.stop_time)
        end = fmu.read(fmu.outputs())
    assert len(end) >= 2
    assert all(map(math.isfinite, end))
    assert all(b != e for b, e in zip(begin, end, strict=True))
