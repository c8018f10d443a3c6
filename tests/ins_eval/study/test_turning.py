"""Weights of steady turning are those of the same motion as a mission."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.mission_model.mission_weights import compute_mission_weights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.study import phase_diagram
from pyhrg.common.units import DEG, MINUTE

TABLE_RATE = 0.5
"""Rate of the table, deg/s."""
MISSION = f"""\
start = {{ latitude_deg = 40, longitude_deg = 0, height_m = 0, heading_deg = 0 }}
course = [{{ kind = "turntable", turn_deg = 200, rate_deg_s = {TABLE_RATE}, ramp_s = 0.1 }}]
"""


def test_weights_are_those_of_the_mission_on_a_turntable(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Within 0.1 % of the largest: the mission's table takes a tenth of a second to start."""
    (tmp_path / "table.toml").write_text(MISSION)
    mission = compute_mission_weights(plan_mission(tmp_path / "table.toml", 0.1))
    monkeypatch.setattr(phase_diagram, "DURATION", 6 * MINUTE)
    found = phase_diagram.compute_turning_weights(ANGULAR_GAIN * TABLE_RATE * DEG)
    for own, its in (
        (found.maps[0], mission.gyros[-1]),
        (found.noise, mission.noise[..., -2:, -2:]),
    ):
        np.testing.assert_allclose(own, its, atol=1e-3 * np.abs(its).max())
