"""Checks of numeric arguments."""

import pytest

from pyhrg.common.arguments import MOST_WORKERS, choose_workers
from pyhrg.common.errors import HrgError


@pytest.mark.parametrize("workers", [0, -1, MOST_WORKERS + 1, 2**63, 1.5, True, "2"])
def test_a_number_of_workers_is_one_of_a_machine(workers: object) -> None:
    with pytest.raises(HrgError, match=f"expected a whole number from 1 to {MOST_WORKERS}"):
        choose_workers(workers)  # type: ignore[arg-type]
