"""Work shared among threads: in order, and stopped as one."""

import threading

import pytest

from ins_eval.parking.study import map_in_threads


@pytest.mark.parametrize("workers", [1, 3, None])
def test_results_and_reports_come_in_the_items_order(workers: int | None) -> None:
    reported: list[int] = []
    squares = map_in_threads(
        lambda x: x * x, range(20), threading.Event(), workers, reported.append
    )
    assert squares == [x * x for x in range(20)]
    assert reported == list(range(1, 21))


def test_failure_stops_work_under_way() -> None:
    """The first item waits for the stop that the second one's failure must cause."""
    stop = threading.Event()

    def work(item: int) -> bool:
        if item == 1:
            raise ValueError("the second")
        return item == 0 or stop.wait(10)

    with pytest.raises(ValueError, match="the second"):
        map_in_threads(work, range(4), stop, workers=2)
    assert stop.is_set()
