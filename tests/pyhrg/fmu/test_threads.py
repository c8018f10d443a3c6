"""Work with one FMU shared among threads: in order, and stopped as one."""

import pytest

from pyhrg.fmu import GyroFmu


@pytest.mark.parametrize("workers", [1, 3])
def test_results_and_reports_come_in_the_items_order(slow_fmu: GyroFmu, workers: int) -> None:
    reported: list[int] = []
    squares = slow_fmu.map(lambda x: x * x, range(20), workers, reported.append)
    assert squares == [x * x for x in range(20)]
    assert reported == list(range(1, 21))
    assert slow_fmu.stop is None


def test_failure_stops_work_under_way(slow_fmu: GyroFmu) -> None:
    """The third item waits for the stop that the second one's failure must cause."""
    stopped: list[bool] = []

    def work(item: int) -> None:
        assert slow_fmu.stop is not None
        if item == 1:
            raise ValueError("the second")
        if item == 2:
            stopped.append(slow_fmu.stop.wait(10))

    with pytest.raises(ValueError, match="the second"):
        slow_fmu.map(work, range(3), workers=2)
    assert stopped == [True]
    assert slow_fmu.stop is None
