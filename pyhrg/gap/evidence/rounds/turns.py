"""Sets that explain as much with different effects, and are taken in turn."""

from pyhrg.gap.effects.linear_test import Group

ERROR_DECAY = 4.0
"""Factor by which the allowed linearization error falls where sets that explain as much are taken
in turn, each after the long step from another. Chosen."""
LONG_STEP_RATIO = 4.0
"""Ratio of a step's length to that of the step before above which it is far longer. Chosen."""


class Turns:
    """The best sets of the rounds so far, and the length of the last step, in sigma."""

    def __init__(self) -> None:
        self._sets: list[tuple[Group, ...]] = []
        self._last_length = 0.0

    def take(self, groups: tuple[Group, ...], length: float) -> bool:
        """Note the best set of a round and the length of its step; whether this set was the best
        one before, others came between, and the step is about as long as the last one. After a far
        longer one the equations are not linear (docs/methods/evidence.md, Eq. 10)."""
        returns = groups in self._sets[:-1] and groups != self._sets[-1]
        is_comparable = length < LONG_STEP_RATIO * self._last_length
        self._sets.append(groups)
        self._last_length = length
        return returns and is_comparable
