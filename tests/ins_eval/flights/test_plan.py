"""Plans: rows of whole steps that fill the minute."""

import pytest

from ins_eval.flights.plan import count_row_increments


@pytest.mark.parametrize(
    ("rate", "samples", "spacing"),
    [(100, 2, 10.0), (100, 4, 10.0), (10, 3, 12.0), (2000, 2, 10.0), (100, 3, 12.0)],
)
def test_rows_fill_the_minute(rate: int, samples: int, spacing: float) -> None:
    found = count_row_increments(1 / rate, samples)
    assert found % samples == 0
    assert 60 * rate % found == 0
    assert found / rate == pytest.approx(spacing)


def test_rows_of_an_odd_interval_are_whole_steps() -> None:
    found = count_row_increments(0.0123, 4)
    assert found % 4 == 0
    assert found * 0.0123 == pytest.approx(10, abs=0.05)
