"""Angles that go to and fro, and a case that turns."""

import numpy as np

from ins_eval.schedules.schedule import Sweep, turn_into_case
from pyhrg.common.units import DEG


def test_sweep_turns_back_after_its_span() -> None:
    since = np.array([0.0, 10.0, 20.0, 30.0, 40.0, 50.0])
    to_and_fro = Sweep(rate=-1.0 * DEG, span=20 * DEG, start=5 * DEG).angle(since)
    assert np.allclose(to_and_fro / DEG, [5, -5, -15, -5, 5, -5])
    assert np.allclose(Sweep(rate=2.0).angle(since), 2 * since)
    assert np.allclose(Sweep(start=0.3).angle(since), 0.3)


def test_components_along_a_turned_case() -> None:
    """A case that is turned to the right by 90 deg points its x axis to what was right; turned back
    the components are the old ones."""
    forward, right = np.eye(3)[:1], np.eye(3)[1:2]
    quarter = np.array([90 * DEG])
    assert np.allclose(turn_into_case(right, quarter), forward)
    assert np.allclose(turn_into_case(forward, quarter), -right)
    values, angle = np.random.default_rng(1).normal(size=(2, 5, 3))[0], np.arange(5.0)
    assert np.allclose(turn_into_case(turn_into_case(values, angle), -angle), values)
