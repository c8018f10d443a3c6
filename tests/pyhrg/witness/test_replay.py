"""Rows of a log as they are replayed."""

import numpy as np

from pyhrg.witness.replay import Witnesses, smooth_errors


def test_merged_rows_are_means_between_angles_at_their_ends() -> None:
    rows = np.arange(7.0)
    forces = np.stack([rows, -rows], axis=1)
    witnesses = Witnesses(0.1, np.arange(8.0), forces, rows, rows, np.tile(rows[:, None], 3))
    merged = witnesses.merge(3)
    assert np.isclose(merged.interval, 0.3)
    assert merged.angle.tolist() == [0.0, 3.0, 6.0]
    assert merged.forces.tolist() == [[1.0, -1.0], [4.0, -4.0]]
    assert merged.specific_force.tolist() == [[1.0] * 3, [4.0] * 3]


def test_rounds_of_the_temperature_converge_at_every_frequency() -> None:
    """A round leaves 1 - s of an error that is smoothed to s of itself."""
    smoothed = np.array([smooth_errors(each, 0.5) for each in np.eye(100)])
    shares = np.linalg.eigvals(smoothed)
    assert np.allclose(shares.imag, 0.0, atol=1e-9)
    assert shares.real.min() > -1e-9
    assert np.isclose(shares.real.max(), 1.0)
