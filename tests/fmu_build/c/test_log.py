"""Log categories: declared, chosen, and unknown ones refused by name."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.fmu_build.importer import Importer


@pytest.fixture
def gyro(folder: Path) -> Iterator[Importer]:
    importer = Importer(folder)
    yield importer
    importer.free()


def _heard(gyro: Importer) -> set[str]:
    """Categories of what is told about a refused call and a reset."""
    gyro.messages.clear()
    with pytest.raises(Exception, match="DoStep"):
        gyro.slave.doStep(0.0, 0.1)
    gyro.slave.reset()
    return {category for category, _ in gyro.messages}


def test_errors_are_told_without_debug_logging(gyro: Importer) -> None:
    assert _heard(gyro) == {"logStatusError"}


def test_events_are_told_with_it(folder: Path) -> None:
    gyro = Importer(folder, logging=True)
    gyro.begin({}, start=2.0)
    gyro.slave.doStep(2.0, 0.5)
    gyro.restore(gyro.save())
    gyro.slave.terminate()
    assert gyro.messages == [
        ("logEvents", "initialized at 2 s"),
        ("logEvents", "state restored at 2.5 s"),
        ("logEvents", "terminated at 2.5 s"),
    ]
    gyro.free()


@pytest.mark.parametrize(
    ("on", "chosen", "heard"),
    [
        (True, [], {"logStatusError", "logEvents"}),
        (True, ["logStatusDiscard"], set()),
        (True, ["logEvents"], {"logEvents"}),
        (True, ["logStatusError"], {"logStatusError"}),
        (False, [], set()),
    ],
)
def test_chosen_categories_are_told_alone(
    gyro: Importer, on: bool, chosen: list[str], heard: set[str]
) -> None:
    gyro.slave.setDebugLogging(on, chosen)
    assert _heard(gyro) == heard


def test_unknown_category_is_refused_by_name_and_changes_nothing(gyro: Importer) -> None:
    text = gyro.refused(lambda: gyro.slave.setDebugLogging(True, ["logEvents", "logNonsense"]))
    assert text == "there is no log category logNonsense"
    assert _heard(gyro) == {"logStatusError"}


def test_description_lists_what_is_told(gyro: Importer) -> None:
    text = (Path(gyro.slave.unzipDirectory) / "modelDescription.xml").read_text()
    assert 'Category name="logStatusError"' in text
    assert 'Category name="logStatusDiscard"' in text
    assert 'Category name="logEvents"' in text


NAN = float("nan")


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({"seed": -1}, "seed = -1 is outside its range from 0 to 2147483647"),
        ({"startAmplitude": 10.1}, "startAmplitude = 10.1 is outside its range from 1e-06 to 10"),
        ({"startAngle": NAN}, "startAngle = nan is outside its range from -1000 to 1000"),
    ],
)
def test_numbers_read_as_they_are_written(
    gyro: Importer, values: dict[str, float], text: str
) -> None:
    assert gyro.refused(lambda: gyro.set(values)) == text


def test_steps_are_refused_with_their_range(gyro: Importer) -> None:
    gyro.begin({})
    text = gyro.refused(lambda: gyro.slave.doStep(0.0, 0.0))
    assert text == "the step 0 is outside its range: above 0, up to 10000000"
    text = gyro.refused(lambda: gyro.slave.doStep(0.005, 0.1))
    assert text == "the step begins at 0.005, expected 0"
    gyro.slave.doStep(0.0, 0.1 + 0.2)
    text = gyro.refused(lambda: gyro.slave.doStep(0.0, 0.1))
    assert text == "the step begins at 0, expected 0.30000000000000004"
