"""What a log without the table's angle shows of the table."""

from pathlib import Path

import numpy as np
import pandas as pd

from pyhrg.records import read_log
from pyhrg.records.missing_inputs import find_turning_times, turns


def test_a_pattern_that_turns_by_itself_is_no_turn_of_the_table(tmp_path: Path) -> None:
    """A ring-down of 200 s in which the free pattern leaves the rate of any rest."""
    time = np.arange(1.0, 301.0)
    angle = 0.003 * time + 0.1 * np.clip(time - 100, 0, None)
    frame = pd.DataFrame({"time_s": time, "gyro_angle_deg": angle, "drive_on": 1})
    path = tmp_path / "log.csv"
    frame.to_csv(path, index=False)
    assert turns(read_log(path))
    assert find_turning_times(read_log(path))[0] == 104
    frame.assign(drive_on=(time <= 100).astype(int)).to_csv(path, index=False)
    assert not turns(read_log(path))
