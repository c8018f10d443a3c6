"""Ranking of sets."""

from pyhrg.gap.effects.catalogue import DETERMINISTIC
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.search import Ranking


def test_groups_come_in_the_order_of_their_sets() -> None:
    """The order must not depend on hashes, which differ from process to process."""
    a, b, *more = DETERMINISTIC
    orders = [(b, a), (b,), (a, *more)]
    fits = tuple(Fit(groups, 0.0, 0.0, (), ()) for groups in orders)
    assert Ranking(fits, (0.5, 0.3, 0.2), 0.0).groups == (b, a, *more)
