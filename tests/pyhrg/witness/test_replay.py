"""Rows of a log as they are replayed."""

import numpy as np

from pyhrg.witness.replay import Witnesses


def test_merged_rows_are_means_between_angles_at_their_ends() -> None:
    rows = np.arange(7.0)
    forces = np.stack([rows, -rows], axis=1)
    witnesses = Witnesses(0.1, np.arange(8.0), forces, rows, rows, np.tile(rows[:, None], 3))
    merged = witnesses.merge(3)
    assert np.isclose(merged.interval, 0.3)
    assert merged.angle.tolist() == [0.0, 3.0, 6.0]
    assert merged.forces.tolist() == [[1.0, -1.0], [4.0, -4.0]]
    assert merged.specific_force.tolist() == [[1.0] * 3, [4.0] * 3]
