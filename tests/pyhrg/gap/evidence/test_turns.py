"""Sets that are taken in turn are noticed; a first set, a kept one and a far step are not turns."""

import pytest

from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.evidence.rounds.turns import Turns

A: tuple[Group, ...] = (EFFECTS["loop_delay"],)
B: tuple[Group, ...] = (EFFECTS["filter_delay"],)
C: tuple[Group, ...] = (*A, *B)


@pytest.mark.parametrize(
    ("sets", "lengths", "turns"),
    [
        ([A, B, A, B], [140, 141, 140, 141], [False, False, True, True]),
        ([A, B, C, A], [336, 456, 385, 337], [False, False, False, True]),
        ([A, A, A], [5000, 300, 100], [False, False, False]),
        ([A, B, C], [5000, 300, 100], [False, False, False]),
        ([A, B, A], [5000, 181, 77000], [False, False, False]),
    ],
)
def test_turns(sets: list[tuple[Group, ...]], lengths: list[float], turns: list[bool]) -> None:
    own = Turns()
    assert [own.take(*pair) for pair in zip(sets, lengths, strict=True)] == turns
