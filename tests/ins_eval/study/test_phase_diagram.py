"""The phase diagram says where each test is right: noise decides, then the map."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study import phase_diagram
from ins_eval.study.phase_diagram import CIRCUMFERENCE, FIXED, MAP, RATIOS, TURNING
from ins_eval.study.predictors.parts.map_drift import NO_DRIFT


@pytest.fixture(scope="module")
def rows(triads: TriadBlock) -> pd.DataFrame:
    return pd.DataFrame(phase_diagram.compute_phase_diagram(triads, NO_DRIFT, seed=1))


def test_fixed_position_is_right_in_noise_and_the_map_above_it(rows: pd.DataFrame) -> None:
    shares = rows.pivot_table("share", "test", "map_over_noise")
    assert len(rows) == 3 * len(TURNING) * len(RATIOS)
    lowest, highest = RATIOS[0], RATIOS[-1]
    assert shares.loc[FIXED, lowest] > 0.5 > 0.1 > shares.loc[FIXED, highest]
    assert shares.loc[MAP, highest] > 0.9 > 0.6 > shares.loc[MAP, lowest]
    assert 0.3 < shares.loc[CIRCUMFERENCE, highest] < 0.7
    assert (rows["low"] <= rows["share"]).all()
    assert (rows["share"] <= rows["high"]).all()


def test_table_has_a_row_for_each_cell(rows: pd.DataFrame, tmp_path: Path) -> None:
    phase_diagram.write_rows(rows.to_dict("records"), tmp_path / "phase.csv")
    read = pd.read_csv(tmp_path / "phase.csv")
    assert list(read) == list(phase_diagram.COLUMNS)
    np.testing.assert_allclose(read["share"], rows["share"], rtol=1e-5)


def test_turning_of_a_table_is_its_turns(tmp_path: Path) -> None:
    """360 deg in six minutes, and 1.5 deg of the Earth at most: 2.77 of the pattern an hour."""
    path = tmp_path / "table.toml"
    path.write_text(
        "start = { latitude_deg = 40, longitude_deg = 0, height_m = 0, heading_deg = 0 }\n"
        'course = [{ kind = "turntable", turn_deg = 360, rate_deg_s = 1, ramp_s = 1 }]\n'
    )
    assert phase_diagram.compute_turning(plan_mission(path, 0.1)) == pytest.approx(2.77, rel=5e-3)
